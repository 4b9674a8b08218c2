// SPDX-License-Identifier: GPL-3.0-or-later
// What clients ask of robots in a session: services, commands, and who steers.
#include "robotlink/foxglove/session/SessionServer.h"

#include "foxglove/Image.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "tests/robotlink/foxglove/session/OfferedSessionTest.h"

namespace robotlink::websocket::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using SessionServerRequestsTest = OfferedSessionTest;

TEST_F(SessionServerRequestsTest, aKeyThatIsRefusedIsReportedUnlessALogHasWhatItPublishes) {
  std::vector<std::string> refused;
  session_.setRefusalHandler(
      [&](const std::string& what, const std::string& reason) { refused.push_back(what + ": " + reason); });
  refusal_ = "no process has it";
  publishTables();
  publish("red1/camera/image", Instant(2ms), foxglove::RawImage());
  tick();
  const auto channel = advertised().at("red1/camera/image").id;
  say(Subscribe{{{1, channel}}});
  EXPECT_THAT(refused, ElementsAre("set key of red1: no process has it"));
  say(Unsubscribe{{1}});
  refused.clear();
  publish("replay", Instant(2ms), robotcontrol::ReplayStatus());
  tick();
  say(Subscribe{{{2, channel}}});
  EXPECT_THAT(refused, IsEmpty());
}

TEST_F(SessionServerRequestsTest, aRequestIsAServiceThatAnswersWithItsResult) {
  auto ids = services();
  ASSERT_TRUE(ids.contains("red1/stop"));
  ASSERT_TRUE(ids.contains("control_simulation"));
  say(ServiceCallRequest{ids["red1/stop"], 3, "json", R"({"engaged": true})"});
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_TRUE(requests_[0].stop().engaged());
  auto answers = heard<ServiceCallResponse>();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(nlohmann::json::parse(answers[0].payload)["accepted"], true);
  say(ServiceCallRequest{ids["red1/stop"], 4, "json", "{"});
  const auto failures = heard<ServiceCallFailure>();
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_THAT(failures[0].message, HasSubstr("robotcontrol.Stop"));
  EXPECT_EQ(requests_.size(), 1U);
}

TEST_F(SessionServerRequestsTest, whatNobodyFulfillsIsNotOffered) {
  EXPECT_TRUE(services().contains("control_recording"));
  server_->withhold("control_recording");
  client_ = *server_->server()->connect({0, "127.0.0.1:2", "y"}, [] {});
  const auto ids = services();
  EXPECT_FALSE(ids.contains("control_recording"));
  EXPECT_TRUE(ids.contains("control_simulation"));
  EXPECT_TRUE(ids.contains("red1/stop"));
}

TEST_F(SessionServerRequestsTest, aClientNamesNoFilesOfThisMachine) {
  auto ids = services();
  for (const char* argument :
       {R"({"action": "START", "path": "/tmp/x.mcap"})",
        R"({"action": "SAVE_LAST", "path": "a/../../x.mcap"})", R"({"path": "x.mcap"})"}) {
    EXPECT_THAT(call(client_, ids["control_recording"], argument), HasSubstr("cannot be chosen")) << argument;
  }
  EXPECT_THAT(asked(), IsEmpty());
  EXPECT_EQ(call(client_, ids["control_recording"], R"({"action": "START"})"), "");
  EXPECT_THAT(asked(), ElementsAre("control_recording"));
}

TEST_F(SessionServerRequestsTest, whatAClientPublishesMovesTheRobotUntilItIsNotHeard) {
  say(ClientAdvertise{{{7, "red1/remote/drive", "json", "", "", ""}}});
  say(ClientMessageData{7, R"({"velocity": {"x": 0.1}})"});
  EXPECT_THAT(asked(), ElementsAre("motion 1"));
  ASSERT_NE(steering(), nullptr);
  EXPECT_EQ(steering()->who(), "x at 127.0.0.1:1");
  EXPECT_EQ(steering()->client(), client_->info.id);
  clock_->advance(490ms);
  tick();
  EXPECT_THAT(asked(), IsEmpty());
  clock_->advance(20ms);
  tick();
  EXPECT_THAT(asked(), ElementsAre("motion 0"));
  say(ClientMessageData{7, R"({"velocity": {"x": 0.1}})"});
  asked();
  server_->server()->disconnected(client_);
  tick();
  EXPECT_THAT(asked(), ElementsAre("motion 0"));
  EXPECT_EQ(steering()->who(), "");
}

