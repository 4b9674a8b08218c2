// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/OwnProgram.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <map>

#include "app/core/own/CrashReport.h"
#include "app/core/own/SpareChild.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/own/TroubleLayout.h"

using namespace app;
using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;
using ::testing::HasSubstr;

namespace {

/// What the programs of a run tell.
struct ProgramEars {
  std::map<std::string, std::string> queues;  // the bytes of all, by robot
  std::map<std::string, HostingStatus> hosting;
  std::vector<std::string> troubles;

  SimulatedRun::Listeners listeners() {
    return {.queue = [this](const std::string& robot,
                            const auto& queue) { queues[robot] += toWire(*queue).SerializeAsString(); },
            .trouble = [this](const std::string&, const robotlink::Process&,
                              const std::string& text) { troubles.push_back(text); },
            .labeled = {},
            .ports = {},
            .game = {},
            .platform = {},
            .hosting = [this](const std::string& robot, robotlink::Instant,
                              const HostingStatus& status) { hosting[robot] = status; }};
  }
};

robotcontrol::Request requestTo(const std::string& robot) {
  static std::uint64_t id = 0;
  robotcontrol::Request request;
  request.set_id(++id);
  request.set_robot(robot);
  return request;
}

void switchOn(SimulatedRun& run, const std::string& robot, const std::string& key) {
  auto request = requestTo(robot);
  request.clear_id();
  request.mutable_set_key()->set_name(key);
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  EXPECT_TRUE(run.request(request));
}

RunOptions soccer(bool own) {
  RunOptions options = defaultSimulation();
  options.hosting.ownProcesses = own;
  options.own.executable = OWN_PROGRAM_CHILD;
  return options;
}

class OwnProgramTest : public ::testing::Test {
 protected:
  /// A world with two Pioneers, the first of which has a program with this solution.
  void play(const std::string& solution, std::chrono::milliseconds patience = std::chrono::seconds(5)) {
    RunOptions options;
    options.scene = robotlink::resource("scenes/house.map");
    options.robots = simcore::RobotsToAdd{.model = "p3at", .count = 2};
    options.layout = folder_.write("trouble.yaml", test::troubleLayout(solution, otherProcesses_));
    options.hosting.ownProcesses = true;
    options.hosting.threads = executor_ == ExecutorKind::kThreads;
    options.own.executable = OWN_PROGRAM_CHILD;
    options.own.patience = patience;
    options.own.memoryLimit = std::uint64_t{512} << 20U;  // quicker to fill than the usual one
    auto run = SimulatedRun::create(options, ears_.listeners());
    if (!run) errors_ = run.error();
    if (run) run_ = std::move(*run);
    if (!run_) return;
    first_ = run_->robots()[0];
    EXPECT_EQ(state(), HostingStatus::RUNNING);
    EXPECT_NE(status().pid(), 0U);
  }
  const HostingStatus& status() { return ears_.hosting[first_]; }
  HostingStatus::State state() { return status().state(); }
  void steps(int count) {
    while (count-- > 0) run_->step();
  }
  /// Steps until its state changes, and says whether the world went on then.
  bool goesOnAfter(HostingStatus::State changed) {
    for (int i = 0; i < 20 && state() != changed; ++i) run_->step();
    EXPECT_EQ(state(), changed);
    return worldGoesOn();
  }
  bool worldGoesOn() {
    const auto before = run_->world().clock().now();
    steps(20);
    return run_->world().clock().now() == before + 20 * SimulatedWorld::kStep;
  }

  /// Further processes of that layout, each with its lines.
  std::string otherProcesses_;
  TestFolder folder_;
  ExecutorKind executor_ = ExecutorKind::kLockstep;
  ProgramEars ears_;
  std::unique_ptr<SimulatedRun> run_;
  robotlink::Errors errors_;
  std::string first_;
};

/// The same programs with a thread for each of their processes, for which the world does not wait.
class OwnThreadsProgramTest : public OwnProgramTest {
 protected:
  OwnThreadsProgramTest() { executor_ = ExecutorKind::kThreads; }
  template <typename Condition>
  bool stepsUntil(Condition condition) {
    return eventually([&] {
      run_->step();
      return condition();
    });
  }
  bool publishes(const std::string& robot) {
    const auto before = ears_.queues[robot].size();
    return stepsUntil([&] { return ears_.queues[robot].size() > before; });
  }
};

}  // namespace

