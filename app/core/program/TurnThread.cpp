// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/TurnThread.h"

namespace app {
namespace {

/// How often a turn that takes long is looked at.
constexpr std::chrono::milliseconds kTurnLook{10};

}  // namespace

TurnThread::TurnThread(std::function<void()> turn) : turn_(std::move(turn)), thread_([this] { loop(); }) {}

TurnThread::~TurnThread() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
  }
  wanted_.notify_one();
  thread_.join();
}

bool TurnThread::run(const ModulePatience& patience) {
  const auto begin = ModulePatience::Clock::now();
  {
    const std::lock_guard lock(mutex_);
    isWanted_ = true;
  }
  wanted_.notify_one();
  while (!waitFor(kTurnLook)) {
    if (patience.isOver(begin)) return false;
  }
  return true;
}

bool TurnThread::isBusy() const {
  const std::lock_guard lock(mutex_);
  return isWanted_;
}

bool TurnThread::waitFor(std::chrono::milliseconds limit) {
  std::unique_lock lock(mutex_);
  return done_.wait_for(lock, limit, [this] { return !isWanted_; });
}

void TurnThread::loop() {
  std::unique_lock lock(mutex_);
  while (true) {
    wanted_.wait(lock, [this] { return isWanted_ || isOver_; });
    if (!isWanted_) return;
    lock.unlock();
    turn_();
    lock.lock();
    isWanted_ = false;
    // A thread that is woken while the lock is held has to wait for it again at once.
    lock.unlock();
    done_.notify_all();
    lock.lock();
  }
}

}  // namespace app
