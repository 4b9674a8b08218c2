// SPDX-License-Identifier: GPL-3.0-or-later
// Conversations of two clients, one of which may only watch, with a server of a session: each message has a
// byte for client and kind, and two for its length.
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/foxglove/server/ServedClient.h"
#include "robotlink/foxglove/session/SessionServer.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/foxglove/FuzzedConversation.h"
#include "tests/robotlink/foxglove/Samples.h"

namespace foxglove_session_fuzz {

using namespace robotlink;
using namespace robotlink::websocket;
using namespace robotlink::websocket::test;
using robotcontrol::Request;

namespace {

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

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  Session session;
  session.setRobots({"r"});
  bool isWatcherAlone = false;
  session.setRequestSink([&](const Request& request) {
    const bool isHarmless = request.has_get_parameters() || request.has_send_tables() ||
                            request.has_set_key() || engagesStop(request);
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
  while (const auto message = nextMessage(reader, 2048)) {
    const ClientPtr& client = clients[isWatcherAlone ? 1 : message->head & 1U];
    server->server()->received(client, message->kind, message->bytes);
    clock->advance(std::chrono::milliseconds(message->head));
    if (message->has(4)) tick();
    if (message->has(8)) session.setRobots({}), tick(), session.setRobots({"r"});
    if (message->has(16)) publishTables(session);
    if (message->has(32)) server->server()->disconnected(client);
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
  std::string talk = framed(advertise, 4);
  talk += framed(ClientMessageData{1, R"({"velocity": {"x": 0.2}})"}, 4);
  talk += framed(ClientMessageData{2, std::string("\x12\x02\x08\x01", 4)}, 4);
  talk += framed(ClientMessageData{3, R"({"pose_in_field": {"x": 1}})"}, 4);
  for (std::uint32_t service = 1; service < 24; ++service)
    talk += framed(ServiceCallRequest{service, service, "json", "{}"}, 4);
  talk += framed(
      SetParameters{{{"r/parameters/t/s/battery", Value{3.0}}, {"r/keys/k", Value{std::string("always")}}},
                    "x"},
      20);
  talk += framed(Subscribe{{{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}}}, 12);
  seeds.push_back(talk + framed(Unsubscribe{{1}}, 36));
  talk[0] = static_cast<char>(talk[0] | 64);
  seeds.push_back(talk);
  for (const auto& sample : clientSamples()) seeds.push_back(framed(sample.wire, 4));
  return seeds;
}

const FuzzRegistration kTarget({"foxglove_session", &fuzzSeeds, &runInput});

}  // namespace foxglove_session_fuzz
