// SPDX-License-Identifier: GPL-3.0-or-later
// The real workbench runs scripts: those that are shipped, and lines that robotctl sends.
#include <gmock/gmock.h>

#include <algorithm>

#include "robotlink/base/AtomicFile.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/StartedProgram.h"
#include "tests/app/Watch.h"

namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kScripts = ROBOTCONTROL_SOURCE_DIR "/resources/scripts/";

class RobotcontrolScripts : public testing::Test {
 protected:
  static void SetUpTestSuite() { ::setenv("QT_QPA_PLATFORM", "offscreen", 1); }
  void SetUp() override {
    std::filesystem::create_directories(here_);
    std::filesystem::create_directories(home_);
    std::filesystem::permissions(home_, std::filesystem::perms::owner_all);  // as Qt demands it
    ::setenv("XDG_CONFIG_HOME", home_.c_str(), 1);
    ::setenv("XDG_RUNTIME_DIR", home_.c_str(), 1);
    ::setenv("HOME", home_.c_str(), 1);
    ::setenv("LOG", (here_ / "game.mcap").c_str(), 1);
  }
  StartedProgram started(const std::string& script, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"--script", script};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return {ROBOTCONTROL, here_, arguments};
  }
  void passes(const std::string& script) const {
    StartedProgram workbench = started(kScripts + script);
    EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
  }
  std::string read(const std::string& name) const { return robotlink::readFile(here_ / name).value_or(""); }

  const TestFolder folder_;
  const std::filesystem::path here_ = folder_ / "here", home_ = folder_ / "home";
};

}  // namespace

TEST_F(RobotcontrolScripts, theBallIsFound) {
  passes("ball.script");
}

TEST_F(RobotcontrolScripts, keysAndSolutionsAreSwitched) {
  passes("keys.script");
}

TEST_F(RobotcontrolScripts, aParameterIsTunedKeptAndSwept) {
  passes("tuning.script");
  EXPECT_THAT(read("tuned.preset.json"), HasSubstr("\"ball-model/filtered memory\": \"3\""));
  EXPECT_THAT(read("memory.csv"), HasSubstr("\n6,"));
  // Another start does not know of it, unless it is told.
  const std::string compare = folder_.write("compare.script", "preset.diff ./tuned.preset.json\n").string();
  EXPECT_EQ(started(compare).wait(), 1);
  StartedProgram again = started(compare, {"--preset", "./tuned.preset.json"});
  EXPECT_EQ(again.wait(), 0) << again.errors();
}

TEST_F(RobotcontrolScripts, aRobotOnWheelsDrivesToAGoal) {
  passes("goal.script");
  EXPECT_THAT(read("goal.png"), StartsWith("\x89PNG"));
}

TEST_F(RobotcontrolScripts, aLogIsRecordedOpenedAndSearched) {
  passes("log.script");
}

TEST_F(RobotcontrolScripts, aFailureHasItsPlaceAndAJUnitFile) {
  folder_.write("here/part.script", "wait until simulation.time > 0.1\nassert simulation.time < 0\n");
  folder_.write("here/a.script", "include part.script\n");
  StartedProgram workbench = started("a.script", {"--junit", "a.xml"});
  EXPECT_EQ(workbench.wait(), 1);
  EXPECT_THAT(workbench.errors(),
              StartsWith("part.script:2:8: expected simulation.time < 0: simulation.time is "));
  EXPECT_THAT(read("a.xml"), HasSubstr("tests=\"2\" failures=\"2\""));
  EXPECT_THAT(read("a.xml"), HasSubstr("a.script:1: the included script failed: part.script:2:8: "));
}

TEST_F(RobotcontrolScripts, whatAScriptDoesToTheWindowIsNotKept) {
  folder_.write("here/a.script", "view.perspective Motion\nprint 2 * 3\nscreenshot scene scene.png");
  StartedProgram workbench = started("a.script");
  EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
  EXPECT_THAT(read("scene.png"), StartsWith("\x89PNG"));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(home_))
    EXPECT_NE(entry.path().filename(), "window.json");
  folder_.write("here/b.script", "view.save-perspective Mine");
  StartedProgram saving = started("b.script");
  EXPECT_EQ(saving.wait(), 0) << saving.errors();
  bool isThere = false;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(home_))
    isThere = isThere || entry.path().filename() == "window.json";
  EXPECT_TRUE(isThere) << "what it asks to be saved is";
}

