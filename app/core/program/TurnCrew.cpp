// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/TurnCrew.h"

#include <algorithm>

namespace app {
namespace {

/// How often turns that take long are looked at.
constexpr std::chrono::milliseconds kTurnLook{10};

}  // namespace

TurnCrew::TurnCrew(int threads, std::function<void(std::size_t)> turn) : turn_(std::move(turn)) {
  const std::lock_guard lock(mutex_);
  for (int i = 0; i < std::max(1, threads); ++i) addWorker();
}

TurnCrew::~TurnCrew() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
    waiting_.clear();
  }
  wanted_.notify_all();
  for (Worker& worker : workers_) worker.thread.join();
}

void TurnCrew::addWorker() {
  Worker& worker = workers_.emplace_back();
  worker.thread = std::thread([this, &worker] { loop(worker); });
}

std::vector<std::size_t> TurnCrew::run(std::span<const std::size_t> members, const ModulePatience& patience) {
  std::vector<std::size_t> late;
  std::unique_lock lock(mutex_);
  // Threads that were given up and have ended since.
  std::erase_if(workers_, [](Worker& worker) {
    const bool hasEnded = worker.isLost && !worker.member;
    if (hasEnded) worker.thread.join();
    return hasEnded;
  });
  waiting_.assign(members.begin(), members.end());
  open_ = members.size();
  if (members.size() == 1) {
    wanted_.notify_one();
  } else {
    wanted_.notify_all();
  }
  while (!done_.wait_for(lock, kTurnLook, [this] { return open_ == 0; })) giveUp(patience, late);
  std::ranges::sort(late, {}, [&](std::size_t member) { return std::ranges::find(members, member); });
  return late;
}

void TurnCrew::giveUp(const ModulePatience& patience, std::vector<std::size_t>& late) {
  std::size_t lost = 0;
  for (Worker& worker : workers_) {
    if (!worker.member || worker.isLost || !patience.isOver(worker.begin)) continue;
    worker.isLost = true;
    late.push_back(*worker.member);
    --open_;
    ++lost;
  }
  for (; lost > 0; --lost) addWorker();
}

bool TurnCrew::isWorking(std::size_t member) const {
  return std::ranges::any_of(workers_, [&](const Worker& worker) { return worker.member == member; });
}

bool TurnCrew::isBusy(std::size_t member) const {
  const std::lock_guard lock(mutex_);
  return isWorking(member);
}

bool TurnCrew::waitFor(std::size_t member, std::chrono::milliseconds limit) {
  std::unique_lock lock(mutex_);
  return done_.wait_for(lock, limit, [&] { return !isWorking(member); });
}

void TurnCrew::loop(Worker& worker) {
  std::unique_lock lock(mutex_);
  while (true) {
    wanted_.wait(lock, [this] { return isOver_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    worker.member = waiting_.front();
    worker.begin = ModulePatience::Clock::now();
    waiting_.pop_front();
    lock.unlock();
    turn_(*worker.member);
    lock.lock();
    worker.member.reset();
    const bool isLost = worker.isLost;
    if (!isLost && --open_ > 0) continue;
    // A thread that is woken while the lock is held has to wait for it again at once.
    lock.unlock();
    done_.notify_all();
    // Whoever joins it may hold the lock.
    if (isLost) return;
    lock.lock();
  }
}

}  // namespace app