TEST(OwnProgram, itsBytesAreThoseOfAProgramInside) {
  std::map<std::string, std::string> told[2];
  std::uint64_t digests[2];
  for (const bool own : {false, true}) {
    ProgramEars ears;
    auto run = SimulatedRun::create(soccer(own), ears.listeners());
    ASSERT_TRUE(run) << robotlink::describe(run.error());
    for (const std::string& robot : (*run)->robots()) {
      for (const char* key : {"package/camera/image", "package/oracle/classes", "package/models/ball"})
        switchOn(**run, robot, key);
    }
    for (int i = 0; i < 125; ++i) (*run)->step();
    digests[own] = (*run)->world().digest();
    told[own] = ears.queues;
    for (const std::string& robot : (*run)->robots()) EXPECT_EQ(ears.hosting[robot].own_process(), own);
  }
  EXPECT_EQ(digests[0], digests[1]);
  ASSERT_FALSE(told[0].empty());
  for (const auto& [robot, bytes] : told[0]) {
    EXPECT_GT(bytes.size(), 100'000U);
    EXPECT_TRUE(bytes == told[1][robot]) << robot << ": " << bytes.size() << " " << told[1][robot].size();
  }
}

TEST_F(OwnProgramTest, aSegmentationFaultEndsOnlyThatProgram) {
  play("segfault");
  EXPECT_TRUE(goesOnAfter(HostingStatus::ENDED));
  EXPECT_THAT(status().text(), HasSubstr("segmentation fault"));
  EXPECT_THAT(status().text(), HasSubstr("in trouble (segfault) of process worker"));
  EXPECT_THAT(status().stack(), HasSubstr("robotlink::TaskRunner::execute"));
  EXPECT_EQ(status().pid(), 0U);
}

TEST_F(OwnProgramTest, abortEndsOnlyThatProgram) {
  play("abort");
  EXPECT_TRUE(goesOnAfter(HostingStatus::ENDED));
  EXPECT_THAT(status().text(), HasSubstr("was aborted (signal SIGABRT) in trouble (abort)"));
}

TEST_F(OwnProgramTest, exitEndsOnlyThatProgram) {
  play("exit");
  EXPECT_TRUE(goesOnAfter(HostingStatus::ENDED));
  EXPECT_THAT(status().text(), HasSubstr("called exit(3) in trouble (exit)"));
}

TEST_F(OwnProgramTest, aModuleThatTakesAllMemoryIsStopped) {
#ifdef ROBOTCONTROL_SANITIZED
  GTEST_SKIP() << "sanitizers need more memory than a program is left";
#endif
  otherProcesses_ = test::kTroubleDriver;
  play("memory");
  ASSERT_TRUE(run_);
  // On a machine that does other things, too, it may seem not to answer while it fills the memory.
  EXPECT_TRUE(eventually([&] {
    run_->step();
    return state() == HostingStatus::INCOMPLETE;
  }));
  EXPECT_TRUE(worldGoesOn());
  ASSERT_FALSE(ears_.troubles.empty());
  EXPECT_THAT(ears_.troubles, testing::Contains(HasSubstr("trouble (memory): std::bad_alloc")));
  EXPECT_THAT(status().text(), HasSubstr("Process worker, which decides what " + first_ + " does"));
  EXPECT_THAT(status().text(), HasSubstr("The robot stays stopped"));
  HostProgram again;
  again.set_start_again(true);
  ASSERT_EQ(robotlink::describe(run_->hostProgram(first_, again)), "");
  EXPECT_EQ(state(), HostingStatus::RUNNING);
}

TEST_F(OwnProgramTest, anEndlessLoopIsNamedAndTheRobotStands) {
  play("loop", std::chrono::milliseconds(100));
  EXPECT_TRUE(goesOnAfter(HostingStatus::NOT_ANSWERING));
  EXPECT_THAT(status().text(), HasSubstr("does not return in trouble (loop) of process worker"));
  EXPECT_THAT(status().text(), HasSubstr("gdb -p " + std::to_string(status().pid())));
  auto request = requestTo(first_);
  request.mutable_send_tables();
  const auto refused = run_->request(request);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("does not answer"));
}

