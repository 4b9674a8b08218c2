// SPDX-License-Identifier: GPL-3.0-or-later
// A module that throws while its robot walks: nobody decides any more where it goes, so it stands.
#include <gmock/gmock.h>

#include <map>
#include <stdexcept>

#include "app/platforms/simulated/SimulatedRun.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Packages.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using robotcontrol::HostingStatus;
using testing::HasSubstr;

/// Walks ahead for three seconds, then throws.
class Failing final : public robotlink::Solution {
 public:
  explicit Failing(robotlink::SolutionContext& context)
      : joints_(context.input(robotlink::kJointStates)), motion_(context.output(robotlink::kMotionRequest)) {}
  void execute() override {
    if (++frames_ > 375) throw std::runtime_error("nothing is where it was");
    auto motion = std::make_shared<robotcontrol::MotionRequest>();
    motion->set_kind(robotcontrol::MotionRequest::WALK);
    motion->mutable_walk()->set_x(0.1);
    motion_.send(std::move(motion));
  }

 private:
  robotlink::Input<foxglove::JointStates> joints_;
  robotlink::Output<robotcontrol::MotionRequest> motion_;
  int frames_ = 0;
};

const robotlink::SolutionRegistration kFailingSolution =
    robotlink::SolutionBuilder<Failing>("failing-test", "fail", "Walks, then throws.")
        .needs(robotlink::kJointStates)
        .yields(robotlink::kMotionRequest);

constexpr char kFailingLayout[] =
    "version: 1\nname: failing\nhelp: A process that throws.\nprocesses:\n"
    "  - {name: think, blocking: [joints/states], tasks: [failing-test: fail]}\n"
    "  - name: move\n    blocking: [joints/states]\n    tasks:\n"
    "      - motion: wheel-model-rectangle\n"
    "  - {name: debug, debug: true, period_ms: 16}\n";

class FailedModuleTest : public testing::Test {
 protected:
  FailedModuleTest() {
    RunOptions options;
    options.scene = robotlink::resource("scenes/field2002.sdf");
    options.layout = folder_.write("failing.yaml", kFailingLayout);
    options.world.blackout = true;
    SimulatedRun::Listeners listeners;
    listeners.hosting = [this](const std::string& robot, robotlink::Instant, const HostingStatus& status) {
      hosting_[robot] = status;
    };
    auto run = SimulatedRun::create(options, listeners);
    if (!run) throw std::runtime_error(robotlink::describe(run.error()));
    run_ = std::move(*run);
    robot_ = run_->robots().front();
  }
  /// How far it goes meanwhile, m.
  double wayDuring(double seconds) {
    const auto place = [this]() -> robotlink::Vector3 {
      return run_->world().simulation().modelPose(robot_)->translation();
    };
    const robotlink::Vector3 before = place();
    const robotlink::Instant end = run_->world().clock().now() + robotlink::fromSeconds(seconds);
    while (run_->world().clock().now() < end) run_->step();
    return (place() - before).norm();
  }

  const TestFolder folder_;
  std::map<std::string, HostingStatus> hosting_;
  std::unique_ptr<SimulatedRun> run_;
  std::string robot_;
};

TEST_F(FailedModuleTest, theRobotStandsUntilItsProgramIsStartedAgain) {
  EXPECT_GT(wayDuring(2.5), 0.1);
  EXPECT_EQ(hosting_[robot_].state(), HostingStatus::RUNNING);
  wayDuring(1.5);
  EXPECT_EQ(hosting_[robot_].state(), HostingStatus::INCOMPLETE);
  EXPECT_THAT(hosting_[robot_].text(), HasSubstr("Process think, which decides what " + robot_ + " does"));
  EXPECT_LT(wayDuring(2), 0.02);
  robotcontrol::HostProgram again;
  again.set_start_again(true);
  ASSERT_EQ(robotlink::describe(run_->hostProgram(robot_, again)), "");
  EXPECT_EQ(hosting_[robot_].state(), HostingStatus::RUNNING);
  EXPECT_GT(wayDuring(2.5), 0.1);
}

}  // namespace
}  // namespace app
