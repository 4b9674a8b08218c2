// SPDX-License-Identifier: GPL-3.0-or-later
// Modules that never return, in programs that run in the workbench: everything else goes on.
#include <gmock/gmock.h>

#include "app/platforms/simulated/SimulationFeed.h"
#include "robotcontrol/Debugging.pb.h"
#include "simcore/Scene.h"
#include "tests/TestFolder.h"
#include "tests/app/stuck/StuckBench.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;
using robotcontrol::Request;
using test::StuckSolution;
using testing::HasSubstr;

/// A simulation in which a module hangs.
class StuckModuleTest : public test::StuckBench, public testing::TestWithParam<ExecutorKind> {
 protected:
  explicit StuckModuleTest(std::chrono::milliseconds patience = 200ms) {
    RunOptions options = defaultSimulation();
    options.layout = StuckSolution::writeLayout(folder_.path());
    options.hosting.threads = GetParam() == ExecutorKind::kThreads;
    options.patience = patience;
    options.world.blackout = true;
    options.robots = simcore::RobotsToAdd{.model = "ers210", .count = 1};
    open(SimulationFeed::opening(options));
    Request start;
    start.mutable_control_simulation()->set_action(robotcontrol::ControlSimulation::START);
    start.mutable_control_simulation()->set_speed(1);
    session_.request(start);
  }
  double time() {
    const auto* status = latest<robotcontrol::SimulationStatus>("simulation");
    return status == nullptr ? 0 : status->time();
  }
  std::string hang() {
    EXPECT_TRUE(soon([&] { return time() > 0.1; }));
    return hangNow();
  }
  bool timeGoesOn() {
    const double before = time();
    return soon([&] { return time() > before + 0.2; });
  }
  Request hostRequest(const std::string& robot, const HostProgram& choice) {
    Request request;
    request.set_robot(robot);
    *request.mutable_host_program() = choice;
    return request;
  }

  const TestFolder folder_;
};

TEST_P(StuckModuleTest, itIsNamedAndItsRobotStandsWhileAllElseGoesOn) {
  const std::string robot = hang();
  EXPECT_THAT(hosting(robot)->text(), HasSubstr("stuck-test (hang) of process stuck"));
  EXPECT_THAT(hosting(robot)->text(), HasSubstr("The robot stays stopped"));
  EXPECT_TRUE(timeGoesOn());
  for (const std::string& other : robots_) {
    Request stop;
    stop.set_robot(other);
    stop.mutable_stop()->set_engaged(true);
    EXPECT_EQ(ask(stop), "accepted");
    EXPECT_EQ(hosting(other)->state() == HostingStatus::RUNNING, other != robot);
  }
  Request key;
  key.set_robot(robot);
  key.mutable_set_key()->set_name("timing/tasks");
  EXPECT_THAT(ask(key), HasSubstr("does not return"));
}

TEST_P(StuckModuleTest, whenItReturnsTheProgramGoesOn) {
  const std::string robot = hang();
  StuckSolution::release();
  EXPECT_TRUE(soon([&] { return stuckRobot().empty(); }));
  EXPECT_THAT(hosting(robot)->text(), HasSubstr("has returned and continues"));
  EXPECT_TRUE(timeGoesOn());
}

TEST_P(StuckModuleTest, theProgramIsStartedAgainWithoutIt) {
  const std::string robot = hang();
  HostProgram again;
  again.set_start_again(true);
  EXPECT_EQ(ask(hostRequest(robot, again)), "accepted");
  EXPECT_TRUE(soon([&] { return stuckRobot().empty(); }));
  EXPECT_TRUE(timeGoesOn());
  EXPECT_EQ(StuckSolution::hanging, 1);
  // Another one hangs, and the world is reset.
  hang();
  Request reset;
  reset.mutable_control_simulation()->set_action(robotcontrol::ControlSimulation::RESET);
  reset.mutable_control_simulation()->set_speed(-1);
  EXPECT_EQ(ask(reset), "accepted");
  EXPECT_TRUE(soon([&] { return stuckRobot().empty(); }));
}

TEST_P(StuckModuleTest, theSimulationIsClosedWhileItHangs) {
  hang();
  expectThatItClosesWhileOneHangs();
}

