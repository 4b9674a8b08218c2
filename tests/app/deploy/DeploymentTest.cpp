// SPDX-License-Identifier: GPL-3.0-or-later
// Files are deployed over a real connection.
#include "app/core/deploy/Deployment.h"

#include <gmock/gmock.h>

#include "app/core/deploy/DeployJobs.h"
#include "app/core/deploy/DeployServices.h"
#include "app/core/recordings/RecordingFetch.h"
#include "colortool/table/ColorTableFile.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "robotlink/foxglove/client/Client.h"
#include "robotlink/foxglove/client/Connector.h"
#include "robotlink/foxglove/security/Digest.h"
#include "robotlink/foxglove/server/Listener.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using robotlink::websocket::Client;
using robotlink::websocket::Connector;
using robotlink::websocket::Listener;
using robotlink::websocket::Server;
using testing::ElementsAre;
using testing::HasSubstr;
using State = DeployDifference::State;

class DeploymentTest : public testing::Test {
 protected:
  DeploymentTest() {
    files_.write("set/own.yaml", layout_);
    EXPECT_TRUE(colortool::ColorTableFile().save(files_ / "set/hall.C64"));
    files_.write("set/parameters/ers210/motion.a.textproto", "a");
    files_.write("set/parameters/ers210/motion.b.textproto", "b");
    files_.write("set/parameters/ers210/README", "not sent");
    files_.write("set/motions/sit.mof", "sit");
    connect("owners");
  }
  void connect(const std::string& token) {
    Listener::Options options;
    options.address.port = 0;
    options.greetingDelay = {};
    options.admission.token = "owners";
    options.admission.watchToken = "watchers";
    connector_.reset();
    listener_ = Listener::open(server_, options).value();
    Connector::Options connection;
    connection.url = {.host = "127.0.0.1", .port = listener_->address().port};
    connection.token = token;
    connector_ = std::make_unique<Connector>(client_, connection);
  }
  RobotSet::Robot robot() const {
    return {"red1", "", "", "ws://127.0.0.1", "own.yaml", "hall.C64", "parameters/ers210/", "motions"};
  }
  std::vector<DeployFile> files() const { return filesFor(robot(), files_ / "set").value(); }
  Deployment deployment() { return Deployment(callsOf(*client_)); }
  std::string atRobot(const std::string& path) {
    return robotlink::readFile(files_ / ("robot/" + path)).value_or("none");
  }

  const std::string layout_ = robotlink::readFile(robotlink::resource("layouts/compact.yaml")).value();
  const TestFolder files_;
  std::vector<std::string> written_;
  const std::shared_ptr<Server> server_ = Server::make({}, {});
  const DeployServices services_{server_, ResourceFolder(files_ / "robot"),
                                 [this](const std::string& path) { written_.push_back(path); }};
  std::unique_ptr<Listener> listener_;
  const std::shared_ptr<Client> client_ = std::make_shared<Client>(robotlink::websocket::ClientHandlers{});
  std::unique_ptr<Connector> connector_;
};

TEST_F(DeploymentTest, whatDiffersIsSaidAndSent) {
  files_.write("robot/motions/sit.mof", "sit");
  files_.write("robot/layouts/own.yaml", "older");
  const auto before = deployment().check(files());
  ASSERT_TRUE(before) << before.error().text;
  EXPECT_EQ(
      describe(*before),
      "4 of 5 files differ: layouts/own.yaml differs, colortables/red1.c64 is missing, "
      "parameters/ers210/motion.a.textproto is missing, parameters/ers210/motion.b.textproto is missing");
  EXPECT_EQ(atRobot("layouts/own.yaml"), "older");
  const auto after = deployment().send(files());
  ASSERT_TRUE(after) << after.error().text;
  EXPECT_EQ(describe(*after), "all of 5 files are the same");
  EXPECT_EQ(atRobot("layouts/own.yaml"), layout_);
  EXPECT_EQ(atRobot("colortables/red1.c64"), robotlink::readFile(files_ / "set/hall.C64").value());
  EXPECT_EQ(atRobot("parameters/ers210/README"), "none");
  // What is the same is not sent.
  EXPECT_EQ(written_.size(), 4U);
  ASSERT_TRUE(deployment().send(files()));
  EXPECT_EQ(written_.size(), 4U);
}

