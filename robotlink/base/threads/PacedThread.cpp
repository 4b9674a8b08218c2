// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/threads/PacedThread.h"

#include <utility>

namespace robotlink {

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
  postTo(jobs_, std::move(job));
}

void PacedThread::postUrgent(Job job) {
  postTo(urgent_, std::move(job));
}

void PacedThread::postTo(std::deque<Job>& jobs, Job job) {
  {
    const std::lock_guard lock(mutex_);
    jobs.push_back(std::move(job));
  }
  wakeUp_.notify_one();
}

void PacedThread::wake() {
  {
    const std::lock_guard lock(mutex_);
    isWoken_ = true;
  }
  wakeUp_.notify_one();
}

bool PacedThread::isEnding() const {
  const std::lock_guard lock(mutex_);
  return quit_;
}

bool PacedThread::doJobs(std::unique_lock<std::mutex>& lock) {
  while (!(urgent_.empty() && jobs_.empty()) && !quit_) {
    auto& jobs = urgent_.empty() ? jobs_ : urgent_;
    const Job job = std::move(jobs.front());
    jobs.pop_front();
    lock.unlock();
    job();
    lock.lock();
  }
  return !quit_;
}

void PacedThread::runLoop() {
  const auto disturbed = [this] { return quit_ || !urgent_.empty() || !jobs_.empty(); };
  const auto disturbedOrWoken = [&] { return disturbed() || isWoken_; };
  std::unique_lock lock(mutex_);
  while (doJobs(lock)) {
    isWoken_ = false;
    lock.unlock();
    const auto due = work_.due();
    lock.lock();
    if (!due) {
      wakeUp_.wait(lock, disturbedOrWoken);
      continue;
    }
    // To wait until a time that is over would cost a call of the system for each step. A call of wake() does
    // not put off a step that is due, however often it comes.
    if (disturbed() || (Clock::now() < *due && wakeUp_.wait_until(lock, *due, disturbedOrWoken))) continue;
    lock.unlock();
    work_.step();
    lock.lock();
  }
  lock.unlock();
  if (work_.end) work_.end();
}

}  // namespace robotlink
