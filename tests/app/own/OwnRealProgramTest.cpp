// SPDX-License-Identifier: GPL-3.0-or-later
// The program of a Pioneer at the end of a line, in a process of its own: in real time, with threads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <mutex>

#include "app/platforms/pioneer/PioneerOptions.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/session/QueueMessages.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/own/TroubleLayout.h"
#include "tests/app/served/ServedWorld.h"

namespace {

using namespace app;
using namespace std::chrono_literals;
using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;
using testing::HasSubstr;

class OwnRealProgramTest : public testing::Test {
 protected:
  void play(const std::string& solution, bool own = true) {
    layout_ = folder_.write("trouble.yaml", test::troubleLayout(solution, otherProcesses_));
    playLayout(layout_, own);
  }
  void playLayout(const std::filesystem::path& layout, bool own = true) {
    RealRobotOptions options = pioneerOptions(world_.url(), motors_);
    options.program.layout = layout;
    options.program.solutions = solutions_;
    options.program.hosting.ownProcesses = own;
    options.program.own.executable = OWN_PROGRAM_CHILD;
    options.program.own.patience = 300ms;
    options.program.own.memoryLimit = std::uint64_t{512} << 20U;  // quicker to fill than the usual one
    auto run = RealRun::create(options, listeners());
    ASSERT_TRUE(run) << robotlink::describe(run.error());
    run_ = std::move(*run);
  }
  RealRun::Listeners listeners() {
    return {.queue =
                [this](const std::string& robot, const auto& queue) {
                  const std::lock_guard lock(mutex_);
                  ++queues_;
                  for (auto& message :
                       robotlink::messagesOf(robot, *queue, {}, robotlink::QueueReader::kViews).messages) {
                    newest_[message.path] = message.value;
                  }
                },
            .trouble =
                [this](const std::string&, const robotlink::Process&, const std::string& text) {
                  const std::lock_guard lock(mutex_);
                  troubles_ += text + "\n";
                },
            .platform = {},
            .overridden = {},
            .hosting = [this](const std::string&, robotlink::Instant,
                              const HostingStatus& status) { hosting_ = status; }};
  }
  bool playUntil(const std::function<bool()>& happens) {
    return eventually([&] {
      run_->step();
      return happens();
    });
  }
  bool isConnected() const { return run_->platform().isConnected(); }
  int queues() {
    const std::lock_guard lock(mutex_);
    return queues_;
  }
  template <typename T>
  std::shared_ptr<const T> newest(const std::string& path) {
    const std::lock_guard lock(mutex_);
    const auto found = newest_.find(path);
    return found == newest_.end() ? nullptr : std::dynamic_pointer_cast<const T>(found->second);
  }
  robotcontrol::Request request() const {
    robotcontrol::Request request;
    request.set_robot("p3at1");
    return request;
  }
  void switchOn(const std::string& key) {
    auto asked = request();
    asked.mutable_set_key()->set_name(key);
    asked.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    EXPECT_TRUE(run_->request(asked));
  }
  /// Goals need no map here: straight on, by the odometry.
  void driveToGoal(double x, bool own) {
    solutions_ = {{"path-planning", "direct"}, {"self-localisation", "wheel-odometry"}};
    motors_ = true;
    playLayout(robotlink::resource("layouts/pioneer.yaml"), own);
    auto goal = request();
    goal.mutable_set_goal()->mutable_pose_in_field()->set_x(x);
    goal.mutable_set_goal()->set_any_heading(true);
    ASSERT_TRUE(run_->request(goal));
  }
  bool drivesOn() {
    const double from = world_.x();
    return playUntil([&] { return world_.x() > from + 0.1; });
  }
  void startAgain() {
    HostProgram again;
    again.set_start_again(true);
    choose(again);
  }
  void choose(const HostProgram& choice) {
    ASSERT_EQ(robotlink::describe(run_->hostProgram("p3at1", choice)), "");
  }
  /// Whether the program ended, and the robot stands but is still there.
  bool onlyTheProgramEnds() {
    return playUntil([&] { return hosting_.state() == HostingStatus::ENDED; }) &&
           run_->platform().unattended() && playUntil([&] { return isConnected(); });
  }