/// A robot whose program runs in another layout than the set has for it.
class RestartTest : public testing::Test {
 protected:
  RestartTest() {
    programs_.set({{"red1", "ers210", "compact.yaml"}});
    files_.write("set/own.yaml", robotlink::readFile(robotlink::resource("layouts/compact.yaml")).value());
    files_.write("set/motions/sit.mof", "sit");
    files_.write(
        "set/game.preset.json",
        R"({"format": "robotcontrol-preset", "version": 1, "preset": {"keys": {"package/models/ball": "always"}}})");
    Listener::Options options;
    options.address.port = 0;
    options.greetingDelay = {};
    listener_ = Listener::open(server_, options).value();
    Connector::Options connection;
    connection.url = {.host = "127.0.0.1", .port = listener_->address().port};
    connector_ = std::make_unique<Connector>(client_, connection);
  }
  void restart(const std::string& robot, const std::filesystem::path& layout,
               const std::function<void(const std::string&)>& done) {
    asked_ += robot + " " + layout.filename().string() + ";";
    if (!why_.empty()) return done(why_);
    if (!layout.empty()) programs_.set({{"red1", "ers210", layout.filename().string()}});
    programs_.noteStarted(robot);
    done({});
  }
  std::vector<DeployFile> files() const {
    return filesFor({"red1", "", "", "ws://127.0.0.1", "own.yaml", "", "", "motions", "game.preset.json"},
                    files_ / "set")
        .value();
  }

  const TestFolder files_;
  RunningPrograms programs_;
  std::string asked_, why_;
  const std::shared_ptr<Server> server_ = Server::make({}, {});
  const DeployServices services_{
      server_, ResourceFolder(files_ / "robot"),
      [this](const std::string& path) { programs_.noteWritten(path); },
      DeployServices::Programs{
          [this] { return programs_.programs(); },
          [this](const auto& robot, const auto& layout, const auto& done) { restart(robot, layout, done); }}};
  std::unique_ptr<Listener> listener_;
  const std::shared_ptr<Client> client_ = std::make_shared<Client>(robotlink::websocket::ClientHandlers{});
  std::unique_ptr<Connector> connector_;
  Deployment deployment_{callsOf(*client_), "red1"};
};

TEST_F(RestartTest, whatTakesEffectAtTheNextStartIsSaidAndStarted) {
  const auto sent = deployment_.send(files());
  ASSERT_TRUE(sent) << sent.error().text;
  EXPECT_TRUE(needsRestart(*sent));
  EXPECT_EQ(describe(*sent), "all of 3 files are the same; 3 take effect when its program starts again");
  const auto restarted = deployment_.restart(files());
  ASSERT_TRUE(restarted) << restarted.error().text;
  EXPECT_EQ(describe(*restarted), "all of 3 files are the same");
  EXPECT_EQ(asked_, "red1 own.yaml;");
  // There is nothing to be read any more.
  ASSERT_TRUE(deployment_.restart(files()));
  EXPECT_EQ(asked_, "red1 own.yaml;");
}

TEST_F(RestartTest, whyAProgramIsNotStartedAgainIsSaid) {
  ASSERT_TRUE(deployment_.send(files()));
  why_ = "its layout is no layout";
  const auto refused = deployment_.restart(files());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("not restarted: its layout is no layout"));
}

TEST_F(RestartTest, onlyLayoutsOfTheRobotAreStarted) {
  const auto restart = [&](const std::string& argument) {
    const auto answer =
        PendingAnswer(callsOf(*client_), "deploy/restart", argument).wait([] { return true; });
    return answer && !*answer ? answer->error().text : std::string("done");
  };
  EXPECT_THAT(restart(R"({"robot": "red1", "layout": "../../own.yaml"})"), HasSubstr("not allowed"));
  EXPECT_THAT(restart(R"({"robot": "red1", "layout": "own.yaml"})"), HasSubstr("deploy it first"));
  EXPECT_EQ(asked_, "");
  EXPECT_EQ(restart(R"({"robot": "red1"})"), "done");
  EXPECT_EQ(asked_, "red1 ;");
}

