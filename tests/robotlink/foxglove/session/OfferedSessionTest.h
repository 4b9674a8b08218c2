// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>

#include <deque>
#include <nlohmann/json.hpp>

#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/server/ServedClient.h"
#include "robotlink/foxglove/session/SessionServer.h"

namespace robotlink::websocket::test {

using namespace std::chrono_literals;
using robotcontrol::Request;
using robotcontrol::RequestResult;

/// A session with one robot; requests to it are kept, and accepted unless `refusal_` says why not.
class OfferedSessionTest : public testing::Test {
 protected:
  OfferedSessionTest() {
    session_.setRobots({"red1"});
    session_.setRequestSink([this](const Request& request) {
      requests_.push_back(request);
      RequestResult result;
      result.set_id(request.id());
      result.set_accepted(refusal_.empty());
      result.set_reason(refusal_);
      session_.pushResult(result);
    });
    ServerOptions options;
    options.clock = clock_;
    server_ = std::make_unique<SessionServer>(session_, options);
    client_ = *server_->server()->connect({0, "127.0.0.1:1", "x"}, [] {});
  }
  /// When it ends it makes requests, which are kept here.
  ~OfferedSessionTest() override { server_.reset(); }
  template <typename Message>
  void publish(const std::string& path, Instant time, const Message& message = {}) {
    session_.push({path, time, std::make_shared<Message>(message)});
  }
  void publishTables() {
    robotcontrol::KeyTable keys;
    const auto addKey = [&](const std::string& name, const std::string& stream) {
      keys.add_keys()->set_name(name);
      keys.mutable_keys()->rbegin()->set_stream(stream);
    };
    addKey("ball-percept/disc", "drawings/image/ball-percept/disc");
    addKey("package/camera/image", "camera/image");
    robotcontrol::ProcessTable processes;
    auto& process = *processes.add_processes();
    process.set_name("cognition");
    process.add_receivers()->set_package("camera/image");
    process.mutable_receivers(0)->set_type("foxglove.RawImage");
    robotcontrol::SolutionTable solutions;
    solutions.add_tasks()->set_name("ball-percept");
    solutions.mutable_tasks(0)->set_active("scan-lines");
    publish("red1/tables/processes", Instant(1ms), processes);
    publish("red1/tables/keys", Instant(1ms), keys);
    publish("red1/tables/solutions", Instant(1ms), solutions);
    tick();
  }
  /// Requests are answered by one tick, and the answers handled by the next.
  void tick() {
    for (int i = 0; i < 2; ++i) {
      session_.tick();
      server_->tick();
    }
    session_.tick();
  }
  void say(const ClientMessage& message) {
    const Frame frame = encode(message);
    server_->server()->received(client_, frame.kind, frame.bytes);
    tick();
  }
  /// The messages of a type since the last call; payloads refer to the frames, which are kept.
  template <typename Message>
  std::vector<Message> heard() {
    std::vector<Message> found;
    while (const auto next = server_->server()->next(*client_, Instant())) {
      std::string& bytes =
          kept_.emplace_back(reinterpret_cast<const char*>(next->head.data()), next->headSize);
      bytes += *next->payload;
      const ServerMessage message = decodeServerMessage(next->kind, bytes).value();
      if (const auto* one = std::get_if<Message>(&message)) found.push_back(*one);
    }
    return found;
  }
  /// What was advertised since the last hearing, by topic.
  std::map<std::string, Channel> advertised() {
    std::map<std::string, Channel> channels;
    for (const Advertise& message : heard<Advertise>())
      for (const Channel& channel : message.channels) channels[channel.topic] = channel;
    return channels;
  }

  /// Names of services to their ids.
  std::map<std::string, std::uint32_t> services() {
    std::map<std::string, std::uint32_t> ids;
    for (const AdvertiseServices& message : heard<AdvertiseServices>())
      for (const Service& service : message.services) ids[service.name] = service.id;
    return ids;
  }
  /// What a service answers a client: the reason of a refusal, or nothing.
  std::string call(const ClientPtr& client, std::uint32_t service, const std::string& argument) {
    const Frame frame = encode(ClientMessage(ServiceCallRequest{service, 9, "json", argument}));
    server_->server()->received(client, frame.kind, frame.bytes);
    tick();
    std::string reason = "no answer";
    while (const auto next = server_->server()->next(*client, Instant())) {
      // Payloads refer to it.
      const std::string bytes =
          std::string(reinterpret_cast<const char*>(next->head.data()), next->headSize) + *next->payload;
      const ServerMessage message = decodeServerMessage(next->kind, bytes).value();
      if (const auto* answer = std::get_if<ServiceCallResponse>(&message))
        reason = nlohmann::json::parse(answer->payload)["reason"];
      if (const auto* failure = std::get_if<ServiceCallFailure>(&message)) reason = failure->message;
    }
    return reason;
  }
  std::vector<std::string> asked() {
    std::vector<std::string> words;
    for (const Request& request : std::exchange(requests_, {}))
      words.push_back(Request::descriptor()->FindFieldByNumber(request.what_case())->name() +
                      (request.has_motion() ? " " + std::to_string(request.motion().motion().kind()) : ""));
    return words;
  }
  const robotcontrol::SteeringStatus* steering() {
    return session_.store().latestAs<robotcontrol::SteeringStatus>("red1/steering", Instant::max());
  }

  const std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
  Session session_;
  std::unique_ptr<SessionServer> server_;
  ClientPtr client_;
  std::vector<Request> requests_;
  std::string refusal_;
  std::deque<std::string> kept_;
};

}  // namespace robotlink::websocket::test