TEST_F(OwnProgramTest, severalThatHangAreWaitedForTogether) {
  constexpr double kPatience = 2;
  play("loop", std::chrono::milliseconds(2000));
  ASSERT_TRUE(run_);
  EXPECT_TRUE(goesOnAfter(HostingStatus::NOT_ANSWERING));
  for (const std::string& robot : run_->robots()) {
    const std::string text = ears_.hosting[robot].text();
    const std::string before = "has not answered for ";
    ASSERT_THAT(text, HasSubstr(before));
    EXPECT_LT(std::stod(text.substr(text.find(before) + before.size())), 2 * kPatience) << robot;
  }
}

TEST_F(OwnProgramTest, aProgramThatAnswersLateGoesOn) {
  play("late", std::chrono::milliseconds(50));
  for (int i = 0; i < 20 && state() == HostingStatus::RUNNING; ++i) run_->step();
  ASSERT_EQ(state(), HostingStatus::NOT_ANSWERING);
  EXPECT_TRUE(eventually([this] {
    run_->step();
    return state() == HostingStatus::RUNNING;
  }));
  const auto before = ears_.queues[first_].size();
  steps(20);
  EXPECT_GT(ears_.queues[first_].size(), before);
}

TEST_F(OwnProgramTest, aProgramThatEndedIsStartedAgainWhileOthersGoOn) {
  play("segfault");
  ASSERT_TRUE(goesOnAfter(HostingStatus::ENDED));
  run_.reset();
  play("none");
  const auto other = run_->robots()[1];
  const auto pid = ears_.hosting[other].pid(), before = status().pid();
  ASSERT_EQ(::kill(static_cast<pid_t>(before), SIGKILL), 0);
  ASSERT_TRUE(goesOnAfter(HostingStatus::ENDED));
  EXPECT_THAT(status().text(), HasSubstr("was killed"));
  HostProgram again;
  again.set_start_again(true);
  ASSERT_EQ(robotlink::describe(run_->hostProgram(first_, again)), "");
  EXPECT_EQ(state(), HostingStatus::RUNNING);
  EXPECT_NE(status().pid(), before);
  EXPECT_EQ(ears_.hosting[other].pid(), pid);
  ears_.queues.clear();
  steps(20);
  EXPECT_FALSE(ears_.queues[first_].empty());
  EXPECT_FALSE(ears_.queues[other].empty());
}

TEST_F(OwnProgramTest, aProgramThatCannotBeMadeIsRefusedWithTheReason) {
  play("unmakeable");
  ASSERT_FALSE(run_);
  EXPECT_THAT(robotlink::describe(errors_), HasSubstr("was aborted (signal SIGABRT) while its solutions"));
  play("misspelled");
  ASSERT_FALSE(run_);
  EXPECT_THAT(robotlink::describe(errors_), HasSubstr("misspelled"));
  EXPECT_THAT(robotlink::describe(errors_), HasSubstr("trouble.yaml:"));
}