TEST_F(DeploymentTest, allFilesThatAreNotHereAreNamed) {
  RobotSet::Robot wrong = robot();
  wrong.layout = "none.yaml";
  wrong.motions = "parameters";
  wrong.colorTable = "motions/sit.mof";
  const auto found = filesFor(wrong, files_ / "set");
  ASSERT_FALSE(found);
  const std::string errors = robotlink::describe(found.error());
  EXPECT_THAT(errors, HasSubstr("none.yaml"));
  EXPECT_THAT(errors, HasSubstr("no files *.mof"));
  EXPECT_THAT(errors, HasSubstr("colortables/ROBOT.c64"));
  EXPECT_TRUE(filesFor({"red1", "", "", "ws://a"}, files_ / "set").value().empty());
}

TEST_F(DeploymentTest, whatIsNoLayoutOrColorTableIsNotSent) {
  files_.write("set/own.yaml", "version: 1\nnmae: own\n");
  files_.write("set/hall.C64", "nonsense");
  const auto found = filesFor(robot(), files_ / "set");
  ASSERT_FALSE(found);
  const std::string errors = robotlink::describe(found.error());
  EXPECT_THAT(errors, HasSubstr("own.yaml:2"));
  EXPECT_THAT(errors, HasSubstr("hall.C64"));
}

TEST_F(DeploymentTest, aPresetThatNoProgramCouldStartWithIsNotSent) {
  files_.write(
      "set/game.preset.json",
      R"({"format": "robotcontrol-preset", "version": 1, "preset": {"keys": {"no/such": "always"}}})");
  RobotSet::Robot wrong = robot();
  wrong.preset = "game.preset.json";
  const auto found = filesFor(wrong, files_ / "set");
  ASSERT_FALSE(found);
  EXPECT_THAT(robotlink::describe(found.error()), HasSubstr("there is no debug key 'no/such'"));
}

TEST_F(DeploymentTest, whoMayOnlyWatchComparesButDoesNotSend) {
  connect("watchers");
  EXPECT_TRUE(deployment().check(files()));
  const auto refused = deployment().send(files());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("watch"));
  EXPECT_EQ(atRobot("layouts/own.yaml"), "none");
}

TEST_F(DeploymentTest, theRobotRefusesWhatItShouldNotWrite) {
  const auto put = [&](const std::string& argument) {
    const auto answer = PendingAnswer(callsOf(*client_), "deploy/put", argument).wait([] { return true; });
    return answer && !*answer ? answer->error().text : std::string("done");
  };
  EXPECT_THAT(put(R"({"path": "../a.yaml", "content": "eA==", "sha256": ")" +
                  robotlink::websocket::sha256("x") + "\"}"),
              HasSubstr("is not allowed"));
  EXPECT_THAT(put(R"({"path": "layouts/a.yaml", "content": "eA==", "sha256": "00"})"), HasSubstr("checksum"));
  EXPECT_THAT(put(R"({"path": "layouts/a.yaml", "content": "?"})"), HasSubstr("base64"));
  EXPECT_THAT(put("[]"), HasSubstr("not a JSON object"));
  EXPECT_THAT(put("{}"), testing::Ne("done"));
  EXPECT_FALSE(std::filesystem::exists(files_ / "robot"));
}

TEST_F(DeploymentTest, itIsDoneInTheBackground) {
  DeployJobs jobs(callsOf(*client_));
  jobs.send("red1", files());
  EXPECT_TRUE(jobs.state("red1").isBusy);
  ASSERT_TRUE(eventually([&] { return !jobs.state("red1").isBusy; }));
  ASSERT_TRUE(jobs.state("red1").differences) << jobs.state("red1").error->text;
  EXPECT_TRUE(jobs.state("red1").wasSent);
  EXPECT_EQ(jobs.state("red1").differences->front(), (DeployDifference{"layouts/own.yaml", State::kSame}));
}

TEST_F(DeploymentTest, aRobotThatAnswersNonsenseIsNotBelieved) {
  for (const std::string answer : {"", "[]", "{}", R"({"files": 3})", R"({"files": [3]})",
                                   R"({"files": [{}]})", R"({"files": [{"path": 3, "sha256": "x"}]})"}) {
    Deployment robot([&](const auto&, const auto&, const auto& handler) { handler(answer); });
    EXPECT_FALSE(robot.check(files())) << answer;
  }
  // One that says that it has what was sent, but has not.
  Deployment liar([](const auto&, const auto&, const auto& handler) { handler(R"({"files": []})"); });
  EXPECT_THAT(liar.send(files()).error().text, HasSubstr("differ"));
}

}  // namespace
}  // namespace app
