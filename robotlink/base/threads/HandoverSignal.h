// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace robotlink {

/// A signal between two threads of which one waits while the other one works. It is a pipe: the kernel tends
/// to wake the waiting thread on the processor of the signaling one, which takes some 5 us and keeps no
/// other processor busy; waking a thread by a condition variable takes some 50 us. Several signals before a
/// wait count as one. Throws std::system_error if there are no file descriptors left. Any thread may signal,
/// one at a time waits.
class HandoverSignal {
 public:
  HandoverSignal();
  ~HandoverSignal();
  HandoverSignal(const HandoverSignal&) = delete;
  HandoverSignal& operator=(const HandoverSignal&) = delete;

  void signal();
  /// Waits for a signal; returns whether there was one before the time was over.
  bool wait(std::chrono::milliseconds limit);
  /// Waits for as long as it takes.
  void wait();

 private:
  bool poll(int milliseconds);

  int read_ = -1, write_ = -1;
};

}  // namespace robotlink
