// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl watch` and `robotctl request`, run on a session that is offered by this test.
#include <gmock/gmock.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <thread>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/foxglove/security/Certificate.h"
#include "robotlink/foxglove/security/KnownServers.h"
#include "robotlink/foxglove/security/RememberedTokens.h"
#include "robotlink/foxglove/server/Listener.h"
#include "robotlink/foxglove/session/SessionServer.h"
#include "tests/TestFolder.h"
#include "tests/app/robotctl/RobotctlRun.h"

namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using robotlink::Session;
using robotlink::websocket::Listener;
using robotlink::websocket::SessionServer;
using testing::HasSubstr;
using testing::Not;

/// A robot that publishes a text and a ball a hundred times a second, and refuses solutions.
class OfferedRobot : public testing::Test {
 protected:
  OfferedRobot() {
    session_.setRobots({"red1"});
    session_.setRequestSink([this](const robotcontrol::Request& request) {
      robotcontrol::RequestResult result;
      result.set_id(request.id());
      result.set_accepted(!request.has_select_solution());
      if (request.has_select_solution()) result.set_reason("there is no such solution\x1B[2J");
      session_.pushResult(result);
    });
    Listener::Options options;
    options.address.port = 0;
    options.admission.token = "secret";
    options.admission.wrongTokenDelay = {};
    listener_ = *Listener::open(server_.server(), options);
    url_ = "ws://" + toString(listener_->address());
    thread_ = std::thread([this] { publish(); });
  }
  ~OfferedRobot() override {
    isOver_ = true;
    thread_.join();
  }
  RobotctlOutcome robotctl(const std::string& command, const std::string& rest,
                           const std::string& token = "secret") {
    return runRobotctl(folder_.path(), command + " " + url_ + " --token " + token + " " + rest);
  }
  void publish() {
    // As all servers say it: a program runs there, rather than only a body.
    session_.push({"red1/program", {}, std::make_shared<robotcontrol::ProgramSetup>()});
    for (int i = 1; !isOver_; ++i) {
      const robotlink::Instant now(i * 10ms);
      auto text = std::make_shared<foxglove::Log>();
      text->set_message("text " + std::to_string(i));
      session_.push({"red1/log", now, text});
      auto ball = std::make_shared<robotcontrol::BallModel>();
      ball->mutable_position_in_robot()->set_x(i);
      session_.push({"red1/models/ball", now, ball});
      session_.push({"red1/tables/keys", now, std::make_shared<robotcontrol::KeyTable>(keys())});
      session_.tick();
      server_.tick();
      std::this_thread::sleep_for(10ms);
    }
  }
  static robotcontrol::KeyTable keys() {
    robotcontrol::KeyTable table;
    table.add_keys()->set_name("package/camera/image");
    table.mutable_keys(0)->set_stream("camera/image");
    return table;
  }

  const TestFolder folder_;
  Session session_;
  SessionServer server_{session_};
  std::unique_ptr<Listener> listener_;
  std::string url_;
  std::atomic<bool> isOver_{false};
  std::thread thread_;
};

TEST_F(OfferedRobot, watchListsStreamsWithTheirRates) {
  const auto text = robotctl("watch", "--seconds 0.7");
  EXPECT_EQ(text.status, 0) << text.errors;
  EXPECT_THAT(text.out, HasSubstr("(red1): connected"));
  EXPECT_THAT(text.out, HasSubstr("robotcontrol.BallModel"));
  const auto outcome = robotctl("watch", "--seconds 0.7 --json");
  const json watched = json::parse(outcome.out);
  EXPECT_EQ(watched["robots"], json({"red1"}));
  for (const json& stream : watched["streams"]) {
    if (stream["path"] != "red1/models/ball") continue;
    EXPECT_GT(stream["rate"], 5.0);
  }
}

TEST_F(OfferedRobot, watchRecordsWhatAReplayNeeds) {
  const auto outcome = robotctl("watch", "--seconds 1 --record out.mcap");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.out, HasSubstr("out.mcap: "));
  const auto info = runRobotctl(folder_.path(), "log info out.mcap --json");
  EXPECT_EQ(info.status, 0) << info.errors;
  EXPECT_THAT(info.out, HasSubstr("red1/models/ball"));
  EXPECT_THAT(info.out, HasSubstr("red1/log"));
}

