// SPDX-License-Identifier: GPL-3.0-or-later
// Conversations of two clients, one of which may only watch, with a server of a session: each message has a
// byte for client and kind, and two for its length.
#include <cstdio>
#include <cstdlib>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/ByteReader.h"
#include "robotlink/foxglove/server/ServedClient.h"
#include "robotlink/foxglove/session/SessionServer.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/foxglove/Samples.h"

using namespace robotlink;
using namespace robotlink::websocket;
using robotcontrol::Request;

namespace {

void demand(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::abort();
}

template <typename Message>
void publish(Session& session, const std::string& path, const Message& message) {
  session.push({path, Instant(Duration(1)), std::make_shared<Message>(message)});
}

/// A robot with a key, a solution with parameters, and those.
void publishTables(Session& session) {
  robotcontrol::KeyTable keys;
  keys.add_keys()->set_name("k");
  keys.mutable_keys(0)->set_stream("plots/k");
  robotcontrol::SolutionTable solutions;
  solutions.add_tasks()->set_name("t");
  solutions.mutable_tasks(0)->set_active("s");
  solutions.mutable_tasks(0)->add_solutions()->set_name("s");
  solutions.mutable_tasks(0)->mutable_solutions(0)->set_has_parameters(true);
  robotcontrol::ParameterValues values;
  values.set_task("t");
  values.set_solution("s");
  values.mutable_value()->set_type("robotcontrol.DriveState");
  publish(session, "r/tables/keys", keys);
  publish(session, "r/tables/solutions", solutions);
  publish(session, "r/parameters/t/s", values);
}

std::string frameOf(std::uint8_t head, const ClientMessage& message) {
  const Frame frame = encode(message);
  const std::uint8_t kind = frame.kind == FrameKind::kText ? 2 : 0;
  return std::string{static_cast<char>(head | kind), static_cast<char>(frame.bytes.size() & 255U),
                     static_cast<char>(frame.bytes.size() >> 8U)} +
         frame.bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Session session;
  session.setRobots({"r"});
  bool isWatcherAlone = false;
  session.setRequestSink([&](const Request& request) {
    const bool isHarmless = request.has_get_parameters() || request.has_send_tables() ||
                            request.has_set_key() || (request.has_stop() && request.stop().engaged());
    demand(isHarmless || !isWatcherAlone, "who only watches changes nothing");
    robotcontrol::RequestResult result;
    result.set_id(request.id());
    result.set_accepted(request.id() % 3 != 0);
    session.pushResult(result);
  });
  const auto clock = std::make_shared<ManualClock>();
  ServerOptions options;
  options.sessionId = "s";
  options.clock = clock;
  auto server = std::make_unique<SessionServer>(session, options);
  publishTables(session);
  const ClientPtr clients[] = {server->server()->connect({0, "1:1", "a"}, [] {}).value(),
                               server->server()->connect({0, "2:2", "b", true}, [] {}).value()};
  const auto tick = [&] {
    for (int i = 0; i < 2; ++i) session.tick(), server->tick();
  };
  tick();
  ByteReader reader(std::span(data, size));
  isWatcherAlone = size > 0 && (data[0] & 64U) != 0;
  while (reader.good() && !reader.rest().empty()) {
    const auto head = reader.take<std::uint8_t>();
    const auto bytes = reader.take(reader.take<std::uint16_t>() % 2048U);
    const ClientPtr& client = clients[isWatcherAlone ? 1 : head & 1U];
    server->server()->received(client, (head & 2U) != 0 ? FrameKind::kText : FrameKind::kBinary,
                               {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    clock->advance(std::chrono::milliseconds(head));
    if ((head & 4U) != 0) tick();
    if ((head & 8U) != 0) session.setRobots({}), tick(), session.setRobots({"r"});
    if ((head & 16U) != 0) publishTables(session);
    if ((head & 32U) != 0) server->server()->disconnected(client);
    while (server->server()->next(*client, Instant())) {
    }
  }
  tick();
  isWatcherAlone = false;
  server.reset();
  session.tick();
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds;
  const ClientMessage advertise = ClientAdvertise{{{1, "r/remote/drive", "json", "", "", ""},
                                                   {2, "r/remote/motion", "protobuf", "", "", ""},
                                                   {3, "r/remote/goal", "json", "", "", ""}}};
  std::string talk = frameOf(4, advertise);
  talk += frameOf(4, ClientMessageData{1, R"({"velocity": {"x": 0.2}})"});
  talk += frameOf(4, ClientMessageData{2, std::string("\x12\x02\x08\x01", 4)});
  talk += frameOf(4, ClientMessageData{3, R"({"pose_in_field": {"x": 1}})"});
  for (std::uint32_t service = 1; service < 24; ++service)
    talk += frameOf(4, ServiceCallRequest{service, service, "json", "{}"});
  talk += frameOf(
      20, SetParameters{
              {{"r/parameters/t/s/battery", Value{3.0}}, {"r/keys/k", Value{std::string("always")}}}, "x"});
  talk += frameOf(12, Subscribe{{{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}}});
  seeds.push_back(talk + frameOf(36, Unsubscribe{{1}}));
  talk[0] = static_cast<char>(talk[0] | 64);
  seeds.push_back(talk);
  for (const auto& sample : websocket::test::clientSamples())
    seeds.push_back(std::string{sample.wire.starts_with('{') ? '\x06' : '\x04',
                                static_cast<char>(sample.wire.size() & 255U),
                                static_cast<char>(sample.wire.size() >> 8U)} +
                    sample.wire);
  return seeds;
}