TEST(OwnProgram, programsMoveBetweenProcessesWithTheUsersOverrides) {
  ProgramEars ears;
  auto run = SimulatedRun::create(soccer(false), ears.listeners());
  ASSERT_TRUE(run) << robotlink::describe(run.error());
  switchOn(**run, "red1", "package/joints/states");
  (*run)->step();
  HostProgram choice;
  choice.set_where(HostProgram::OWN_PROCESS);
  ASSERT_EQ(robotlink::describe((*run)->hostProgram("red1", choice)), "");
  EXPECT_TRUE(ears.hosting["red1"].own_process());
  ears.queues.clear();
  for (int i = 0; i < 50; ++i) (*run)->step();
  EXPECT_THAT(ears.queues["red1"], HasSubstr("joints/states"));
  choice.set_where(HostProgram::IN_WORKBENCH);
  ASSERT_EQ(robotlink::describe((*run)->hostProgram("", choice)), "");
  EXPECT_FALSE(ears.hosting["red1"].own_process());
}

TEST(OwnProgram, requestsInAPauseAreAnsweredAtOnce) {
  ProgramEars ears;
  auto run = SimulatedRun::create(soccer(true), ears.listeners());
  ASSERT_TRUE(run) << robotlink::describe(run.error());
  for (int i = 0; i < 20; ++i) (*run)->step();
  auto request = requestTo("red1");
  request.mutable_select_solution()->set_task("ball-model");
  request.mutable_select_solution()->set_solution("nonsense");
  ASSERT_TRUE((*run)->request(request));
  ears.queues.clear();
  (*run)->publishComingAnswers();
  EXPECT_THAT(ears.queues["red1"], HasSubstr("nonsense"));
}

TEST_F(OwnThreadsProgramTest, itRunsAndPublishesThere) {
  play("none");
  ASSERT_TRUE(run_) << robotlink::describe(errors_);
  for (const std::string& robot : run_->robots()) {
    EXPECT_TRUE(ears_.hosting[robot].own_process() && ears_.hosting[robot].threads());
    EXPECT_TRUE(publishes(robot));
  }
}

TEST_F(OwnThreadsProgramTest, aCrashEndsOnlyThatProgram) {
  play("segfault");
  ASSERT_TRUE(run_) << robotlink::describe(errors_);
  ASSERT_TRUE(stepsUntil([this] { return state() == HostingStatus::ENDED; }));
  EXPECT_THAT(status().text(), HasSubstr("(signal SIGSEGV) in trouble (segfault) of process worker"));
  EXPECT_THAT(status().stack(), HasSubstr("robotlink::TaskRunner::execute")) << "of its thread";
  EXPECT_TRUE(worldGoesOn());
}

TEST_F(OwnThreadsProgramTest, aProgramThatEndedIsStartedAgain) {
  play("none");
  ASSERT_TRUE(run_) << robotlink::describe(errors_);
  ASSERT_EQ(::kill(static_cast<pid_t>(status().pid()), SIGKILL), 0);
  ASSERT_TRUE(stepsUntil([this] { return state() == HostingStatus::ENDED; }));
  HostProgram again;
  again.set_start_again(true);
  ASSERT_EQ(robotlink::describe(run_->hostProgram(first_, again)), "");
  EXPECT_EQ(state(), HostingStatus::RUNNING);
  EXPECT_TRUE(status().threads());
  EXPECT_TRUE(publishes(first_));
}

TEST_F(OwnThreadsProgramTest, anEndlessLoopIsNamedWhileTheOtherProcessesGoOn) {
  play("loop", std::chrono::milliseconds(300));
  ASSERT_TRUE(run_) << robotlink::describe(errors_);
  // On a busy machine it is noticed first that nothing answers.
  ASSERT_TRUE(stepsUntil([this] {
    return status().text().find("does not return from trouble (loop) of process worker") != std::string::npos;
  })) << status().text();
  EXPECT_EQ(state(), HostingStatus::NOT_ANSWERING);
  EXPECT_TRUE(worldGoesOn());
  EXPECT_TRUE(publishes(first_));
}

