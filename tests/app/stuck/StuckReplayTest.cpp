// SPDX-License-Identifier: GPL-3.0-or-later
// Modules that never return, in programs that run on a log in the workbench: everything else goes on.
#include <gmock/gmock.h>

#include <sstream>

#include "app/platforms/replay/ReplayFeed.h"
#include "app/platforms/replay/ReplayHeadless.h"
#include "robotcontrol/Debugging.pb.h"
#include "simcore/Scene.h"
#include "tests/TestFolder.h"
#include "tests/app/platforms/replay/ReplayFixture.h"
#include "tests/app/stuck/StuckBench.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotcontrol::ControlReplay;
using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;
using robotcontrol::ReplayStatus;
using robotcontrol::Request;
using test::StuckSolution;
using testing::HasSubstr;

/// A log on which a module hangs.
class StuckReplayTest : public test::StuckBench, public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TestFolder>();
    RunOptions options = defaultSimulation();
    options.layout = robotlink::resource("layouts/compact.yaml");
    options.world.blackout = true;
    options.robots = simcore::RobotsToAdd{.model = "ers210", .count = 1};
    test::recordSimulation(*folder_ / "two.mcap", options, 250);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  StuckReplayTest() {
    ReplayOptions options = test::replayOf({{*folder_ / "two.mcap"}});
    options.layout = StuckSolution::writeLayout(folder_->path());
    options.patience = 200ms;
    open(ReplayFeed::opening(options));
  }
  std::int64_t time() {
    const auto* status = latest<ReplayStatus>("replay");
    return status == nullptr ? 0 : status->time();
  }
  std::string act(ControlReplay::Action action, std::int64_t value = 0) {
    Request request;
    auto& control = *request.mutable_control_replay();
    control.set_action(action);
    if (action == ControlReplay::JUMP_TO_TIME) control.set_time(value);
    if (action == ControlReplay::PLAY) control.set_loop(true);
    return ask(request);
  }
  std::string hang() {
    EXPECT_EQ(act(ControlReplay::PLAY), "accepted");
    return hangNow();
  }
  bool timeGoesOn() {
    const auto before = time();
    return soon([&] { return time() != before; });
  }

  static inline std::unique_ptr<TestFolder> folder_;
};

TEST_F(StuckReplayTest, itIsNamedAndTheOtherRobotsGoOn) {
  ASSERT_EQ(robots_.size(), 2U);
  const std::string robot = hang();
  EXPECT_THAT(hosting(robot)->text(), HasSubstr("stuck-test (hang) of process stuck"));
  EXPECT_TRUE(timeGoesOn());
  Request key;
  key.set_robot(robot);
  key.mutable_set_key()->set_name("timing/tasks");
  EXPECT_THAT(ask(key), HasSubstr("does not return"));
  for (const std::string& other : robots_) {
    if (other == robot) continue;
    key.set_robot(other);
    EXPECT_EQ(ask(key), "accepted");
  }
  EXPECT_EQ(act(ControlReplay::PAUSE), "accepted");
}

TEST_F(StuckReplayTest, whenItReturnsTheProgramGoesOn) {
  const std::string robot = hang();
  StuckSolution::release();
  EXPECT_TRUE(soon([&] {
    const auto* status = hosting(robot);
    return status != nullptr && status->state() == HostingStatus::RUNNING;
  }));
  EXPECT_TRUE(timeGoesOn());
}

TEST_F(StuckReplayTest, jumpsAndStartAgainWorkWhileItHangs) {
  hang();
  EXPECT_EQ(act(ControlReplay::PAUSE), "accepted");
  EXPECT_EQ(act(ControlReplay::JUMP_TO_TIME, 0), "accepted");
  EXPECT_TRUE(soon([&] { return stuckRobot().empty(); }));
  EXPECT_EQ(StuckSolution::hanging, 1);
  const std::string robot = hang();
  Request again;
  again.set_robot(robot);
  again.mutable_host_program()->set_start_again(true);
  EXPECT_EQ(ask(again), "accepted");
  EXPECT_TRUE(soon([&] { return stuckRobot().empty(); }));
  EXPECT_EQ(StuckSolution::hanging, 2);
  EXPECT_TRUE(timeGoesOn());
  again.mutable_host_program()->set_executor(HostProgram::THREADS);
  EXPECT_THAT(ask(again), HasSubstr("programs on logs run in lockstep"));
}

TEST_F(StuckReplayTest, withoutAWindowTheReplayEndsAndNamesIt) {
  HeadlessChoices choices{.platform = "log:" + (*folder_ / "two.mcap").string(),
                          .layout = StuckSolution::writeLayout(folder_->path())};
  choices.options.values["patience"] = 0.2;
  const auto run = headlessReplay().prepare(choices);
  ASSERT_TRUE(run) << run.error().text;
  std::ostringstream errors;
  const HeadlessConsole console{errors, [] { return false; }, [](double) { return true; },
                                [](const std::string& source) { return std::filesystem::path(source); }};
  StuckSolution::shallHang = true;
  const auto summary = (*run)(console);
  ASSERT_TRUE(summary) << robotlink::describe(summary.error());
  EXPECT_EQ(summary->status, kFailed);
  EXPECT_THAT(errors.str(), HasSubstr("stuck-test (hang) of process stuck"));
  EXPECT_THAT(errors.str(), HasSubstr("The replay ends here"));
  EXPECT_EQ(StuckSolution::hanging, 1);
}

TEST_F(StuckReplayTest, theLogIsClosedWhileItHangs) {
  hang();
  expectThatItClosesWhileOneHangs();
}

TEST_F(StuckReplayTest, whatRunsIsEndedWhileItHangs) {
  hang();
  thread_.reset();
  EXPECT_EQ(StuckSolution::hanging, 1);
}

}  // namespace
}  // namespace app