TEST_P(StuckModuleTest, whatRunsIsEndedWhileItHangs) {
  hang();
  thread_.reset();
  EXPECT_EQ(StuckSolution::hanging, 1);
}

INSTANTIATE_TEST_SUITE_P(Executors, StuckModuleTest,
                         testing::Values(ExecutorKind::kLockstep, ExecutorKind::kThreads),
                         [](const auto& tested) { return nameOf(tested.param); });

/// How processes are executed, chosen while they are.
class ExecutorChoiceTest : public StuckModuleTest {};

TEST_P(ExecutorChoiceTest, itIsChosenWhileTheSimulationRuns) {
  HostProgram threads, lockstep;
  threads.set_executor(HostProgram::THREADS);
  lockstep.set_executor(HostProgram::LOCKSTEP);
  const std::string robot = robots_.front();
  EXPECT_TRUE(soon([&] { return hosting(robot) != nullptr && !hosting(robot)->threads(); }));
  EXPECT_EQ(ask(hostRequest("", threads)), "accepted");
  EXPECT_TRUE(soon([&] { return hosting(robot)->threads(); }));
  EXPECT_TRUE(timeGoesOn());
  EXPECT_EQ(ask(hostRequest("", lockstep)), "accepted");
  EXPECT_TRUE(soon([&] { return !hosting(robot)->threads(); }));
  EXPECT_TRUE(timeGoesOn());
}

INSTANTIATE_TEST_SUITE_P(Executors, ExecutorChoiceTest, testing::Values(ExecutorKind::kLockstep),
                         [](const auto& tested) { return nameOf(tested.param); });

/// Modules that are waited for so long that nobody would wait for it.
class StopWhileItHangsTest : public StuckModuleTest {
 protected:
  StopWhileItHangsTest() : StuckModuleTest(10min) {}
};

TEST_P(StopWhileItHangsTest, stopIsNotKeptWaiting) {
  EXPECT_TRUE(soon([&] { return time() > 0.1; }));
  StuckSolution::shallHang = true;
  EXPECT_TRUE(eventually([] { return StuckSolution::hanging == 1; }));
  Request stop;
  stop.set_robot(robots_.front());
  stop.mutable_stop()->set_engaged(true);
  EXPECT_EQ(ask(stop), "accepted");
  EXPECT_TRUE(soon([&] { return !stuckRobot().empty(); }));
  EXPECT_TRUE(timeGoesOn());
}

TEST_P(StopWhileItHangsTest, closingIsNotKeptWaitingHoweverManyHang) {
  EXPECT_TRUE(soon([&] { return time() > 0.1; }));
  StuckSolution::shallHang = true;
  EXPECT_TRUE(eventually([] { return StuckSolution::hanging == 1; }));
  // The next one may get its turn before the simulation ends.
  StuckSolution::shallHang = true;
  std::atomic<bool> isClosed{false};
  thread_->close([&](const auto&) { isClosed = true; });
  EXPECT_TRUE(eventually([&] { return isClosed.load(); }));
  EXPECT_EQ(abandonedCount(), 1);
}

TEST_P(StopWhileItHangsTest, theEndOfTheWindowIsNotKeptWaiting) {
  EXPECT_TRUE(soon([&] { return time() > 0.1; }));
  StuckSolution::shallHang = true;
  EXPECT_TRUE(eventually([] { return StuckSolution::hanging == 1; }));
  thread_.reset();
  EXPECT_EQ(abandonedCount(), 1);
}

INSTANTIATE_TEST_SUITE_P(Executors, StopWhileItHangsTest, testing::Values(ExecutorKind::kLockstep),
                         [](const auto& tested) { return nameOf(tested.param); });

TEST(GuardedLockstep, givesTheSameBytesAsWithoutGuard) {
  const auto digestAfter = [](std::chrono::milliseconds patience) {
    RunOptions options = defaultSimulation();
    options.patience = patience;
    options.robots = simcore::RobotsToAdd{.model = "ers210", .count = 1};
    const auto run = SimulatedRun::create(options, {});
    for (int i = 0; i < 250; ++i) (*run)->step();
    return (*run)->world().digest();
  };
  EXPECT_EQ(digestAfter(0ms), digestAfter(30s));
}

}  // namespace
}  // namespace app
