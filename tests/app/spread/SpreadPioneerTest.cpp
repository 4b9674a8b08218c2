// SPDX-License-Identifier: GPL-3.0-or-later
// A Pioneer whose layout is spread over two programs; here both are parts of the test.
#include <gmock/gmock.h>

#include <atomic>
#include <mutex>

#include "app/core/program/Abandoned.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/ShippedFiles.h"
#include "app/core/spread/OtherProgram.h"
#include "app/platforms/pioneer/PioneerOptions.h"
#include "app/platforms/pioneer/PioneerPlatform.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/QueueMessages.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/served/ServedWorld.h"
#include "tests/robotlink/dds/TestNodes.h"

namespace app {
namespace {

/// Planning needs no map: straight to the goal, by the odometry.
const std::map<std::string, std::string> kSolutions{{"path-planning", "direct"},
                                                    {"self-localisation", "wheel-odometry"}};

/// Plans nothing, and does not return while it is told to hang.
class HangingPlan final : public robotlink::Solution {
 public:
  static inline std::atomic<bool> shallHang{false};

  explicit HangingPlan(robotlink::SolutionContext& context) : state_(context.input(robotlink::kDriveState)) {}
  void execute() override { shallHang.wait(true); }
  static void setHanging(bool hanging) {
    shallHang = hanging;
    shallHang.notify_all();
  }

 private:
  robotlink::Input<robotcontrol::DriveState> state_;
};

const robotlink::SolutionRegistration kHangingPlan =
    robotlink::SolutionBuilder<HangingPlan>("spread-test", "hang", "Never returns.")
        .needs(robotlink::kDriveState)
        .yields(robotlink::kDrivePath);

constexpr char kHangingLayout[] =
    "version: 1\nname: hanging\nhelp: A process that hangs in a program of its own.\nprocesses:\n"
    "  - {name: planning, blocking: [drive/state], tasks: [spread-test: hang]}\n"
    "  - name: driving\n    blocking: [drive/state]\n    tasks:\n      - self-localisation: wheel-odometry\n"
    "      - driving: follow-path\n      - obstacle-avoidance: vector-field\n"
    "  - {name: debug, debug: true, period_ms: 16}\n"
    "programs:\n  - {name: plan, processes: [planning]}\n  - {name: drive, processes: [driving, debug]}\n";

class SpreadPioneerTest : public testing::Test {
 protected:
  static SpreadOptions partOf(const std::string& program) {
    return {.program = program, .local = true, .domain = robotlink::test::testDomain()};
  }
  /// The program with the platform and the debug process.
  void startDrive() {
    RealRobotOptions options = pioneerOptions(world_.url(), true);
    options.program.layout = layout_;
    options.program.solutions = solutions_;
    options.program.spread = partOf("drive");
    RealRun::Listeners listeners;
    listeners.queue = [this](const std::string& robot, const auto& queue) {
      const std::lock_guard lock(mutex_);
      ++queues_;
      for (const auto& result : robotlink::messagesOf(robot, *queue, {}).results)
        accepted_ = accepted_ || (result->id() == kGoalId && result->accepted());
    };
    auto run = RealRun::create(options, listeners);
    ASSERT_TRUE(run) << robotlink::describe(run.error());
    run_ = std::move(*run);
  }
  /// The program that knows where the robot is and plans its paths.
  void startPlan() {
    OtherProgram::Parts parts{
        .robot = {.name = "p3at1", .description = *readRobot("p3at"), .field = *readField({})},
        .layout = *readLayoutWith(layout_, solutions_),
        .options = partOf("plan"),
        .platform = [this](const robotlink::Clock& clock) -> std::unique_ptr<robotlink::Platform> {
          return std::make_unique<PioneerPlatform>(clock, "p3at1", **readRobot("p3at"),
                                                   PioneerDriver::Options{.address = world_.url()},
                                                   *PioneerAddress::parse(world_.url()));
        },
        .report =
            [this](const std::string& text) {
              const std::lock_guard lock(mutex_);
              reports_ += text + "\n";
            },
        .patience = std::chrono::milliseconds(300)};
    auto plan = OtherProgram::create(std::move(parts));
    ASSERT_TRUE(plan) << robotlink::describe(plan.error());
    plan_ = std::move(*plan);
  }
  bool playUntil(const std::function<bool()>& happens) {
    return eventually([&] {
      run_->step();
      if (plan_) plan_->look();
      return happens();
    });
  }
  static constexpr std::uint64_t kGoalId = 1;
  /// Asks again until the program that plans is there to receive it.
  bool setGoal(double x) {
    robotcontrol::Request request;
    request.set_id(kGoalId);
    request.set_robot("p3at1");
    request.mutable_set_goal()->mutable_pose_in_field()->set_x(x);
    request.mutable_set_goal()->set_any_heading(true);
    return eventually([&] {
      EXPECT_TRUE(run_->request(request));
      for (int i = 0; i < 10; ++i) {
        run_->step();
        plan_->look();
      }
      const std::lock_guard lock(mutex_);
      return accepted_;
    });
  }
  /// While the program that plans is missing, nobody else would tell it later.
  void cancelGoal() {
    robotcontrol::Request request;
    request.set_id(kGoalId);
    request.set_robot("p3at1");
    request.mutable_set_goal()->set_cancelled(true);
    accepted_ = false;
    EXPECT_TRUE(run_->request(request));
    EXPECT_TRUE(playUntil([this] {
      const std::lock_guard lock(mutex_);
      return accepted_;
    }));
  }
  /// How far it drives while the program publishes so many queues, about a second, m.
  double wayDuring(int queues) {
    const double from = world_.x();
    const auto count = [this] {
      const std::lock_guard lock(mutex_);
      return queues_;
    };
    const int before = count();
    EXPECT_TRUE(playUntil([&] { return count() >= before + queues; }));
    return world_.x() - from;
  }
  bool drivesOn() {
    const double from = world_.x();
    return playUntil([&] { return world_.x() > from + 0.1; });
  }
  bool stands() const { return run_->platform().unattended() && !world_.motorsOn(); }

