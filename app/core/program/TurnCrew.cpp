// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/TurnCrew.h"

#include <algorithm>

#include "robotlink/base/threads/BriefWait.h"

namespace app {
namespace {

/// The time for which threads look for turns, and for their end, before they sleep: waking one takes as long
/// as many a turn.
constexpr std::chrono::microseconds kAttention{300};

/// The period of checks for turns that take long.
constexpr std::chrono::milliseconds kTurnLook{10};

}  // namespace

TurnCrew::TurnCrew(int threads, std::function<void(std::size_t)> turn, Waiting waiting)
    : turn_(std::move(turn)),
      handover_(threads > 1 || waiting == Waiting::kAlert ? nullptr : std::make_unique<Handover>()) {
  const std::lock_guard lock(mutex_);
  for (int i = 0; i < std::max(1, threads); ++i) addWorker();
}

TurnCrew::~TurnCrew() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = areWaiting_ = true;
    waiting_.clear();
  }
  wake(workers_.size());
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
  areWaiting_ = open_ > 0;
  lock.unlock();
  wake(members.size());
  waitForTurns(patience, late);
  std::ranges::sort(late, {}, [&](std::size_t member) { return std::ranges::find(members, member); });
  return late;
}

void TurnCrew::wake(std::size_t turns) {
  if (handover_) {
    handover_->wanted.signal();
  } else if (turns == 1) {
    wanted_.notify_one();
  } else {
    wanted_.notify_all();
  }
}

void TurnCrew::waitForTurns(const ModulePatience& patience, std::vector<std::size_t>& late) {
  if (!handover_) robotlink::waitBriefly(kAttention, [this] { return open_ == 0; });
  std::unique_lock lock(mutex_);
  while (!handover_ && !done_.wait_for(lock, kTurnLook, [this] { return open_ == 0; }))
    giveUp(patience, late);
  while (handover_ && open_ != 0) {
    lock.unlock();
    const bool isDone = handover_->done.wait(kTurnLook);
    lock.lock();
    if (!isDone) giveUp(patience, late);
  }
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
  robotlink::BriefWait wait(kAttention);
  while (true) {
    if (!handover_) wait.look([this] { return areWaiting_.load(); });
    while (handover_ && !areWaiting_) handover_->wanted.wait();
    std::unique_lock lock(mutex_);
    wanted_.wait(lock, [this] { return isOver_ || !waiting_.empty(); });
    wait.end();
    if (waiting_.empty()) return;
    worker.member = waiting_.front();
    worker.begin = ModulePatience::Clock::now();
    waiting_.pop_front();
    areWaiting_ = !waiting_.empty();
    lock.unlock();
    turn_(*worker.member);
    lock.lock();
    worker.member.reset();
    const bool isLost = worker.isLost;
    if (!isLost && --open_ > 0) continue;
    // A thread that is woken while the lock is held has to wait for it again at once.
    lock.unlock();
    if (handover_ && !isLost) handover_->done.signal();
    done_.notify_all();
    // The thread that joins it may hold the lock.
    if (isLost) return;
  }
}

}  // namespace app
