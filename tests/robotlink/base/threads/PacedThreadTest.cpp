// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/threads/PacedThread.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <vector>

#include "tests/Eventually.h"

using namespace robotlink;
using namespace std::chrono_literals;

namespace {

using PacedClock = PacedThread::Clock;
constexpr auto kLongest = 10s;

/// Steps `wanted` times, at once; due and steps are seen by this thread only after done() was waited for.
struct Steps {
  std::atomic<int> wanted = 0, done = 0, ended = 0;
  PacedThread::Work work() {
    return {[this] { return done < wanted ? std::optional(PacedClock::now()) : std::nullopt; },
            [this] { ++done; }, [this] { ++ended; }};
  }
};

/// Waits until all jobs that were posted are done.
bool finish(PacedThread& thread) {
  auto done = std::make_shared<std::promise<void>>();
  auto waiting = done->get_future();
  thread.post([done] { done->set_value(); });
  return waiting.wait_for(kLongest) == std::future_status::ready;
}

}  // namespace

TEST(PacedThread, jobsAreDoneInTheirOrder) {
  Steps steps;
  PacedThread thread(steps.work());
  std::vector<int> order;
  for (int i = 0; i < 100; ++i) thread.post([&order, i] { order.push_back(i); });
  ASSERT_TRUE(finish(thread));
  ASSERT_EQ(order.size(), 100U);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(PacedThread, aJobWakesItUpToSteps) {
  Steps steps;
  PacedThread thread(steps.work());
  ASSERT_TRUE(finish(thread));
  EXPECT_EQ(steps.done, 0);
  thread.post([&] { steps.wanted = 3; });
  EXPECT_TRUE(eventually([&] { return steps.done == 3; }));
  ASSERT_TRUE(finish(thread));
  EXPECT_EQ(steps.done, 3);
}

TEST(PacedThread, aStepIsNotMadeBeforeItIsDue) {
  const auto due = PacedClock::now() + 50ms;
  std::promise<PacedClock::time_point> stepped;
  std::atomic<bool> done = false;
  PacedThread thread({[&] { return done ? std::nullopt : std::optional(due); },
                      [&] {
                        done = true;
                        stepped.set_value(PacedClock::now());
                      },
                      {}});
  auto when = stepped.get_future();
  ASSERT_EQ(when.wait_for(kLongest), std::future_status::ready);
  EXPECT_GE(when.get(), due);
}

TEST(PacedThread, jobsAreDoneWhileAStepIsWaitedFor) {
  PacedThread thread({[] { return PacedClock::now() + 1h; }, [] { FAIL() << "a step that is not due"; }, {}});
  EXPECT_TRUE(finish(thread));
  EXPECT_TRUE(finish(thread));
}

TEST(PacedThread, jobsAreDoneBetweenStepsThatAreAlwaysDue) {
  std::atomic<int> steps = 0;
  PacedThread thread({[] { return PacedClock::now() - 1s; }, [&] { ++steps; }, {}});
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(finish(thread));
  EXPECT_TRUE(eventually([&] { return steps > 0; }));
}

TEST(PacedThread, itEndsWhileItWaitsAndItsLastCallIsInItsOwnThread) {
  Steps steps;
  std::thread::id thread, last;
  {
    PacedThread::Work work = steps.work();
    work.end = [&] { last = std::this_thread::get_id(); };
    PacedThread paced(std::move(work));
    paced.post([&] { thread = std::this_thread::get_id(); });
    ASSERT_TRUE(finish(paced));
  }
  EXPECT_EQ(last, thread);
  EXPECT_NE(last, std::this_thread::get_id());
}

TEST(PacedThread, itEndsThoughJobsNeverRunOut) {
  Steps steps;
  std::atomic<int> done = 0;
  {
    std::function<void()> again;
    PacedThread thread(steps.work());
    again = [&] {
      ++done;
      thread.post(again);
    };
    thread.post(again);
    EXPECT_TRUE(eventually([&] { return done >= 10; }));
  }
  EXPECT_EQ(steps.ended, 1);
}

TEST(PacedThread, wakingItMakesItAskAgainWhenAStepIsDue) {
  Steps steps;
  PacedThread thread(steps.work());
  ASSERT_TRUE(finish(thread));
  EXPECT_EQ(steps.done, 0);
  steps.wanted = 2;
  thread.wake();
  EXPECT_TRUE(eventually([&] { return steps.done == 2; }));
}

TEST(PacedThread, wakingItEndsTheWaitForAStep) {
  std::atomic<bool> isUrgent = false;
  std::promise<void> stepped;
  PacedThread thread({.due = [&] { return PacedClock::now() + (isUrgent ? 0h : 1h); },
                      .step =
                          [&] {
                            isUrgent = false;
                            stepped.set_value();
                          }});
  ASSERT_TRUE(finish(thread));
  isUrgent = true;
  thread.wake();
  EXPECT_EQ(stepped.get_future().wait_for(kLongest), std::future_status::ready);
}

TEST(PacedThread, wakingItOverAndOverDoesNotPutOffSteps) {
  std::atomic<int> steps = 0;
  PacedThread* waker = nullptr;
  PacedThread thread({.due =
                          [&] {
                            if (waker != nullptr) waker->wake();
                            return PacedClock::now() - 1s;
                          },
                      .step = [&] { ++steps; }});
  thread.post([&] { waker = &thread; });
  ASSERT_TRUE(finish(thread));
  const int before = steps;
  EXPECT_TRUE(eventually([&] { return steps > before + 10; }));
}

TEST(PacedThread, aStepThatTakesLongLearnsThatItShouldReturn) {
  std::promise<void> begun;
  std::atomic<bool> sawEnd = false;
  {
    std::atomic<PacedThread*> own = nullptr;
    std::atomic<bool> isDue = false;
    PacedThread thread({.due = [&] { return isDue ? std::optional(PacedClock::now()) : std::nullopt; },
                        .step =
                            [&] {
                              sawEnd = own.load()->isEnding();
                              begun.set_value();
                              while (!own.load()->isEnding()) std::this_thread::yield();
                              sawEnd = !sawEnd;
                            }});
    own = &thread;
    isDue = true;
    thread.wake();
    ASSERT_EQ(begun.get_future().wait_for(kLongest), std::future_status::ready);
  }
  EXPECT_TRUE(sawEnd) << "first it was not ending, then it was";
}
