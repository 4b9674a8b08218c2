// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/PacedThread.h"

#include <utility>

namespace app {

PacedThread::PacedThread(Work work) : work_(std::move(work)), thread_([this] { runLoop(); }) {}

PacedThread::~PacedThread() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  wakeUp_.notify_one();
  thread_.join();
}

void PacedThread::post(Job job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  wakeUp_.notify_one();
}

bool PacedThread::doJobs(std::unique_lock<std::mutex>& lock) {
  while (!jobs_.empty() && !quit_) {
    const Job job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    lock.lock();
  }
  return !quit_;
}

void PacedThread::runLoop() {
  const auto disturbed = [this] { return quit_ || !jobs_.empty(); };
  std::unique_lock lock(mutex_);
  while (doJobs(lock)) {
    lock.unlock();
    const auto due = work_.due();
    lock.lock();
    if (!due) {
      wakeUp_.wait(lock, disturbed);
      continue;
    }
    if (wakeUp_.wait_until(lock, *due, disturbed)) continue;
    lock.unlock();
    work_.step();
    lock.lock();
  }
  lock.unlock();
  if (work_.end) work_.end();
}

}  // namespace app
