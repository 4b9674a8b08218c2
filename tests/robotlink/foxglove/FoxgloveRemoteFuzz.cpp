// SPDX-License-Identifier: GPL-3.0-or-later
// What a server says about its robots, which are put into a session that is offered to another client in
// turn: a byte for the circumstances; then each message has a byte for its kind and for what happens after
// it, and two for its length.
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Utf8.h"
#include "robotlink/foxglove/server/ServedClient.h"
#include "robotlink/foxglove/session/LinkNames.h"
#include "robotlink/foxglove/session/SessionServer.h"
#include "robotlink/foxglove/session/remote/RemoteSession.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/foxglove/FuzzedConversation.h"
#include "tests/robotlink/foxglove/Samples.h"

namespace foxglove_remote_fuzz {

using namespace robotlink;
using namespace robotlink::websocket;
using namespace robotlink::websocket::test;
using robotcontrol::Request;

namespace {

/// A session with the robots of one server, and the requests that were made of them.
class FuzzedSession {
 public:
  explicit FuzzedSession(std::uint8_t circumstances) : leads_((circumstances & 1U) == 0) {
    SessionClientOptions options;
    options.connection.clock = clock;
    options.connection.url = {false, "127.0.0.1", 1, "/"};
    if ((circumstances & 2U) != 0) options.isTaken = [](const std::string& name) { return name == "red1"; };
    if (!leads_) options.leadingTime = [this] { return std::optional(lead); };
    if ((circumstances & 4U) != 0) options.alsoWanted = [](const std::string&) { return true; };
    options.passed = [this](const StreamMessage& message) { check(message); };
    remote = std::make_unique<RemoteSession>(session, std::move(options));
    if ((circumstances & 8U) != 0) remote->images = RemoteImages::kJpeg;
    session.setRequestSink([this](const Request& request) {
      auto* robot = remote->robots.findLocal(request.robot());
      if (robot != nullptr && request.has_set_key()) return remote->setKey(*robot, request);
      remote->forward(robot != nullptr ? robot->remote : request.robot(), request);
    });
    if ((circumstances & 16U) != 0) offer();
    remote->client->opened();
  }
  ~FuzzedSession() { server_.reset(); }
  FuzzedSession(const FuzzedSession&) = delete;
  FuzzedSession& operator=(const FuzzedSession&) = delete;

  bool hear(FrameKind kind, std::string_view bytes) {
    return remote->client->received(kind, bytes).has_value();
  }
  void cut() {
    remote->client->lost();
    remote->client->opened();
  }
  void ask(Request request) {
    if (!remote->robots.names().empty()) request.set_robot(remote->robots.names().front());
    ++asked_;
    session.request(std::move(request), [this](const auto& result) {
      ++answered_;
      demand(validUtf8(result.reason()) == result.reason(), "reasons can be read");
    });
  }
  void tick() {
    remote->client->tick();
    remote->tick();
    session.setRobots(remote->robots.names());
    session.tick();
    if (server_) serve();
    while (remote->client->next()) {
    }
    for (const std::string& name : remote->robots.names())
      demand(!name.empty() && validUtf8(name) == name && name.find('/') == std::string::npos,
             "names of robots are parts of paths");
  }
  /// Everything that was asked for is answered when its time is over.
  void end() {
    cut();
    clock->advance(std::chrono::hours(1));
    tick();
    tick();
    demand(asked_ == answered_, "each request is answered once");
  }

  const std::shared_ptr<ManualClock> clock = std::make_shared<ManualClock>();
  Instant lead{std::chrono::seconds(1000)};
  Session session;
  std::unique_ptr<RemoteSession> remote;

 private:
  /// Another client subscribes to all that there is.
  void offer() {
    ServerOptions options;
    options.sessionId = "s";
    options.clock = clock;
    server_ = std::make_unique<SessionServer>(session, options);
    watcher_ = server_->server()->connect({0, "1:1", "a", true}, [] {}).value();
  }
  void serve() {
    server_->tick();
    Subscribe all;
    while (const auto next = server_->server()->next(*watcher_, Instant())) {
      // Nothing else is read here; the services alone are many.
      if (!next->payload->starts_with(R"({"channels")")) continue;
      const auto message = decodeServerMessage(next->kind, *next->payload);
      const auto* advertised = message ? std::get_if<Advertise>(&*message) : nullptr;
      if (advertised == nullptr) continue;
      for (const Channel& channel : advertised->channels)
        all.subscriptions.push_back({++subscriptions_, channel.id});
    }
    const Frame frame = encode(ClientMessage(all));
    server_->server()->received(watcher_, frame.kind, frame.bytes);
  }
  void check(const StreamMessage& message) {
    demand(message.value != nullptr && !message.path.empty(), "messages have contents and a path");
    demand(message.time >= Instant(), "no time is before zero");
    demand(leads_ || message.time <= lead + TimeShift::kMaxDistance,
           "no other machine's clock moves the session's time");
  }

