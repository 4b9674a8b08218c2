// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/LockstepExecutor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robotlink/base/Random.h"
#include "tests/robotlink/process/TestProcess.h"

namespace robotlink::test {
namespace {

using ::testing::ElementsAre;
using namespace std::chrono_literals;

/// Sends random numbers and takes one.
class TestPlatform final : public Platform {
 public:
  explicit TestPlatform(const Clock& clock) : Platform("platform", clock) {}
  ~TestPlatform() override { stop(); }
  void actuate() override {
    if (throws) throw std::runtime_error("the cable is out");
    actuated.push_back(numberIn(command));
  }
  void engageStop(bool) override {}

  Sender<Ball> sensor{*this, "sensor", Blocking::kNo};
  Receiver<Ball> command{*this, "command", Blocking::kNo};
  std::vector<double> actuated;
  bool throws = false;

 protected:
  void execute() override { sensor.send(ball(random_.uniform())); }

 private:
  Random random_{1};
};

class LockstepExecutorTest : public ::testing::Test {
 protected:
  LockstepExecutorTest() {
    LockstepExecutor::Options options;
    options.advance = [this] { clock_.advance(8ms); };
    options.onStarved = [this](const Process& process, const std::string& what) {
      reported_.push_back(process.name() + " waits for " + what);
    };
    options.onFailed = [this](const Process& process) {
      reported_.push_back(process.name() + ": " + process.failure());
    };
    executor_ = std::make_unique<LockstepExecutor>(options);
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) executor_->step();
  }