TEST_F(SessionServerRequestsTest, aFloodOfCommandsIsOneRequestATick) {
  say(ClientAdvertise{{{7, "red1/remote/drive", "json", "", "", ""}}});
  const Frame frame = encode(ClientMessage(ClientMessageData{7, R"({"velocity": {"x": 0.1}})"}));
  for (int i = 0; i < 1000; ++i) server_->server()->received(client_, frame.kind, frame.bytes);
  tick();
  EXPECT_EQ(asked().size(), 1U);
}

TEST_F(SessionServerRequestsTest, whatIsWrongWithCommandsIsSaidOnce) {
  heard<ServerInfo>();
  say(ClientAdvertise{{{7, "red1/remote/drive", "json", "", "", ""}, {8, "/chatter", "json", "", "", ""}}});
  auto complaints = heard<Status>();
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_THAT(complaints[0].message, HasSubstr("/chatter"));
  refusal_ = "the robot is asleep";
  for (int i = 0; i < 3; ++i) say(ClientMessageData{7, "{}"});
  complaints = heard<Status>();
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_EQ(complaints[0].message, refusal_);
  refusal_.clear();
  say(ClientMessageData{7, "{}"});
  say(ClientMessageData{7, "["});
  EXPECT_EQ(heard<Status>().size(), 1U);
}

TEST_F(SessionServerRequestsTest, whoDrivesARobotThatDoesNotObeyIsToldSoOnce) {
  robotcontrol::SolutionTable table;
  auto& task = *table.add_tasks();
  task.set_name("behavior");
  task.set_active("go-to-ball");
  task.add_solutions()->set_name("obey");
  publish("red1/tables/solutions", Instant(1ms), table);
  tick();
  say(ClientAdvertise{{{7, "red1/remote/drive", "json", "", "", ""}}});
  heard<Status>();
  for (int i = 0; i < 3; ++i) say(ClientMessageData{7, R"({"velocity": {"x": 0.1}})"});
  const auto complaints = heard<Status>();
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_THAT(complaints[0].message, HasSubstr("its behavior is 'go-to-ball'"));
  EXPECT_THAT(complaints[0].message, HasSubstr("red1/solutions/behavior"));
  task.set_active("obey");
  publish("red1/tables/solutions", Instant(2ms), table);
  tick();
  say(ClientMessageData{7, R"({"velocity": {"x": 0.1}})"});
  EXPECT_THAT(heard<Status>(), IsEmpty());
}

TEST_F(SessionServerRequestsTest, oneSteersAndTheOtherTakesOverButStopIsEverybodys) {
  auto ids = services();
  const ClientPtr other = *server_->server()->connect({0, "127.0.0.1:2", "y"}, [] {});
  const char* const kWalk = R"({"motion": {"kind": "WALK"}})";
  EXPECT_EQ(call(client_, ids["red1/motion"], kWalk), "");
  EXPECT_THAT(call(other, ids["red1/motion"], kWalk), HasSubstr("steered by x at 127.0.0.1:1"));
  EXPECT_THAT(call(other, ids["red1/set_goal"], R"({"pose_in_field": {}})"), HasSubstr("steered by"));
  EXPECT_EQ(call(other, ids["red1/stop"], R"({"engaged": true})"), "");
  EXPECT_EQ(call(other, ids["red1/steer"], "{}"), "");
  EXPECT_THAT(asked(), ElementsAre("motion 1", "stop", "motion 0"));
  EXPECT_EQ(call(other, ids["red1/motion"], kWalk), "");
  EXPECT_THAT(call(client_, ids["red1/motion"], kWalk), HasSubstr("steered by y"));
  // A request of the session itself is one of a person at this machine.
  Request request;
  request.set_robot("red1");
  request.mutable_motion();
  session_.request(request);
  tick();
  EXPECT_EQ(steering()->who(), "this machine");
  EXPECT_THAT(call(other, ids["red1/motion"], kWalk), HasSubstr("steered by this machine"));
  EXPECT_EQ(call(other, ids["red1/steer"], R"({"give_up": true})"), "");
  EXPECT_THAT(call(other, ids["red1/steer"], "x"), HasSubstr("give_up"));
}