  const bool leads_;
  std::unique_ptr<SessionServer> server_;
  ClientPtr watcher_;
  std::uint32_t subscriptions_ = 0;
  int asked_ = 0, answered_ = 0;
};

Request keyRequest(bool isOn) {
  Request request;
  request.mutable_set_key()->set_name(isOn ? "k" : "channel/camera");
  request.mutable_set_key()->mutable_mode()->set_kind(isOn ? robotcontrol::KeyMode::ALWAYS
                                                           : robotcontrol::KeyMode::OFF);
  return request;
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  ByteReader reader(std::span(data, size));
  FuzzedSession fuzzed(reader.take<std::uint8_t>());
  while (const auto message = nextMessage(reader, 8192)) {
    const bool heard = fuzzed.hear(message->kind, message->bytes);
    if (message->has(4)) fuzzed.clock->advance(std::chrono::seconds(1));
    if (message->has(8)) fuzzed.ask(keyRequest(message->has(1)));
    if (message->has(16)) fuzzed.session.restart();
    if (message->has(32)) fuzzed.lead += std::chrono::milliseconds(300);
    if (message->has(64)) {
      Request stop;
      stop.mutable_stop()->set_engaged(true);
      fuzzed.ask(stop);
    }
    if (!heard || message->has(128)) fuzzed.cut();
    fuzzed.tick();
  }
  fuzzed.end();
  return 0;
}

namespace {

template <typename Message>
std::string sent(std::uint32_t subscription, std::int64_t time, const Message& message) {
  return encode(
             ServerMessage(MessageData{subscription, Instant(Duration(time)), message.SerializeAsString()}))
      .bytes;
}

std::string greeting(const std::string& session, bool isOurs) {
  ServerInfo info{"s", {"parameters", "parametersSubscribe", "connectionGraph"}, {}, {}, session, {}, {}};
  if (isOurs) info.metadata = {{kSessionKey, "1"}};
  return framed(info, 0);
}

/// A robot with tables, who steers it, and a key that is on for somebody else.
std::string ourRobot(std::int64_t time) {
  robotcontrol::KeyTable keys;
  keys.add_keys()->set_name("k");
  keys.mutable_keys(0)->set_stream("camera/image");
  robotcontrol::SolutionTable solutions;
  solutions.add_tasks()->set_name("t");
  robotcontrol::ProcessTable processes;
  processes.add_processes()->set_name("p");
  processes.mutable_processes(0)->add_senders()->set_package("camera/image");
  processes.mutable_processes(0)->mutable_senders(0)->set_type("foxglove.RawImage");
  robotcontrol::SteeringStatus steering;
  steering.set_client(7);
  foxglove::Log text;
  text.set_name("p/t");
  Advertise channels;
  std::uint64_t id = 0;
  const auto add = [&](const char* topic, const std::string& type) {
    channels.channels.push_back({++id, topic, "protobuf", type, "", "protobuf"});
  };
  add("red1/tables/keys", keys.GetTypeName());
  add("red1/tables/solutions", solutions.GetTypeName());
  add("red1/tables/processes", processes.GetTypeName());
  add("red1/steering", steering.GetTypeName());
  add("red1/log", text.GetTypeName());
  add("red1/camera/image", "foxglove.RawImage");
  add("red1/camera/image/jpeg", "foxglove.CompressedImage");
  add("scene", "foxglove.SceneUpdate");
  std::string talk = framed(channels, 4);
  const AdvertiseServices services{{{1, "red1/set_key", "S", {}, {}}, {2, "red1/stop", "S", {}, {}}}};
  talk += framed(services, 4);
  const ParameterValues parameters{
      {{"red1/on-demand/k", Value{std::string("x")}}, {"link/client", Value{std::int64_t{7}}}}, ""};
  talk += framed(parameters, 32);
  // Subscriptions have numbers from 1, in the order of the channels.
  talk += framed(sent(1, time, keys), 0);
  talk += framed(sent(2, time, solutions), 9);
  talk += framed(sent(3, time, processes), 0);
  talk += framed(sent(4, time, steering), 64);
  return talk + framed(sent(5, time + 1, text), 16);
}

std::string foreignRobot() {
  const Advertise channels{{{1, "/battery", "json", "B",
                             R"({"type":"object","properties":{"volts":{"type":"number"}}})", "jsonschema"},
                            {2, "/camera", "protobuf", "foxglove.RawImage", "", "protobuf"},
                            {3, "/tables/keys", "json", "", "", ""}}};
  std::string talk = framed(channels, 8);
  for (std::uint32_t id = 1; id < 4; ++id)
    talk += framed(MessageData{id, Instant(std::chrono::seconds(id)), R"({"volts":11.5})"}, 9);
  return talk;
}

}  // namespace

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds;
  for (const char circumstances : {'\0', '\x10', '\x13', '\x0c'}) {
    const std::string first(1, circumstances);
    const std::string cut = framed("{}", 128);
    seeds.push_back(first + greeting("1", true) + ourRobot(5'000'000'000));
    seeds.push_back(seeds.back() + cut + greeting("2", true) + ourRobot(1'000'000'000));
    seeds.push_back(first + greeting("1", false) + foreignRobot());
    seeds.push_back(seeds.back() + cut + greeting("1", true) + ourRobot(INT64_MAX - 1));
  }
  std::string all = std::string("\x14") + greeting("1", true);
  for (const auto& sample : serverSamples()) all += framed(sample.wire, 4);
  seeds.push_back(all);
  return seeds;
}

const FuzzRegistration kTarget({"foxglove_remote", &fuzzSeeds, &runInput});

}  // namespace foxglove_remote_fuzz