TEST_F(RobotcontrolScripts, whatCannotBeOpenedOrIsRefusedFails) {
  folder_.write("here/a.script", "simulation.open none.sdf");
  StartedProgram opening = started("a.script");
  EXPECT_EQ(opening.wait(), 1);
  EXPECT_THAT(opening.errors(), StartsWith("a.script:1: "));
  folder_.write("here/b.script", "robot.solution ball-percept magic");
  StartedProgram refused = started("b.script");
  EXPECT_EQ(refused.wait(), 1);
  EXPECT_THAT(refused.errors(), HasSubstr("b.script:1:1: refused: "));
}

TEST_F(RobotcontrolScripts, whatDoesNotFitIntoTheSceneFailsItsLine) {
  folder_.write("here/a.script", "scene.insert box 1 1\nscene.insert box 1 1\nprint 1");
  StartedProgram workbench = started("a.script", {"pioneer"});
  EXPECT_EQ(workbench.wait(), 1);
  EXPECT_THAT(workbench.errors(), HasSubstr("a.script:2: there is no room for 'box2'"));
}

TEST_F(RobotcontrolScripts, whatAScriptLeavesUnsavedIsNotRestored) {
  folder_.write("here/a.script", "scene.insert box 1 1\nwait 3");
  StartedProgram workbench = started("a.script", {"pioneer"});
  EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(home_))
    EXPECT_NE(entry.path().extension(), ".scenes") << entry.path();
}

TEST_F(RobotcontrolScripts, aShippedSceneIsOpenedByItsName) {
  folder_.write("here/a.script", "robot.select blue1\n");
  StartedProgram workbench = started("a.script", {"game2002-1"});
  EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
}

TEST_F(RobotcontrolScripts, robotsOfTheCommandLineAreWaitedFor) {
  std::filesystem::create_directories(folder_ / "robot/work");
  StartedProgram robot(ROBOTCTL, folder_ / "robot/work", {"sim", "field2002", "--listen", "127.0.0.1:0"});
  const auto url = [&] {
    const std::string said = robot.errors();
    const std::size_t at = said.find("ws://"), end = said.find_first_of(",\n", std::min(at, said.size()));
    return end == std::string::npos ? std::string() : said.substr(at, end - at);
  };
  ASSERT_TRUE(eventually([&] { return !url().empty(); })) << robot.errors();
  folder_.write("here/a.script", "robot.select red1\n");
  StartedProgram workbench = started("a.script", {url()});
  EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
  folder_.write("here/b.script", "print 1\n");
  StartedProgram command = started("b.script", {url(), "--command", "robot.select red1"});
  EXPECT_EQ(command.wait(), 0);
  EXPECT_THAT(command.errors(), testing::Not(HasSubstr("there is no robot")));
}

TEST_F(RobotcontrolScripts, robotctlRunsLinesInTheRunningWorkbench) {
  const Watch watch(home_, IN_CREATE);
  StartedProgram workbench(ROBOTCONTROL, here_, {"--paused"});
  const auto listens = [this] {
    for (const auto& entry : std::filesystem::directory_iterator(home_)) {
      if (entry.path().extension() == ".sock") return true;
    }
    return false;
  };
  while (!listens()) ASSERT_TRUE(watch.happens());
  StartedProgram good(ROBOTCTL, here_,
                      {"do", "wait until simulation.steps >= 0", "set n 2", "simulation.step",
                       "wait until simulation.steps >= $n", "screenshot window window.png"});
  EXPECT_EQ(good.wait(), 0) << good.errors();
  EXPECT_THAT(read("window.png"), StartsWith("\x89PNG"));
  StartedProgram bad(ROBOTCTL, here_, {"do", "simulation.speed 5", "simulation.speed fast"});
  EXPECT_EQ(bad.wait(), 1);
  EXPECT_THAT(bad.errors(), HasSubstr("simulation.speed fast: the argument speed must be a number"));
  workbench.send(SIGTERM);
  EXPECT_EQ(workbench.wait(), 0) << workbench.errors();
  StartedProgram nobody(ROBOTCTL, here_, {"do", "robot.stop on"});
  EXPECT_EQ(nobody.wait(), 1);
  EXPECT_THAT(nobody.errors(), HasSubstr("no workbench of yours runs"));
}
