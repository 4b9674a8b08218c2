// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "app/core/program/ModulePatience.h"
#include "robotlink/base/threads/HandoverSignal.h"

namespace app {

/// Threads in which the turns of several members are made, several at a time, while the caller
/// waits, for a limited time: a turn that does not return only keeps its member and one thread busy,
/// which is replaced. One thread at a time may ask.
class TurnCrew {
 public:
  /// How a crew of one thread and its caller wait for each other. Alert ones spin for a while,
  /// which is faster where the processors are free; those asleep leave them to others, such as the
  /// views of a window. Crews of several threads are always alert.
  enum class Waiting { kAlert, kAsleep };
  /// `turn` is called with the number of a member in one of `threads` threads, at least one. Turns of
  /// different members must not disturb each other.
  TurnCrew(int threads, std::function<void(std::size_t member)> turn, Waiting waiting = Waiting::kAlert);
  /// Waits for the turns that are in progress.
  ~TurnCrew();
  TurnCrew(const TurnCrew&) = delete;
  TurnCrew& operator=(const TurnCrew&) = delete;

  /// Makes a turn of each of these members, of which none may be busy. Returns those whose turn has not ended
  /// when the patience for it was over, in the order of `members`.
  std::vector<std::size_t> run(std::span<const std::size_t> members, const ModulePatience& patience);
  /// Whether a turn of a member is in progress. Any thread.
  bool isBusy(std::size_t member) const;
  /// Waits for the turn of a member, at most for `limit`. Returns whether it has ended.
  bool waitFor(std::size_t member, std::chrono::milliseconds limit);

 private:
  struct Worker {
    /// The member whose turn this thread is running, and when the turn began; unset: idle.
    std::optional<std::size_t> member = std::nullopt;
    ModulePatience::Clock::time_point begin = {};
    /// The turn was given up: the thread ends with it.
    bool isLost = false;
    /// No robotlink::PacedThread: a thread whose turn was given up is replaced while it still runs, and
    /// threads look for turns for a while before they sleep.
    std::thread thread = {};
  };
  /// The hand-over between the caller and the only thread of a sleeping crew, which run alternately.
  struct Handover {
    robotlink::HandoverSignal wanted, done;
  };
  void addWorker();
  /// Wakes threads for turns.
  void wake(std::size_t turns);
  /// Returns when all turns have ended or were given up.
  void waitForTurns(const ModulePatience& patience, std::vector<std::size_t>& late);
  void loop(Worker& worker);
  /// Gives up turns that take too long; the mutex must be locked.
  void giveUp(const ModulePatience& patience, std::vector<std::size_t>& late);
  /// The mutex must be locked.
  bool isWorking(std::size_t member) const;

  const std::function<void(std::size_t)> turn_;
  /// Null: threads are alert.
  const std::unique_ptr<Handover> handover_;
  /// Protects the rest.
  mutable std::mutex mutex_;
  std::condition_variable wanted_, done_;
  std::deque<std::size_t> waiting_;
  /// Turns of this run that have neither ended nor been given up. Changed with the mutex locked, as the next.
  std::atomic<std::size_t> open_ = 0;
  /// Whether threads find something to do: a turn, or the end.
  std::atomic<bool> areWaiting_ = false;
  bool isOver_ = false;
  /// A list, since threads refer to its elements.
  std::list<Worker> workers_;
};

}  // namespace app