  ServedWorld world_;
  const TestFolder folder_;
  std::filesystem::path layout_;
  /// Further processes of a layout with trouble, each with its lines.
  std::string otherProcesses_;
  std::map<std::string, std::string> solutions_;
  bool motors_ = false;
  std::mutex mutex_;  // protects the next three
  std::map<std::string, std::shared_ptr<const google::protobuf::Message>> newest_;
  int queues_ = 0;
  std::string troubles_;
  HostingStatus hosting_;
  std::unique_ptr<RealRun> run_;
};

TEST_F(OwnRealProgramTest, itDrivesTheRobotAsAProgramInsideDoes) {
  playLayout(robotlink::resource("layouts/pioneer.yaml"));
  EXPECT_TRUE(hosting_.own_process());
  EXPECT_TRUE(hosting_.threads());
  switchOn("package/drive/state");
  ASSERT_TRUE(playUntil([&] { return isConnected(); }));
  auto solution = request();
  solution.mutable_select_solution()->set_task("driving");
  solution.mutable_select_solution()->set_solution("obey");
  ASSERT_TRUE(run_->request(solution));
  auto motors = request();
  motors.mutable_control_drive()->set_motors(true);
  ASSERT_TRUE(run_->request(motors));
  EXPECT_TRUE(playUntil([&] {
    auto motion = request();
    motion.mutable_motion()->mutable_motion()->set_kind(robotcontrol::MotionRequest::WALK);
    motion.mutable_motion()->mutable_motion()->mutable_walk()->set_x(0.2);
    EXPECT_TRUE(run_->request(motion));
    const auto state = newest<robotcontrol::DriveState>("p3at1/drive/state");
    return state && state->velocity().x() > 0.1;
  }));
}

TEST_F(OwnRealProgramTest, aCrashEndsOnlyTheProgram) {
  play("segfault");
  ASSERT_TRUE(onlyTheProgramEnds());
  EXPECT_THAT(hosting_.text(), HasSubstr("segmentation fault"));
  EXPECT_THAT(hosting_.text(), HasSubstr("in trouble (segfault) of process worker"));
  EXPECT_THAT(hosting_.stack(), HasSubstr("robotlink::TaskRunner::execute"));
  auto tables = request();
  tables.mutable_send_tables();
  EXPECT_FALSE(run_->request(tables));
}

TEST_F(OwnRealProgramTest, aProgramThatEndedIsStartedAgain) {
  play("none");
  ASSERT_TRUE(playUntil([&] { return queues() > 0; }));
  ASSERT_EQ(::kill(static_cast<pid_t>(hosting_.pid()), SIGKILL), 0);
  ASSERT_TRUE(onlyTheProgramEnds());
  HostProgram again;
  again.set_start_again(true);
  choose(again);
  EXPECT_EQ(hosting_.state(), HostingStatus::RUNNING);
  const int before = queues();
  EXPECT_TRUE(playUntil([&] { return queues() > before; }));
  EXPECT_TRUE(isConnected()) << "the robot stayed connected";
}

TEST_F(OwnRealProgramTest, aProgramThatIsStartedAgainGoesOnToItsGoalUnlessThatWasCancelled) {
  driveToGoal(4.5, true);
  ASSERT_TRUE(drivesOn());
  ASSERT_EQ(::kill(static_cast<pid_t>(hosting_.pid()), SIGKILL), 0);
  ASSERT_TRUE(onlyTheProgramEnds());
  startAgain();
  ASSERT_TRUE(drivesOn());
  ASSERT_EQ(::kill(static_cast<pid_t>(hosting_.pid()), SIGKILL), 0);
  ASSERT_TRUE(onlyTheProgramEnds());
  auto cancelled = request();
  cancelled.mutable_set_goal()->set_cancelled(true);
  const auto refused = run_->request(cancelled);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("its goal is forgotten"));
  startAgain();
  ASSERT_TRUE(playUntil([&] { return world_.motorsOn(); }));
  const double from = world_.x();
  const int before = queues();
  ASSERT_TRUE(playUntil([&] { return queues() > before + 60; }));
  EXPECT_LT(world_.x() - from, 0.05);
}

TEST_F(OwnRealProgramTest, aProgramThatMovesToItsOwnProcessGoesOnToItsGoal) {
  driveToGoal(4.5, false);
  ASSERT_TRUE(drivesOn());
  HostProgram own;
  own.set_where(HostProgram::OWN_PROCESS);
  choose(own);
  EXPECT_TRUE(drivesOn());
}

TEST_F(OwnRealProgramTest, abortAndExitEndOnlyTheProgram) {
  play("abort");
  ASSERT_TRUE(onlyTheProgramEnds());
  EXPECT_THAT(hosting_.text(), HasSubstr("was aborted (signal SIGABRT) in trouble (abort)"));
  run_.reset();
  play("exit");
  ASSERT_TRUE(onlyTheProgramEnds());
  EXPECT_THAT(hosting_.text(), HasSubstr("called exit(3) in trouble (exit)")) << hosting_.stack();
}