TEST_F(OwnThreadsProgramTest, threadsAndLockstepAreChosenWhileItRuns) {
  executor_ = ExecutorKind::kLockstep;
  play("none");
  ASSERT_TRUE(run_) << robotlink::describe(errors_);
  for (const bool threads : {true, false}) {
    HostProgram choice;
    choice.set_executor(threads ? HostProgram::THREADS : HostProgram::LOCKSTEP);
    ASSERT_EQ(robotlink::describe(run_->hostProgram("", choice)), "");
    for (const std::string& robot : run_->robots()) {
      EXPECT_TRUE(ears_.hosting[robot].own_process());
      EXPECT_EQ(ears_.hosting[robot].threads(), threads);
      EXPECT_TRUE(publishes(robot));
    }
  }
}

TEST(SpareChild, waitsForTheNextProgramUnlessItHasEnded) {
  SpareChild spare;
  const auto first = spare.take(OWN_PROGRAM_CHILD, "red1");
  ASSERT_TRUE(first);
  const pid_t waits = spare.pid();
  EXPECT_NE(waits, 0);
  EXPECT_NE(waits, first->pid());
  const auto second = spare.take(OWN_PROGRAM_CHILD, "red1");
  ASSERT_TRUE(second);
  EXPECT_EQ(second->pid(), waits);
  const pid_t ends = spare.pid();
  ASSERT_EQ(::kill(ends, SIGKILL), 0);
  siginfo_t ended{};
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(ends), &ended, WEXITED | WNOWAIT), 0);
  const auto third = spare.take(OWN_PROGRAM_CHILD, "red1");
  ASSERT_TRUE(third);
  EXPECT_NE(third->pid(), ends);
}

TEST(CrashReport, isReadFromWhatTheProgramWrote) {
  const auto report = CrashReport::parse(
      "report\nstack\nold\nreport\nactivity ball-percept (region)\nprocess cognition\nstack\n"
      "/opt/bin/robotctl(_ZN3app3runEv+0x12) [0x5555]\n/lib/libc.so.6(+0x3c050) [0x7f]\n");
  EXPECT_EQ(report.place(), " in ball-percept (region) of process cognition");
  EXPECT_EQ(report.stack, "app::run()+0x12 (robotctl)\nlibc.so.6+0x3c050\n");
  EXPECT_EQ(CrashReport::parse("rubbish").place(), "");
}

TEST(CrashReport, thatOfTheEndCountsWhateverIsWrittenBesideIt) {
  const std::string end = "end\nactivity trouble (abort)\nprocess worker\nstack\n";
  const std::string asked = "report\nactivity trouble (late)\nprocess worker\nstack\n";
  for (const std::string& text : {end, asked + end, end + asked}) {
    EXPECT_TRUE(CrashReport::hasEnd(text));
    EXPECT_EQ(CrashReport::parse(text).place(), " in trouble (abort) of process worker") << text;
  }
  EXPECT_FALSE(CrashReport::hasEnd(asked));
  EXPECT_FALSE(CrashReport::hasEnd("report\nactivity the end\n"));
}

TEST(ProgramChild, whyItEndedIsNotForgottenWhenItIsAskedWhatItDoes) {
  const TestFolder folder;
  const auto program =
      folder.write("program",
                   "#!/bin/sh\ntrap '' USR1\n"
                   "printf 'end\\nactivity trouble (abort)\\nprocess worker\\nstack\\n' >&4\n"
                   "read line <&3\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  auto child = ProgramChild::start(program, "red1");
  ASSERT_TRUE(child) << child.error().describe();
  ASSERT_TRUE(eventually([&] { return !child->report().activity.empty(); }));
  child->ask();
  child->kill();
  child->wait();
  EXPECT_EQ(child->report().place(), " in trouble (abort) of process worker");
}

TEST(CrashReport, anEndHasWords) {
  EXPECT_EQ(endInWords(W_EXITCODE(3, 0)), "called exit(3)");
  EXPECT_THAT(endInWords(SIGSEGV), HasSubstr("segmentation fault"));
  EXPECT_THAT(endInWords(SIGTERM), HasSubstr("SIGTERM"));
}