TEST_F(OfferedRobot, watchPrintsAStreamAsATable) {
  const auto outcome = robotctl("watch", "--seconds 0.7 --csv red1/models/ball");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_THAT(outcome.out, HasSubstr("time,"));
  EXPECT_THAT(outcome.out, HasSubstr("position_in_robot.x"));
  EXPECT_GT(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 5);
  const auto wrong = robotctl("watch", "--seconds 0.7 --csv red1/models/bal");
  EXPECT_EQ(wrong.status, 1);
  EXPECT_THAT(wrong.errors,
              HasSubstr("there is no stream 'red1/models/bal'; did you mean 'red1/models/ball'?"));
}

TEST_F(OfferedRobot, watchPrintsMessagesAsJsonForOtherPrograms) {
  const auto outcome = robotctl("watch", "--seconds 0.7 --json-lines 'red1/models/*,red1/log'");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  std::istringstream lines(outcome.out);
  std::set<std::string> streams;
  double before = 0;
  for (std::string line; std::getline(lines, line);) {
    const json message = json::parse(line);
    streams.insert(message["stream"]);
    if (message["stream"] != "red1/models/ball") continue;
    EXPECT_TRUE(message["message"]["position_in_robot"]["x"].is_number()) << line;
    EXPECT_GT(message["log_time"], before);
    before = message["log_time"];
  }
  EXPECT_THAT(streams, testing::Contains("red1/models/ball"));
  for (const std::string& stream : streams)
    EXPECT_TRUE(stream.starts_with("red1/models/") || stream == "red1/log");
  EXPECT_EQ(robotctl("watch", "--json-lines a,,").status, 2);
}

TEST_F(OfferedRobot, requestSaysWhetherItWasAccepted) {
  const auto stop = robotctl("request", R"(red1/stop '{"engaged": true}')");
  EXPECT_EQ(stop.status, 0) << stop.errors;
  EXPECT_EQ(json::parse(stop.out)["accepted"], true);
  const auto refused = robotctl("request", R"(red1/select_solution '{"task": "a", "solution": "b"}')");
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.errors, HasSubstr("refused: there is no such solution"));
  EXPECT_THAT(robotctl("request", "red1/stp").errors, HasSubstr("did you mean 'red1/stop'?"));
  EXPECT_THAT(robotctl("request", "").out, HasSubstr("red1/set_key  robotcontrol.SetKey"));
  EXPECT_EQ(robotctl("request", "red1/stop '{'").status, 2);
}

TEST_F(OfferedRobot, whatARobotSaysDoesNothingToATerminal) {
  const std::string clear = "\x1B[2J";
  const auto channels = server_.server()->addChannels({{"red1/" + clear, "json", "Type" + clear, ""}});
  server_.server()->addService(
      {0, "red1/" + clear, "Type\xC2\x9B", {}, {}},
      [](const auto&, const auto&, const auto& reply) { reply.succeed("no JSON \x1B[2J", "text"); });
  std::string said;
  for (const auto& outcome :
       {robotctl("watch", "--seconds 0.7"), robotctl("watch", "--seconds 0.7 --json"),
        robotctl("request", ""), robotctl("request", "'red1/" + clear + "'"),
        robotctl("request", R"(red1/select_solution '{"task": "a", "solution": "b"}')")})
    said += outcome.out + outcome.errors;
  EXPECT_THAT(said, HasSubstr("red1/?[2J"));
  EXPECT_THAT(said, HasSubstr("Type?"));
  EXPECT_THAT(said, HasSubstr("no JSON ?[2J"));
  EXPECT_THAT(said, HasSubstr("refused: there is no such solution?[2J"));
  EXPECT_THAT(said, Not(HasSubstr("\x1B")));
  EXPECT_THAT(said, Not(HasSubstr("\xC2\x9B")));
}

