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

/// A loop of three phases (the paper of the GermanTeam, 2002): (1) all receivers take what is available,
/// until all blocking ends are satisfied and the period, if there is one, is over; (2) execute(), which may
/// send; (3) what was sent and not yet delivered is delivered to the receivers that are ready. Nothing is
/// queued: a slow process misses packages, and what enters phase 2 is the newest.
///
/// An executor drives it: tryBeginFrame() and runFrame() are called by one thread at a time; wake(), stop()
/// and the statistics by any. The clock must outlive it. A process that throws is stopped, with the
/// exception's text as failure().
class Process : public EndOwner {
 public:
  Process(std::string name, const Clock& clock);
  ~Process() override;

  const Clock& clock() const { return clock_; }
  /// At least this long from one frame's start to the next, drift corrected; 0 is event-driven. Before it
  /// runs.
  void setPeriod(Duration period) { period_ = period; }
  Duration period() const { return period_; }
  /// A nice value, for executors that have a thread for each process.
  void setPriority(int priority) { priority_ = priority; }
  int priority() const { return priority_; }

  /// Phase 1: takes what is available; true if phase 2 may start now.
  bool tryBeginFrame();
  /// Phases 2 and 3; only after tryBeginFrame() returned true.
  void runFrame();
  /// Calls something that belongs to the process; what it throws stops the process. False if it did.
  bool guard(const std::function<void()>& call);
  /// Phase 1, waiting; false if the process was stopped. Only for executors that give it a thread. It sleeps
  /// until its period is over by its clock, taken as real time, until it is woken, but at most for `limit` at
  /// a time.
  bool waitForFrame(std::chrono::milliseconds limit);

  /// What it waits for, in words: "package camera/image of simulation", "its package joints/request to be
  /// taken", "its period". For the thread that runs it.
  std::string waitsFor() const;
  /// The start of the current or last frame, by the clock.
  Instant frameTime() const { return frameTime_; }
  std::optional<Instant> due() const;

  void wake() override;
  /// Ends it, even while it waits; its links never hold another process back from now on.
  void stop();
  bool stopped() const { return stopped_.load(std::memory_order_acquire); }
  /// What it threw; empty if it did not.
  std::string failure() const;
  std::uint64_t frames() const { return frames_.load(std::memory_order_relaxed); }

 protected:
  virtual void execute() = 0;

 private:
  bool satisfied() const;
  void startPeriod(Instant now);
  Duration untilDue() const;

  const Clock& clock_;
  Duration period_{0};
  int priority_ = 0;
  std::optional<Instant> due_;
  Instant frameTime_;
  std::atomic<bool> stopped_{false};
  std::atomic<std::uint64_t> frames_{0};

  mutable std::mutex mutex_;  // protects woken_ and failure_
  std::condition_variable wakeUp_;
  bool woken_ = false;
  std::string failure_;
};

}  // namespace robotlink
