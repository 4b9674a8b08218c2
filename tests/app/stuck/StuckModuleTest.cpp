// SPDX-License-Identifier: GPL-3.0-or-later
// Modules that never return, in programs that run in the workbench: everything else goes on.
#include <gmock/gmock.h>

#include <atomic>
#include <fstream>

#include "app/core/PlatformThread.h"
#include "app/core/program/Abandoned.h"
#include "app/core/simulated/SimulationFeed.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "simcore/Scene.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;
using robotcontrol::Request;
using testing::HasSubstr;

/// Whether the next module that is executed is to hang; and whether those that do may go on.
std::atomic<bool> shallHang{false}, isLetGo{false};
std::atomic<int> hanging{0};

/// Loops until the test releases it.
class StuckModule final : public robotlink::Solution {
 public:
  explicit StuckModule(robotlink::SolutionContext& context)
      : joints_(context.input(robotlink::kJointStates)) {}
  void execute() override {
    if (!shallHang.exchange(false)) return;
    ++hanging;
    isLetGo.wait(false);
    --hanging;
  }

 private:
  robotlink::Input<foxglove::JointStates> joints_;
};
const robotlink::SolutionRegistration kStuckModule =
    robotlink::SolutionBuilder<StuckModule>("stuck-module-test", "hang", "Never returns.")
        .needs(robotlink::kJointStates);

/// Two robots in a simulation, as the window runs it.
class StuckModuleTest : public testing::TestWithParam<ExecutorKind> {
 protected:
  explicit StuckModuleTest(std::chrono::milliseconds patience = 200ms) {
    shallHang = isLetGo = false;
    std::ofstream(layout_)
        << "version: 1\nname: hanging\nhelp: A process that hangs.\n"
           "processes:\n"
           "  - {name: stuck, blocking: [joints/states], tasks: [stuck-module-test: hang]}\n"
           "  - {name: debug, debug: true, period_ms: 16}\n";
    RunOptions options = defaultSimulation();
    options.layout = layout_;
    options.executor = GetParam();
    options.patience = patience;
    options.world.blackout = true;
    options.robots = simcore::RobotsToAdd{.model = "ers210", .count = 1};
    thread_ = std::make_unique<PlatformThread>(session_, recorder_);
    session_.setRequestSink([this](const Request& request) { thread_->request(request); });
    std::atomic<bool> isLoaded{false};
    thread_->open(SimulationFeed::opening(options), {}, [&](const auto& loaded) {
      EXPECT_TRUE(loaded) << robotlink::describe(loaded.error());
      for (const auto& [name, robot] : loaded->robots) robots_.push_back(name);
      isLoaded = true;
    });
    EXPECT_TRUE(eventually([&] { return isLoaded.load(); }));
    Request start;
    start.mutable_control_simulation()->set_action(robotcontrol::ControlSimulation::START);
    start.mutable_control_simulation()->set_speed(1);
    session_.request(start);
  }
  ~StuckModuleTest() override {
    release();
    thread_.reset();
    EXPECT_TRUE(eventually([] { return abandonedCount() == 0; }));
  }
  static void release() {
    isLetGo = true;
    isLetGo.notify_all();
  }
  template <typename Condition>
  bool soon(Condition condition) {
    return eventually([&] {
      session_.tick();
      return condition();
    });
  }
  double time() {
    const auto* status =
        session_.store().latestAs<robotcontrol::SimulationStatus>("simulation", robotlink::Instant::max());
    return status == nullptr ? 0 : status->time();
  }
  const HostingStatus* hosting(const std::string& robot) {
    return session_.store().latestAs<HostingStatus>(robot + "/hosting", robotlink::Instant::max());
  }
  /// The robot whose program does not return; empty: all do.
  std::string stuckRobot() {
    for (const std::string& robot : robots_) {
      const HostingStatus* status = hosting(robot);
      if (status != nullptr && status->state() == HostingStatus::NOT_ANSWERING) return robot;
    }
    return {};
  }
  std::string ask(Request request) {
    std::optional<std::string> answer;
    session_.request(std::move(request), [&](const robotcontrol::RequestResult& result) {
      answer = result.accepted() ? "accepted" : result.reason();
    });
    EXPECT_TRUE(soon([&] { return answer.has_value(); }));
    return answer.value_or("no answer");
  }
  std::string hang() {
    EXPECT_TRUE(soon([&] { return time() > 0.1; }));
    shallHang = true;
    EXPECT_TRUE(soon([&] { return !stuckRobot().empty(); }));
    return stuckRobot();
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
  const std::filesystem::path layout_ = folder_ / "hanging.yaml";
  robotlink::Session session_;
  logplayer::Recorder recorder_{{}};
  std::vector<std::string> robots_;
  std::unique_ptr<PlatformThread> thread_;
};

TEST_P(StuckModuleTest, itIsNamedAndItsRobotStandsWhileAllElseGoesOn) {
  const std::string robot = hang();
  EXPECT_THAT(hosting(robot)->text(), HasSubstr("stuck-module-test (hang) of process stuck"));
  EXPECT_THAT(hosting(robot)->text(), HasSubstr("The robot stands"));
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
  release();
  EXPECT_TRUE(soon([&] { return stuckRobot().empty(); }));
  EXPECT_THAT(hosting(robot)->text(), HasSubstr("has returned and goes on"));
  EXPECT_TRUE(timeGoesOn());
}

TEST_P(StuckModuleTest, theProgramIsStartedAgainWithoutIt) {
  const std::string robot = hang();
  HostProgram again;
  again.set_start_again(true);
  EXPECT_EQ(ask(hostRequest(robot, again)), "accepted");
  EXPECT_TRUE(soon([&] { return stuckRobot().empty(); }));
  EXPECT_TRUE(timeGoesOn());
  EXPECT_EQ(hanging, 1);
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
  std::atomic<bool> isClosed{false};
  thread_->close([&](const auto&) { isClosed = true; });
  EXPECT_TRUE(eventually([&] { return isClosed.load(); }));
  EXPECT_EQ(hanging, 1);
  EXPECT_EQ(abandonedCount(), 1);
}

TEST_P(StuckModuleTest, whatRunsIsEndedWhileItHangs) {
  hang();
  thread_.reset();
  EXPECT_EQ(hanging, 1);
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
  shallHang = true;
  EXPECT_TRUE(eventually([] { return hanging == 1; }));
  Request stop;
  stop.set_robot(robots_.front());
  stop.mutable_stop()->set_engaged(true);
  EXPECT_EQ(ask(stop), "accepted");
  EXPECT_TRUE(soon([&] { return !stuckRobot().empty(); }));
  EXPECT_TRUE(timeGoesOn());
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