TEST_F(OfferedRobot, whatDoesNotConnectIsSaid) {
  const auto token = robotctl("request", "red1/stop", "wrong");
  EXPECT_EQ(token.status, 1);
  EXPECT_THAT(token.errors, HasSubstr("the robot requires a different token"));
  url_ = "ws://127.0.0.1:1";
  const auto nobody = robotctl("watch", "--seconds 0.3");
  EXPECT_EQ(nobody.status, 1);
  EXPECT_THAT(nobody.errors, HasSubstr("nothing is listening there"));
  url_ = "127.0.0.1";
  EXPECT_EQ(robotctl("watch", "--seconds 0.3").status, 2);
}

TEST_F(OfferedRobot, runKnowsARobotElsewhereAgainAsOtherCommandsDo) {
  ::setenv("XDG_STATE_HOME", (folder_ / "state").c_str(), 1);
  Listener::Options options;
  options.address.port = 0;
  options.admission.token = "secret";
  options.admission.wrongTokenDelay = {};
  options.certificate = robotlink::websocket::loadOrMakeCertificate(folder_ / "robot.pem").value();
  const auto secured = *Listener::open(server_.server(), options);
  const std::string server = toString(secured->address()), url = "wss://" + server;
  const auto run = [&] { return runRobotctl(folder_.path(), "run --platform " + url); };
  const auto first = run();
  EXPECT_EQ(first.status, 1);
  EXPECT_THAT(first.errors,
              HasSubstr("is new here; its fingerprint is remembered: " + options.certificate->fingerprint));
  EXPECT_THAT(first.errors, HasSubstr("token"));
  ASSERT_TRUE(robotlink::websocket::RememberedTokens().add(url, "secret"));
  const auto second = run();
  EXPECT_THAT(second.errors, Not(HasSubstr("is new here")));
  EXPECT_THAT(second.errors, HasSubstr("the program of red1 runs at " + url));
  ASSERT_TRUE(robotlink::websocket::KnownServers().add(server, "SHA256:other"));
  const auto third = run();
  EXPECT_EQ(third.status, 1);
  EXPECT_THAT(third.errors, HasSubstr("SHA256:other"));
  ::unsetenv("XDG_STATE_HOME");
}

TEST_F(OfferedRobot, deploySaysWhatIsWrongBeforeAnythingIsSent) {
  folder_.write("set.yaml", "robot-set: 1\nname: a\nrobots:\n  - name: red1\n    address: " + url_ +
                                "\n    layout: none.yaml\n");
  const auto missing = runRobotctl(folder_.path(), "deploy set.yaml --token secret");
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.errors, HasSubstr("none.yaml"));
  std::filesystem::copy(robotlink::resource("layouts/compact.yaml"), folder_ / "none.yaml");
  const auto none = runRobotctl(folder_.path(), "deploy set.yaml --token secret --check");
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.errors, HasSubstr("red1: "));
  EXPECT_THAT(none.errors, HasSubstr("deploy/list"));
  folder_.write("wrong.yaml", "robot-set: 1\nname: a\nrobots: 3\n");
  EXPECT_THAT(runRobotctl(folder_.path(), "deploy wrong.yaml").errors, HasSubstr("wrong.yaml:3"));
  EXPECT_THAT(runRobotctl(folder_.path(), "deploy set.yaml --robot blue1").errors,
              HasSubstr("no robot 'blue1'"));
}

TEST(RobotctlResources, aRobotHasAFolderOfItsOwnThatClientsMayWriteInto) {
  const TestFolder folder;
  const std::string sim = "sim " + robotlink::resource("scenes/field2002.sdf").string() +
                          " --listen 127.0.0.1:0 --seconds 0.1 --resources ";
  const auto served = runRobotctl(folder.path(), sim + "own/");
  EXPECT_EQ(served.status, 0) << served.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "own/layouts/compact.yaml"));
  EXPECT_TRUE(std::filesystem::exists(folder / "own/robots/ers210.yaml"));
  EXPECT_EQ(folder.contents(), "own");
  // The second time it is used as it is, so what it lacks is missing.
  std::filesystem::remove_all(folder / "own/layouts");
  const auto lacking = runRobotctl(folder.path(), sim + "own");
  EXPECT_NE(lacking.status, 0);
  EXPECT_THAT(lacking.errors, HasSubstr("'layouts'"));
}

}  // namespace
