// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "app/core/program/ModulePatience.h"

namespace app {

/// A thread in which turns are made while whoever asks for one waits, but not for longer than he wants: a
/// turn that does not return keeps this thread only.
class TurnThread {
 public:
  /// The turn is called in the thread of this object.
  explicit TurnThread(std::function<void()> turn);
  /// Waits for the turn that is in progress.
  ~TurnThread();
  TurnThread(const TurnThread&) = delete;
  TurnThread& operator=(const TurnThread&) = delete;

  /// Makes a turn; false if it has not ended when the patience is over. Only while none is in progress.
  bool run(const ModulePatience& patience);
  /// Whether a turn is in progress. Any thread.
  bool isBusy() const;
  /// Waits for it so long; whether it has ended.
  bool waitFor(std::chrono::milliseconds limit);

 private:
  void loop();

  const std::function<void()> turn_;
  /// Protects the rest.
  mutable std::mutex mutex_;
  std::condition_variable wanted_, done_;
  bool isWanted_ = false, isOver_ = false;
  /// The last member, since it uses the others.
  std::thread thread_;
};

}  // namespace app
