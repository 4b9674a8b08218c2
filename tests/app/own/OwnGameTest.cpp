// SPDX-License-Identifier: GPL-3.0-or-later
// A game in which the program of one robot, in a process of its own, crashes or hangs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "app/core/program/ShippedFiles.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "tests/TestFolder.h"
#include "tests/app/SimulatedRuns.h"

using namespace app;
using robotcontrol::HostingStatus;
using ::testing::HasSubstr;

namespace {

/// The layout of games, with a process whose sixth frame is in the middle of play.
std::string soccerWithTrouble(const std::string& solution) {
  std::string text = robotlink::readFile(layoutNamed("soccer")).value_or("");
  const auto place = text.find("  - name: debug");
  EXPECT_NE(place, std::string::npos);
  text.insert(place,
              "  - name: worker\n    period_ms: 1600\n    tasks:\n      - trouble: " + solution + "\n");
  return text;
}

/// A game one against one; the program of blue1 runs in a process of its own.
class OwnGameTest : public ::testing::Test {
 protected:
  void begin(const std::string& solution) {
    RunOptions options = test::simulationOptions();
    options.scene = sceneNamed("game2002-1");
    options.robotLayouts["blue1"] = folder_.write("trouble.yaml", soccerWithTrouble(solution));
    options.hosting.choose("blue1", true);
    options.own.executable = OWN_PROGRAM_CHILD;
    options.own.patience = std::chrono::seconds(3);
    SimulatedRun::Listeners listeners;
    listeners.hosting = [this](const std::string& robot, robotlink::Instant, const HostingStatus& status) {
      hosting_[robot] = status;
    };
    listeners.queue = [this](const std::string& robot, const auto& queue) {
      frames_[robot] += queue->messages.size();
    };
    run_ = test::makeRun(options, listeners);
  }
  /// Plays until the program of blue1 is in trouble, which it is in the middle of play.
  void playUntilTrouble(HostingStatus::State trouble) {
    for (int i = 0; i < 2500 && hosting_["blue1"].state() != trouble; ++i) run_->step();
    ASSERT_EQ(hosting_["blue1"].state(), trouble);
    ASSERT_EQ(run_->referee()->machine().phase(), GameMachine::Phase::kPlaying);
  }
  /// Whether the game, its clock and the program of red1 go on, and blue1 stands where it is.
  void theOthersPlayOn() {
    const auto left = run_->referee()->machine().left();
    const auto before = frames_;
    const auto steps = run_->world().simulation().steps();
    const auto place = [&]() -> robotlink::Vector3 {
      return run_->world().simulation().modelPose("blue1")->translation();
    };
    const robotlink::Vector3 blue = place();
    test::play(*run_, 4);
    EXPECT_GT(run_->world().simulation().steps(), steps);
    EXPECT_LT(run_->referee()->machine().left(), left);
    EXPECT_GT(frames_["red1"], before.at("red1") + 100);
    EXPECT_EQ(frames_["blue1"], before.at("blue1"));
    EXPECT_LT((place() - blue).norm(), 0.2) << "it stands";
  }

  TestFolder folder_;
  std::map<std::string, HostingStatus> hosting_;
  std::map<std::string, std::size_t> frames_;
  std::unique_ptr<SimulatedRun> run_;
};

TEST_F(OwnGameTest, aProgramThatCrashesIsShownAndTheOthersPlayOn) {
  begin("segfault");
  playUntilTrouble(HostingStatus::ENDED);
  EXPECT_THAT(hosting_["blue1"].text(), HasSubstr("trouble (segfault)"));
  theOthersPlayOn();
  // It plays again when it is started again.
  robotcontrol::HostProgram again;
  again.set_start_again(true);
  EXPECT_TRUE(run_->hostProgram("blue1", again).empty());
  EXPECT_EQ(hosting_["blue1"].state(), HostingStatus::RUNNING);
  const auto before = frames_["blue1"];
  test::play(*run_, 1);
  EXPECT_GT(frames_["blue1"], before);
}

TEST_F(OwnGameTest, aProgramThatHangsIsShownAndTheOthersPlayOn) {
  begin("loop");
  playUntilTrouble(HostingStatus::NOT_ANSWERING);
  EXPECT_THAT(hosting_["blue1"].text(), HasSubstr("trouble (loop)"));
  theOthersPlayOn();
}

}  // namespace