  ManualClock clock_;
  TestPlatform platform_{clock_};
  std::vector<std::string> reported_;
  std::unique_ptr<LockstepExecutor> executor_;
};

/// Three processes in a ring with the platform; everything that the middle one sees, as bytes.
std::string threeProcessesRun(int frames) {
  ManualClock clock;
  TestPlatform platform(clock);
  TestProcess see("see", clock);
  TestProcess think("think", clock);
  TestProcess act("act", clock);
  Receiver<Ball> seen(see, "sensor", Blocking::kYes);
  Sender<Ball> percept(see, "percept", Blocking::kNo);
  Receiver<Ball> perceived(think, "percept", Blocking::kNo);
  Receiver<Ball> feedback(think, "command", Blocking::kNo);
  Sender<Ball> details(think, "wish", Blocking::kNo);
  Receiver<Ball> requested(act, "wish", Blocking::kYes);
  Sender<Ball> command(act, "command", Blocking::kNo);
  connect(platform.sensor, seen);
  connect(percept, perceived);
  connect(details, requested);
  connect(command, feedback);
  connect(command, platform.command);
  think.setPeriod(20ms);
  std::string bytes;
  see.body = [&] { percept.send(ball(numberIn(seen) * 2)); };
  think.body = [&] {
    bytes += perceived.get() ? perceived.get()->SerializeAsString() : "-";
    bytes += feedback.get() ? feedback.get()->SerializeAsString() : "-";
    details.send(ball(numberIn(perceived) + numberIn(feedback)));
  };
  act.body = [&] { command.send(ball(numberIn(requested) / 2)); };
  LockstepExecutor::Options options;
  options.advance = [&] { clock.advance(8ms); };
  LockstepExecutor executor(options);
  for (Process* process : {&see, &think, &act}) executor.add(*process);
  executor.add(platform);
  for (int i = 0; i < frames; ++i) executor.step();
  for (const double number : platform.actuated) bytes += std::to_string(number) + " ";
  return bytes;
}

TEST_F(LockstepExecutorTest, threeProcessesGiveTheSameBytesTwice) {
  const std::string first = threeProcessesRun(1000);
  EXPECT_GT(first.size(), 10000U);
  EXPECT_EQ(first, threeProcessesRun(1000));
}

TEST_F(LockstepExecutorTest, aProcessRunsAtMostOnceAnInstant) {
  TestProcess a("a", clock_);
  TestProcess b("b", clock_);
  Sender<Ball> toB(a, "to-b", Blocking::kNo);
  Receiver<Ball> fromA(b, "to-b", Blocking::kYes);
  Sender<Ball> toA(b, "to-a", Blocking::kNo);
  Receiver<Ball> fromB(a, "to-a", Blocking::kYes);
  connect(toB, fromA);
  connect(toA, fromB);
  a.body = [&] { toB.send(ball(1)); };
  b.body = [&] { toA.send(ball(1)); };
  toA.send(ball(0));
  executor_->add(a);
  executor_->add(b);
  executor_->add(platform_);
  run(10);
  EXPECT_EQ(10U, a.frames());
  EXPECT_EQ(10U, b.frames());
}

TEST_F(LockstepExecutorTest, aChainRunsInOneInstantInWhateverOrderItIsListed) {
  TestProcess first("first", clock_);
  TestProcess second("second", clock_);
  Receiver<Ball> sensor(first, "sensor", Blocking::kYes);
  Sender<Ball> sender(first, "x", Blocking::kNo);
  Receiver<Ball> receiver(second, "x", Blocking::kYes);
  Sender<Ball> command(second, "command", Blocking::kNo);
  connect(platform_.sensor, sensor);
  connect(sender, receiver);
  connect(command, platform_.command);
  first.body = [&] { sender.send(ball(seconds(clock_.now()))); };
  second.body = [&] { command.send(ball(numberIn(receiver))); };
  executor_->add(second);
  executor_->add(first);
  executor_->add(platform_);
  run(4);
  EXPECT_THAT(platform_.actuated, ElementsAre(-1, 0.008, 0.016, 0.024));
}

TEST_F(LockstepExecutorTest, whoStarvesIsReportedOnceUntilItRunsAgain) {
  TestProcess hungry("hungry", clock_);
  Receiver<Ball> never(hungry, "dinner", Blocking::kYes);
  TestProcess cook("cook", clock_);
  Sender<Ball> dinner(cook, "dinner", Blocking::kNo);
  connect(dinner, never);
  executor_->add(hungry);
  executor_->add(platform_);
  run(249);
  EXPECT_TRUE(reported_.empty());
  run(500);
  EXPECT_THAT(reported_, ElementsAre("hungry waits for package dinner of cook"));
  dinner.send(ball(1));
  run(251);
  EXPECT_EQ(1U, reported_.size());
  run(2);
  EXPECT_EQ(2U, reported_.size());
}

TEST_F(LockstepExecutorTest, aProcessThatThrowsIsReportedAndTheOthersGoOn) {
  TestProcess bad("bad", clock_);
  TestProcess good("good", clock_);
  bad.setPeriod(8ms);
  good.setPeriod(8ms);
  bad.body = [] { throw 42; };
  executor_->add(bad);
  executor_->add(good);
  executor_->add(platform_);
  run(5);
  EXPECT_THAT(reported_, ElementsAre("bad: an exception of unknown type"));
  EXPECT_EQ(5U, good.frames());
}

TEST_F(LockstepExecutorTest, aPlatformThatThrowsIsReportedAndTimeGoesOn) {
  TestProcess good("good", clock_);
  good.setPeriod(8ms);
  executor_->add(good);
  executor_->add(platform_);
  run(2);
  platform_.throws = true;
  run(3);
  EXPECT_THAT(reported_, ElementsAre("platform: the cable is out"));
  EXPECT_EQ(5U, good.frames());
}

TEST_F(LockstepExecutorTest, aClockThatIsSetBackStartsPeriodsAnew) {
  TestProcess process("process", clock_);
  process.setPeriod(80ms);
  executor_->add(process);
  executor_->add(platform_);
  run(100);
  EXPECT_EQ(10U, process.frames());
  clock_.set(Instant());
  run(100);
  EXPECT_EQ(20U, process.frames());
  EXPECT_TRUE(reported_.empty());
}

}  // namespace
}  // namespace robotlink::test
