// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/threads/ThreadPool.h"

#include <algorithm>
#include <chrono>

#include "robotlink/base/threads/BriefWait.h"

namespace robotlink {
namespace {

/// How long threads look for jobs before they sleep: about the time between the jobs of two steps.
constexpr std::chrono::microseconds kAttention{300};

}  // namespace

ThreadPool::ThreadPool(int threads) {
  const int count = std::clamp(threads, 1, kMaxThreads);
  for (int i = 1; i < count; ++i) workers_.emplace_back([this] { loop(); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
    ++calls_;
  }
  called_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

int ThreadPool::cores() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void ThreadPool::work(Batch& batch) {
  for (std::size_t i = batch.next++; i < batch.count; i = batch.next++) {
    try {
      batch.job(i);
    } catch (...) {
      const std::lock_guard lock(batch.mutex);
      if (!batch.failure) batch.failure = std::current_exception();
    }
  }
}

void ThreadPool::run(std::size_t count, const std::function<void(std::size_t)>& job) {
  Batch batch{.job = job, .count = count};
  if (workers_.empty() || count <= 1 || isBusy_.exchange(true)) {
    work(batch);
  } else {
    {
      const std::lock_guard lock(mutex_);
      batch_ = &batch;
      ++calls_;
    }
    called_.notify_all();
    work(batch);
    {
      std::unique_lock lock(mutex_);
      // Threads that have not begun are no longer needed.
      batch_ = nullptr;
    }
    waitBriefly(kAttention, [this] { return working_ == 0; });
    {
      std::unique_lock lock(mutex_);
      ended_.wait(lock, [this] { return working_ == 0; });
    }
    isBusy_ = false;
  }
  if (batch.failure) std::rethrow_exception(batch.failure);
}

void ThreadPool::later(std::function<void()> job) {
  if (workers_.empty()) return;
  {
    const std::lock_guard lock(mutex_);
    later_.push_back(std::move(job));
    waiting_ = later_.size();
  }
  called_.notify_one();
}

void ThreadPool::doOneLater(std::unique_lock<std::mutex>& lock) {
  const std::function<void()> job = std::move(later_.front());
  later_.pop_front();
  waiting_ = later_.size();
  lock.unlock();
  job();
}

void ThreadPool::loop() {
  std::uint64_t seen = 0;
  BriefWait wait(kAttention);
  while (true) {
    wait.look([&] { return calls_ != seen || waiting_ > 0; });
    std::unique_lock lock(mutex_);
    called_.wait(lock, [&] { return calls_ != seen || !later_.empty(); });
    wait.end();
    seen = calls_;
    if (isOver_) return;
    if (batch_ == nullptr) {
      if (!later_.empty()) doOneLater(lock);
      continue;
    }
    Batch& batch = *batch_;
    ++working_;
    lock.unlock();
    work(batch);
    lock.lock();
    const bool isLast = --working_ == 0;
    lock.unlock();
    if (isLast) ended_.notify_one();
  }
}

}  // namespace robotlink