  std::filesystem::path layout_ = layoutNamed("pioneer-programs");
  std::map<std::string, std::string> solutions_ = kSolutions;
  ServedWorld world_;
  std::mutex mutex_;  // protects what follows
  bool accepted_ = false;
  int queues_ = 0;
  std::string reports_;
  std::unique_ptr<RealRun> run_;
  std::unique_ptr<OtherProgram> plan_;
};

TEST_F(SpreadPioneerTest, itStandsWhileTheProgramThatPlansIsMissingAndThenGoesOnToItsGoal) {
  startDrive();
  EXPECT_TRUE(playUntil([&] { return run_->platform().unattended(); }));
  startPlan();
  ASSERT_TRUE(setGoal(4.5));
  ASSERT_TRUE(drivesOn());
  for (int i = 0; i < 2; ++i) {
    plan_.reset();
    ASSERT_TRUE(playUntil([&] { return stands(); }));
    startPlan();
    ASSERT_TRUE(playUntil([&] { return !stands(); }));
    EXPECT_TRUE(drivesOn());
  }
}

TEST_F(SpreadPioneerTest, itDoesNotGoOnToAGoalThatWasCancelledWhileTheProgramThatPlansWasMissing) {
  startDrive();
  startPlan();
  ASSERT_TRUE(setGoal(4.5));
  ASSERT_TRUE(drivesOn());
  plan_.reset();
  ASSERT_TRUE(playUntil([&] { return stands(); }));
  cancelGoal();
  startPlan();
  ASSERT_TRUE(playUntil([&] { return !stands(); }));
  EXPECT_LT(wayDuring(60), 0.05);
}

TEST_F(SpreadPioneerTest, itStandsWhileAModuleOfTheProgramThatPlansDoesNotReturn) {
  const TestFolder folder;
  layout_ = folder.write("hanging.yaml", kHangingLayout);
  solutions_.clear();
  startDrive();
  startPlan();
  ASSERT_TRUE(playUntil([&] { return !run_->platform().unattended() && world_.motorsOn(); }));
  HangingPlan::setHanging(true);
  EXPECT_TRUE(playUntil([&] { return stands(); }));
  {
    const std::lock_guard lock(mutex_);
    EXPECT_THAT(reports_, testing::HasSubstr("Process planning does not return from spread-test (hang)"));
    EXPECT_THAT(reports_, testing::HasSubstr("gdb -p"));
  }
  HangingPlan::setHanging(false);
  EXPECT_TRUE(playUntil([&] { return !run_->platform().unattended(); }));
}

TEST_F(SpreadPioneerTest, aProgramEndsAlthoughOneOfItsModulesDoesNotReturn) {
  const TestFolder folder;
  layout_ = folder.write("hanging.yaml", kHangingLayout);
  solutions_.clear();
  startDrive();
  startPlan();
  ASSERT_TRUE(playUntil([&] { return !run_->platform().unattended(); }));
  HangingPlan::setHanging(true);
  EXPECT_TRUE(playUntil([&] { return stands(); }));
  plan_.reset();
  EXPECT_EQ(abandonedCount(), 1);
  HangingPlan::setHanging(false);
  EXPECT_TRUE(eventually([] { return abandonedCount() == 0; }));
}

}  // namespace
}  // namespace app