TEST_F(SessionServerRequestsTest, stopGoesBeforeWhatWaits) {
  auto ids = services();
  const auto post = [&](const char* service, const char* argument) {
    const Frame frame = encode(ClientMessage(ServiceCallRequest{ids[service], 1, "json", argument}));
    server_->server()->received(client_, frame.kind, frame.bytes);
  };
  post("red1/set_color_table", "{}");
  post("red1/motion", "{}");
  post("red1/stop", R"({"engaged": true})");
  tick();
  EXPECT_THAT(asked(), ElementsAre("stop", "set_color_table", "motion 0"));
}

TEST_F(SessionServerRequestsTest, whoOnlyWatchesMayEngageStopButNotReleaseIt) {
  auto ids = services();
  const ClientPtr watcher = *server_->server()->connect({0, "127.0.0.1:2", "y", true}, [] {});
  EXPECT_EQ(call(watcher, ids["red1/stop"], R"({"engaged": true})"), "");
  EXPECT_EQ(call(watcher, ids["red1/stop"], "{}"), "") << "this stops, too";
  EXPECT_THAT(call(watcher, ids["red1/stop"], R"({"engaged": false})"), HasSubstr("only watch"));
  EXPECT_EQ(call(watcher, ids["red1/get_parameters"], "{}"), "");
  for (const char* service :
       {"red1/motion", "red1/set_key", "red1/steer", "red1/set_color_table", "control_simulation"})
    EXPECT_THAT(call(watcher, ids[service], "{}"), HasSubstr("only watch")) << service;
  EXPECT_THAT(asked(), ElementsAre("stop", "stop", "get_parameters"));
}

TEST_F(SessionServerRequestsTest, whenTheOfferEndsKeysAreAsBeforeAndRobotsStand) {
  publishTables();
  const auto channels = advertised();
  say(Subscribe{{{1, channels.at("red1/drawings/image/ball-percept/disc").id}}});
  say(ClientAdvertise{{{7, "red1/remote/drive", "json", "", "", ""}}});
  say(ClientMessageData{7, R"({"velocity": {"x": 0.1}})"});
  EXPECT_THAT(asked(), ElementsAre("set_key", "motion 1"));
  server_.reset();
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[0].motion().motion().kind(), robotcontrol::MotionRequest::STAND);
  EXPECT_EQ(requests_[1].set_key().mode().kind(), robotcontrol::KeyMode::OFF);
}

TEST_F(SessionServerRequestsTest, theModeThatAClientSetsEndsWithIt) {
  publishTables();
  auto ids = services();
  EXPECT_EQ(call(client_, ids["red1/set_key"],
                 R"({"name": "package/camera/image", "mode": {"kind": "EVERY_N", "n": 3}})"),
            "");
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].set_key().mode().kind(), robotcontrol::KeyMode::EVERY_N);
  server_->server()->disconnected(client_);
  tick();
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[1].set_key().mode().kind(), robotcontrol::KeyMode::OFF);
}

TEST_F(SessionServerRequestsTest, resultsThatComeWhenTheOfferHasEndedAreIgnored) {
  publishTables();
  heard<Advertise>();
  const Frame frame =
      encode(ClientMessage(SetParameters{{{"red1/solutions/ball-percept", Value{"blobs"}}}, "set"}));
  const auto server = server_->server();
  server->received(client_, frame.kind, frame.bytes);
  server_->tick();
  EXPECT_EQ(requests_.size(), 1U);
  server_.reset();
  session_.tick();  // the result
}

}  // namespace
}  // namespace robotlink::websocket::test
