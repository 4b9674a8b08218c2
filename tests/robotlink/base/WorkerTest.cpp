// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Worker.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <latch>
#include <memory>
#include <vector>

using namespace robotlink;
using testing::ElementsAre;

namespace {

/// A worker whose first job holds it until the test lets it go; the others only note their numbers.
struct HeldWorker {
  std::latch began{1}, release{1};
  /// Used by the thread, and by the test after finish().
  std::vector<int> done;
  std::vector<bool> askedToEnd;
  Worker<int> worker;

  explicit HeldWorker(Worker<int>::Options options = {})
      : worker(
            [this](int job, const std::stop_token& stop) {
              if (job == 1) {
                began.count_down();
                release.wait();
              }
              done.push_back(job);
              askedToEnd.push_back(stop.stop_requested());
            },
            std::move(options)) {}
  void holdIt() {
    worker.post(1);
    began.wait();
  }
  void letGo() {
    release.count_down();
    worker.finish();
  }
};

}  // namespace

TEST(Worker, aResultIsTakenOnce) {
  std::atomic<int> news = 0;
  Worker<int, int>* self = nullptr;
  Worker<int, int> worker([&](int job, const std::stop_token&) { self->publish(job * 2); },
                          {.news = [&] { ++news; }});
  self = &worker;
  EXPECT_TRUE(worker.idle());
  EXPECT_EQ(worker.take(), std::nullopt);
  worker.post(21);
  worker.finish();
  EXPECT_FALSE(worker.idle()) << "its result waits";
  EXPECT_EQ(news, 1);
  EXPECT_EQ(worker.take(), 42);
  EXPECT_EQ(worker.take(), std::nullopt);
  EXPECT_TRUE(worker.idle());
}

TEST(Worker, theNewestResultReplacesOneThatWasNotTaken) {
  Worker<int, int>* self = nullptr;
  Worker<int, int> worker([&](int job, const std::stop_token&) { self->publish(job); });
  self = &worker;
  for (const int job : {1, 2}) {
    worker.post(job);
    worker.finish();
  }
  EXPECT_EQ(worker.take(), 2);
}

TEST(Worker, theNewestJobReplacesOneThatHasNotBegun) {
  HeldWorker held;
  held.holdIt();
  held.worker.post(2);
  held.worker.post(3);
  EXPECT_FALSE(held.worker.idle());
  held.letGo();
  EXPECT_THAT(held.done, ElementsAre(1, 3));
  EXPECT_THAT(held.askedToEnd, ElementsAre(true, false)) << "job 3 asked job 1 to end";
}

TEST(Worker, aJobThatHeedsItsTokenEndsWhenAnotherIsPosted) {
  std::promise<void> began;
  std::vector<int> ended;
  Worker<int> worker([&](int job, const std::stop_token& stop) {
    if (job == 1) began.set_value();
    while (job == 1 && !stop.stop_requested()) std::this_thread::yield();
    ended.push_back(job);
  });
  worker.post(1);
  began.get_future().wait();
  worker.post(2);
  worker.finish();
  EXPECT_THAT(ended, ElementsAre(1, 2));
}

TEST(Worker, cancelReachesTheJobInProgressAndTheOneThatWaits) {
  HeldWorker held;
  held.holdIt();
  held.worker.post(2);
  held.worker.cancel();
  held.letGo();
  EXPECT_THAT(held.done, ElementsAre(1, 2)) << "so that its owner hears of its end";
  EXPECT_THAT(held.askedToEnd, ElementsAre(true, true));
  held.worker.post(3);
  held.worker.finish();
  EXPECT_THAT(held.askedToEnd, ElementsAre(true, true, false)) << "later jobs are not canceled";
}

TEST(Worker, aJobIsRefusedOnRequestWhileThereIsAnother) {
  HeldWorker held;
  EXPECT_TRUE(held.worker.postIfFree(1));
  held.began.wait();
  EXPECT_FALSE(held.worker.postIfFree(2));
  held.letGo();
  EXPECT_TRUE(held.worker.postIfFree(3));
  held.worker.finish();
  EXPECT_THAT(held.done, ElementsAre(1, 3));
  EXPECT_THAT(held.askedToEnd, ElementsAre(false, false));
}

TEST(Worker, theDestructorEndsTheJobInProgressAndDropsTheOtherOne) {
  std::promise<void> began;
  std::vector<int> ended;
  {
    Worker<int> worker([&](int job, const std::stop_token& stop) {
      if (job == 1) began.set_value();
      while (!stop.stop_requested()) std::this_thread::yield();
      ended.push_back(job);
    });
    worker.postIfFree(1);
    began.get_future().wait();
  }
  EXPECT_THAT(ended, ElementsAre(1));
}

TEST(Worker, theDestructorFinishesAllJobsIfAskedTo) {
  std::vector<int> done;
  {
    Worker<int> worker(
        [&](int job, const std::stop_token& stop) { done.push_back(stop.stop_requested() ? -1 : job); },
        {.finishesJobs = true});
    worker.post(1);
    worker.finish();
    worker.post(2);
  }
  EXPECT_THAT(done, ElementsAre(1, 2));
}

TEST(Worker, aJobDoesNotBeginBeforeItIsDue) {
  using Clock = Worker<int>::Clock;
  std::vector<int> done;
  std::promise<void> asked;
  std::atomic<bool> wasAsked = false;
  Worker<int> worker([&](int job, const std::stop_token&) { done.push_back(job); },
                     {.due = [&](const int& job) {
                       if (!wasAsked.exchange(true)) asked.set_value();
                       return job == 1 ? Clock::now() + std::chrono::hours(1) : Clock::time_point::min();
                     }});
  worker.post(1);
  asked.get_future().wait();
  worker.post(2);
  worker.finish();
  EXPECT_THAT(done, ElementsAre(2));
}

TEST(Worker, itsThreadBeginsAndEndsWithTheCallsForThat) {
  std::vector<std::thread::id> calls;
  {
    Worker<int> worker([&](int, const std::stop_token&) { calls.push_back(std::this_thread::get_id()); },
                       {.begin = [&] { calls.push_back(std::this_thread::get_id()); },
                        .end = [&] { calls.push_back(std::this_thread::get_id()); }});
    worker.post(1);
    worker.finish();
    EXPECT_EQ(calls.size(), 2U);
  }
  ASSERT_EQ(calls.size(), 3U);
  EXPECT_EQ(calls[0], calls[1]);
  EXPECT_EQ(calls[0], calls[2]);
  EXPECT_NE(calls[0], std::this_thread::get_id());
}

TEST(Worker, whatAJobHoldsIsReleasedBeforeTheWorkerIsFree) {
  Worker<std::shared_ptr<int>> worker([](const auto&, const std::stop_token&) {});
  auto data = std::make_shared<int>(1);
  const std::weak_ptr<int> seen = data;
  worker.post(std::move(data));
  worker.finish();
  EXPECT_TRUE(seen.expired());
}
