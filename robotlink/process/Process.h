// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/process/EndOwner.h"
#include "robotlink/process/Sender.h"

namespace robotlink {

/// A loop of three phases (as in the GermanTeam's paper of 2002): (1) all receivers take what is available,
/// until all blocking ends are satisfied and the period, if any, is over; (2) execute(), which may send; (3)
/// packages that were sent and not yet delivered go to the receivers when those are ready. Nothing is queued:
/// a slow process misses packages, and phase 2 sees the newest.
///
/// An executor drives it: tryBeginFrame() and runFrame() are called by one thread at a time; wake(), stop()
/// and the statistics by any thread. The clock must outlive it. A process that throws is stopped, and
/// failure() returns the exception's text.
class Process : public EndOwner {
 public:
  Process(std::string name, const Clock& clock);
  ~Process() override;

  const Clock& clock() const { return clock_; }
  /// The minimal time from the start of one frame to that of the next, without drift; 0 means event-driven.
  /// Set it before the process runs.
  void setPeriod(Duration period) { period_ = period; }
  Duration period() const { return period_; }
  /// The nice value, used by executors that give each process a thread.
  void setPriority(int priority) { priority_ = priority; }
  int priority() const { return priority_; }

  /// Phase 1: takes available packages; returns true if phase 2 may start now.
  bool tryBeginFrame();
  /// Phases 2 and 3. Call it only after tryBeginFrame() returned true.
  void runFrame();
  /// Calls a function on behalf of the process; an exception stops the process. Returns false if it threw.
  bool guard(const std::function<void()>& call);
  /// Phase 1, waiting; returns false if the process was stopped. For executors that give the process a
  /// thread. Sleeps until the period is over (its clock taken as real time) or the process is woken, but for
  /// at most `limit` at a time, because the clock may be set.
  bool waitForFrame(std::chrono::milliseconds limit);

  /// Describes what the process waits for, for users: "package camera/image of simulation", "its package
  /// joints/request to be taken", "its period". Only from the thread that runs it.
  std::string waitsFor() const;
  /// The time at which the current or last frame started, by the process's clock.
  Instant frameTime() const { return frameTime_; }
  /// The earliest time of the next frame; empty if event-driven or before the first frame.
  std::optional<Instant> due() const;

  void wake() override;
  /// Stops the process, even while it waits; its links are closed and never block another process again. Any
  /// thread.
  void stop();
  bool stopped() const { return stopped_.load(std::memory_order_acquire); }
  /// The text of the exception that it threw; empty if it did not throw.
  std::string failure() const;
  /// Returns the current activity, for users: "ball-percept (region)", a task with its solution; null
  /// between tasks and outside of frames. The text lives as long as the process. Any thread.
  const std::string* activity() const { return activity_.load(std::memory_order_relaxed); }
  /// The number of frames that ran to their end.
  std::uint64_t frames() const { return frames_.load(std::memory_order_relaxed); }

 protected:
  /// Phase 2: reads receivers, computes, sends. Called in the executor's thread.
  virtual void execute() = 0;
  /// The slot in which the parts of a process note their activity; see activity().
  std::atomic<const std::string*>& activitySlot() { return activity_; }

 private:
  bool satisfied() const;
  void startPeriod(Instant now);
  Duration untilDue() const;

  const Clock& clock_;
  Duration period_{0};
  int priority_ = 0;
  /// Set in every frame if there is a period; reset when the clock was set back.
  std::optional<Instant> due_;
  Instant frameTime_;
  std::atomic<bool> stopped_{false};
  std::atomic<std::uint64_t> frames_{0};
  std::atomic<const std::string*> activity_{nullptr};

  /// Protects woken_ and failure_.
  mutable std::mutex mutex_;
  std::condition_variable wakeUp_;
  bool woken_ = false;
  std::string failure_;
};

}  // namespace robotlink
