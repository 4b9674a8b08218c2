// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/threads/ThreadPool.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace robotlink {
namespace {

TEST(ThreadPool, doesEachJobOnceHoweverManyThreadsItHas) {
  for (const int threads : {1, 2, 3, 8}) {
    ThreadPool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    for (const std::size_t count : {0, 1, 2, 100}) {
      std::vector<int> done(count);
      pool.run(count, [&](std::size_t i) { ++done[i]; });
      EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), static_cast<int>(count));
    }
  }
}

TEST(ThreadPool, jobsOfOneCallRunInSeveralThreads) {
  ThreadPool pool(2);
  // Each job waits for the other one, so that one thread could not do both.
  std::atomic<int> begun{0};
  pool.run(2, [&](std::size_t) {
    ++begun;
    while (begun < 2) std::this_thread::yield();
  });
  EXPECT_EQ(begun, 2);
}

TEST(ThreadPool, aJobMayHaveJobsOfItsOwn) {
  ThreadPool pool(2);
  std::atomic<int> done{0};
  pool.run(3, [&](std::size_t) { pool.run(4, [&](std::size_t) { ++done; }); });
  EXPECT_EQ(done, 12);
}

TEST(ThreadPool, severalThreadsMayCallItAtOnce) {
  ThreadPool pool(2);
  std::atomic<int> done{0};
  {
    const auto call = [&] {
      for (int i = 0; i < 100; ++i) pool.run(3, [&](std::size_t) { ++done; });
    };
    std::jthread first(call), second(call);
  }
  EXPECT_EQ(done, 600);
}

TEST(ThreadPool, anExceptionComesToTheCallerAfterAllOtherJobs) {
  ThreadPool pool(2);
  std::atomic<int> done{0};
  const auto job = [&](std::size_t i) {
    if (i == 3) throw std::runtime_error("broken");
    ++done;
  };
  EXPECT_THROW(pool.run(10, job), std::runtime_error);
  EXPECT_EQ(done, 9);
  pool.run(2, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 11);
}

TEST(ThreadPool, jobsForLaterAreDoneBesideOthers) {
  std::atomic<int> later{0}, done{0};
  ThreadPool pool(3);
  for (int i = 0; i < 50; ++i) {
    pool.later([&] { ++later; });
    pool.run(4, [&](std::size_t) { ++done; });
  }
  EXPECT_EQ(done, 200);
  while (later < 50) std::this_thread::yield();
}

TEST(ThreadPool, nobodyWaitsForAJobForLater) {
  std::atomic<bool> mayEnd{false};
  ThreadPool pool(2);
  pool.later([&] {
    while (!mayEnd) std::this_thread::yield();
  });
  std::atomic<int> done{0};
  pool.run(8, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 8);
  mayEnd = true;
}

TEST(ThreadPool, aloneNothingIsDoneLater) {
  bool done = false;
  {
    ThreadPool pool(1);
    pool.later([&] { done = true; });
  }
  EXPECT_FALSE(done);
}

TEST(ThreadPool, theNumberOfThreadsIsBounded) {
  EXPECT_EQ(ThreadPool(-5).threads(), 1);
  EXPECT_GE(ThreadPool::cores(), 1);
}

}  // namespace
}  // namespace robotlink
