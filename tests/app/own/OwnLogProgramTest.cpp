// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that run on logs, in processes of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Packages.h"
#include "tests/app/own/TroubleLayout.h"
#include "tests/app/platforms/replay/ReplayFixture.h"

namespace app {
namespace {

using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;
using testing::HasSubstr;

/// What the programs of the tests have, so that a plan knows them; here they are never executed.
class OnlyThere final : public robotlink::Solution {
 public:
  explicit OnlyThere(robotlink::SolutionContext&) {}
  void execute() override { ADD_FAILURE() << "it runs in the wrong program"; }
};
robotlink::SolutionBuilder<OnlyThere> onlyThere(const char* name) {
  return robotlink::SolutionBuilder<OnlyThere>("trouble", name, "Runs elsewhere.")
      .yields(robotlink::kDrivePath);
}
const robotlink::SolutionRegistration kThere[]{onlyThere("none"), onlyThere("segfault"), onlyThere("loop")};

class OwnLogProgramTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TestFolder>();
    test::recordSimulation(logFile(), "compact", 125, [](SimulatedRun& run, int step) {
      if (step == 60) (void)run.request(test::selectRequest("red1", "behavior", "stand"));
    });
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::filesystem::path logFile() { return *folder_ / "own.mcap"; }

  ReplayOptions options(bool own) {
    ReplayOptions options = test::replayOf({{logFile()}});
    options.recomputeAll = options.publishAllPackages = true;
    options.hosting.ownProcesses = own;
    options.own.executable = OWN_PROGRAM_CHILD;
    options.own.patience = std::chrono::seconds(5);
    return options;
  }
  /// A log on which a program in its own process runs with this solution.
  void play(const std::string& solution) {
    ReplayOptions troubled = options(true);
    troubled.layout = folder_->write("trouble.yaml", test::troubleLayout(solution));
    troubled.own.patience = std::chrono::milliseconds(200);
    ReplayRun::Listeners listeners;
    listeners.hosting = [this](const std::string&, robotlink::Instant, const HostingStatus& status) {
      hosting_ = status;
    };
    listeners.queue = [this](const std::string&, const auto&) { ++queues_; };
    auto run = ReplayRun::create(troubled, listeners);
    ASSERT_TRUE(run) << robotlink::describe(run.error());
    run_ = std::move(*run);
  }
  void playUntil(HostingStatus::State state) {
    while (hosting_.state() != state && run_->step()) {
    }
    EXPECT_EQ(hosting_.state(), state);
  }

  static inline std::unique_ptr<TestFolder> folder_;
  HostingStatus hosting_;
  int queues_ = 0;
  std::unique_ptr<ReplayRun> run_;
};

TEST_F(OwnLogProgramTest, itsResultsAreThoseOfAProgramInside) {
  test::Replay inside(options(false)), own(options(true));
  ASSERT_TRUE(inside.run) << robotlink::describe(inside.errors);
  ASSERT_TRUE(own.run) << robotlink::describe(own.errors);
  for (test::Replay* replay : {&inside, &own}) {
    ASSERT_TRUE(replay->run->jump(test::at(0.3)).empty());
    replay->playToEnd();
  }
  std::set<std::string> paths;
  for (const auto& message : inside.reported) paths.insert(message.path);
  EXPECT_GT(paths.size(), 20U);
  EXPECT_TRUE(paths.contains("red1/percepts/ball"));
  for (const std::string& path : paths) {
    // Times that were taken differ.
    if (path.find("timing") != std::string::npos || path.find("tables/processes") != std::string::npos)
      continue;
    EXPECT_EQ(inside.digestOn(path), own.digestOn(path)) << path;
  }
  auto one = inside.status(), other = own.status();
  EXPECT_GT(one.differences_size(), 0);
  EXPECT_EQ(one.DebugString(), other.DebugString());
  EXPECT_EQ(own.troubles, std::vector<std::string>());
}

TEST_F(OwnLogProgramTest, aCrashEndsOnlyTheProgramAndAJumpOrAClickStartsItAgain) {
  play("segfault");
  EXPECT_TRUE(hosting_.own_process());
  playUntil(HostingStatus::ENDED);
  EXPECT_THAT(hosting_.text(), HasSubstr("segmentation fault"));
  EXPECT_THAT(hosting_.text(), HasSubstr("in trouble (segfault) of process worker"));
  EXPECT_TRUE(run_->step()) << "the log goes on";
  ASSERT_TRUE(run_->jump(run_->begin()).empty());
  EXPECT_EQ(hosting_.state(), HostingStatus::RUNNING);
  playUntil(HostingStatus::ENDED);
  ASSERT_TRUE(run_->jump(run_->begin()).empty());
  HostProgram again;
  again.set_start_again(true);
  ASSERT_EQ(robotlink::describe(run_->hostProgram("red1", again)), "");
  EXPECT_EQ(hosting_.state(), HostingStatus::RUNNING);
  const int before = queues_;
  EXPECT_TRUE(run_->step() && run_->step());
  EXPECT_GT(queues_, before);
}

TEST_F(OwnLogProgramTest, anEndlessLoopIsNamedWhileTheLogGoesOn) {
  play("loop");
  playUntil(HostingStatus::NOT_ANSWERING);
  EXPECT_THAT(hosting_.text(), HasSubstr("does not return in trouble (loop) of process worker"));
  EXPECT_TRUE(run_->step());
  ASSERT_TRUE(run_->jump(run_->begin()).empty());
  EXPECT_EQ(hosting_.state(), HostingStatus::RUNNING);
}

TEST_F(OwnLogProgramTest, itIsChosenWhileTheLogIsOpen) {
  ReplayOptions chosen = options(false);
  test::Replay replay(chosen);
  ASSERT_TRUE(replay.run);
  replay.run->step();
  HostProgram own;
  own.set_where(HostProgram::OWN_PROCESS);
  ASSERT_EQ(robotlink::describe(replay.run->hostProgram("", own)), "");
  EXPECT_TRUE(replay.run->options().hosting.ownProcesses);
  replay.playToEnd();
  EXPECT_EQ(replay.troubles, std::vector<std::string>());
  own.set_where(HostProgram::IN_WORKBENCH);
  ASSERT_EQ(robotlink::describe(replay.run->hostProgram("red1", own)), "");
  EXPECT_FALSE(robotlink::describe(replay.run->hostProgram("nobody", own)).empty());
}

}  // namespace
}  // namespace app
