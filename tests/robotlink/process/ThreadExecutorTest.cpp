// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/ThreadExecutor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <latch>

#include "tests/Eventually.h"
#include "tests/robotlink/process/TestProcess.h"

namespace robotlink::test {
namespace {

using namespace std::chrono_literals;

TEST(ThreadExecutorTest, motionKeepsItsRateWhileBehaviorIsBlocked) {
  ManualClock clock;
  TestProcess behavior("behavior", clock);
  TestProcess motion("motion", clock);
  Sender<Ball> details(behavior, "wish", Blocking::kNo);
  Receiver<Ball> requested(motion, "wish", Blocking::kNo);
  connect(details, requested);
  behavior.setPeriod(20ms);
  motion.setPeriod(20ms);
  std::latch blocked{1}, release{1};
  bool wasBlocked = false;
  behavior.body = [&] {
    details.send(ball(1));
    if (std::exchange(wasBlocked, true)) return;
    blocked.count_down();
    release.wait();
  };
  ThreadExecutor executor({});
  executor.add(behavior);
  executor.add(motion);
  executor.start();
  blocked.wait();
  bool keptUp = true;
  for (std::uint64_t frame = 1; frame <= 50 && keptUp; ++frame) {
    keptUp = eventually([&] { return motion.frames() == frame; });
    clock.advance(20ms);
    executor.clockAdvanced();
  }
  EXPECT_TRUE(keptUp) << "motion made " << motion.frames() << " frames while behavior was blocked";
  release.count_down();
  executor.stop();
}

TEST(ThreadExecutorTest, aManualClockWakesItsPeriods) {
  ManualClock clock;
  TestProcess process("process", clock);
  process.setPeriod(20ms);
  ThreadExecutor executor({});
  executor.add(process);
  executor.start();
  for (std::uint64_t frame = 1; frame <= 20; ++frame) {
    ASSERT_TRUE(eventually([&] { return process.frames() == frame; }));
    clock.advance(20ms);
    executor.clockAdvanced();
  }
}

TEST(ThreadExecutorTest, aProcessThatThrowsIsReportedAndTheOthersGoOn) {
  ManualClock clock;
  TestProcess bad("bad", clock);
  TestProcess good("good", clock);
  Sender<Ball> toBad(good, "x", Blocking::kYes);
  Receiver<Ball> receiver(bad, "x", Blocking::kYes);
  connect(toBad, receiver);
  bad.body = [] { throw std::runtime_error("broken"); };
  good.body = [&] {
    if (good.frames() < 100) {
      toBad.send(ball(1));
      good.wake();
    } else {
      good.stop();
    }
  };
  std::atomic<int> reports{0};
  std::string failure;
  ThreadExecutor::Options options;
  options.onFailed = [&](const Process& process) {
    failure = process.name() + ": " + process.failure();
    ++reports;
  };
  ThreadExecutor executor(options);
  executor.add(bad);
  executor.add(good);
  executor.start();
  EXPECT_TRUE(eventually([&] { return good.stopped() && reports == 1; }));
  executor.stop();
  EXPECT_EQ("bad: broken", failure);
}

TEST(ThreadExecutorTest, aPriorityIsSetOrItsRefusalIsReported) {
  ManualClock clock;
  TestProcess urgent("urgent", clock);
  TestProcess modest("modest", clock);
  urgent.setPriority(-20);
  modest.setPriority(5);
  std::atomic<int> urgentNice{100};
  std::atomic<int> modestNice{100};
  const auto nice = [] { return ::getpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid))); };
  urgent.body = [&] { urgentNice = nice(), urgent.stop(); };
  modest.body = [&] { modestNice = nice(), modest.stop(); };
  std::atomic<int> refusals{0};
  ThreadExecutor::Options options;
  options.onPriorityRefused = [&](const Process& process, const std::string& why) {
    EXPECT_EQ("urgent", process.name());
    EXPECT_FALSE(why.empty());
    ++refusals;
  };
  ThreadExecutor executor(options);
  executor.add(urgent);
  executor.add(modest);
  executor.start();
  EXPECT_TRUE(eventually([&] { return urgent.stopped() && modest.stopped(); }));
  executor.stop();
  EXPECT_NE(urgentNice == -20, refusals == 1) << "nice value " << urgentNice << ", refusals " << refusals;
  EXPECT_GE(modestNice, 5);
}

TEST(ThreadExecutorTest, itStopsWhileAllWait) {
  ManualClock clock;
  TestProcess a("a", clock);
  TestProcess b("b", clock);
  Receiver<Ball> nothing(a, "nothing", Blocking::kYes);
  b.setPeriod(1h);
  ThreadExecutor executor({});
  executor.add(a);
  executor.add(b);
  executor.start();
  EXPECT_TRUE(eventually([&] { return b.frames() == 1; }));
  executor.stop();
  EXPECT_EQ(0U, a.frames());
}

TEST(ThreadExecutorTest, aStopWithALimitGoesOnWithoutAFrameThatTakesLonger) {
  ManualClock clock;
  TestProcess slow("slow", clock);
  slow.setPeriod(20ms);
  std::latch begun{1}, release{1};
  slow.body = [&] {
    begun.count_down();
    release.wait();
  };
  ThreadExecutor executor({});
  executor.add(slow);
  executor.start();
  begun.wait();
  EXPECT_FALSE(executor.stopWithin(5ms));
  EXPECT_FALSE(executor.hasEnded(slow));
  release.count_down();
  // The frame ends at once, and so does the wait.
  EXPECT_TRUE(executor.stopWithin(1h));
  EXPECT_TRUE(executor.hasEnded(slow));
}

}  // namespace
}  // namespace robotlink::test