TEST_F(OwnRealProgramTest, whatCrashesWhileAModuleExitsIsNotTheReason) {
  play("exit-among-others");
  ASSERT_TRUE(onlyTheProgramEnds());
  EXPECT_THAT(hosting_.text(), HasSubstr("called exit(3) in trouble (exit-among-others)"))
      << hosting_.stack();
}

TEST_F(OwnRealProgramTest, aModuleThatTakesAllMemoryIsStopped) {
#ifdef ROBOTCONTROL_SANITIZED
  GTEST_SKIP() << "sanitizers need more memory than a program is left";
#endif
  otherProcesses_ = test::kTroubleDriver;
  play("memory");
  EXPECT_TRUE(playUntil([&] {
    const std::lock_guard lock(mutex_);
    return troubles_.find("trouble (memory): std::bad_alloc") != std::string::npos;
  })) << hosting_.text();
  // Allocating so much may have taken longer than the patience.
  EXPECT_TRUE(playUntil([&] { return hosting_.state() == HostingStatus::INCOMPLETE; }));
  EXPECT_THAT(hosting_.text(), HasSubstr("Process worker, which decides what p3at1 does"));
  EXPECT_TRUE(run_->platform().unattended());
}

TEST_F(OwnRealProgramTest, anEndlessLoopIsNamedTheRestGoesOnAndTheRobotStands) {
  play("loop");
  ASSERT_TRUE(playUntil([&] { return hosting_.state() == HostingStatus::NOT_ANSWERING; }));
  EXPECT_THAT(hosting_.text(), HasSubstr("does not return from trouble (loop) of process worker"));
  EXPECT_THAT(hosting_.text(), HasSubstr("gdb -p " + std::to_string(hosting_.pid())));
  EXPECT_THAT(hosting_.stack(), HasSubstr("robotlink::TaskRunner::execute")) << "of its thread";
  EXPECT_TRUE(run_->platform().unattended());
  const int before = queues();
  EXPECT_TRUE(playUntil([&] { return queues() > before; })) << "its other processes go on";
  HostProgram again;
  again.set_start_again(true);
  choose(again);
  EXPECT_EQ(hosting_.state(), HostingStatus::RUNNING);
}

TEST_F(OwnRealProgramTest, aProgramThatReturnsLateGoesOn) {
  play("very-late");
  ASSERT_TRUE(playUntil([&] { return hosting_.state() == HostingStatus::NOT_ANSWERING; }));
  EXPECT_TRUE(playUntil([&] { return hosting_.state() == HostingStatus::RUNNING; }));
  EXPECT_THAT(hosting_.text(), HasSubstr("has returned and continues"));
  EXPECT_FALSE(run_->platform().unattended());
}

TEST_F(OwnRealProgramTest, aProgramThatIsHeldIsSilentAndThenAnswersAgain) {
  play("none");
  ASSERT_TRUE(playUntil([&] { return queues() > 0; }));
  const auto pid = static_cast<pid_t>(hosting_.pid());
  ASSERT_EQ(::kill(pid, SIGSTOP), 0);
  ASSERT_TRUE(playUntil([&] { return hosting_.state() == HostingStatus::NOT_ANSWERING; }));
  EXPECT_THAT(hosting_.text(), HasSubstr("has not answered for"));
  ASSERT_EQ(::kill(pid, SIGCONT), 0);
  EXPECT_TRUE(playUntil([&] { return hosting_.state() == HostingStatus::RUNNING; }));
}

TEST_F(OwnRealProgramTest, itMovesBetweenTheWorkbenchAndItsOwnProcess) {
  playLayout(robotlink::resource("layouts/pioneer.yaml"), false);
  EXPECT_FALSE(hosting_.own_process());
  ASSERT_TRUE(playUntil([&] { return isConnected(); }));
  switchOn("package/range/sonar");
  HostProgram own;
  own.set_where(HostProgram::OWN_PROCESS);
  choose(own);
  EXPECT_TRUE(hosting_.own_process());
  {
    const std::lock_guard lock(mutex_);
    newest_.clear();
  }
  EXPECT_TRUE(playUntil([&] { return newest<robotcontrol::SonarReadings>("p3at1/range/sonar") != nullptr; }))
      << "the user's overrides are kept";
  own.set_where(HostProgram::IN_WORKBENCH);
  choose(own);
  EXPECT_FALSE(hosting_.own_process());
  HostProgram lockstep;
  lockstep.set_executor(HostProgram::LOCKSTEP);
  EXPECT_THAT(robotlink::describe(run_->hostProgram("", lockstep)), HasSubstr("have a thread each"));
}

}  // namespace
