// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace app {

/// Buffers the events of a program whose turn runs in another thread until the turn has returned, so that
/// the owner's thread handles it in order, also when the turn returns late. Outside of turns it is handled at
/// once. add() may be called from any thread.
class TurnEvents {
 public:
  using Event = std::function<void()>;

  /// From now on events are kept.
  void beginTurn() {
    const std::lock_guard lock(mutex_);
    isTurn_ = true;
  }
  /// The turn has returned: handles what was kept, and from now on events are handled at once.
  void endTurn() {
    std::vector<Event> events;
    {
      const std::lock_guard lock(mutex_);
      isTurn_ = false;
      events = std::exchange(events_, {});
    }
    for (const Event& event : events) event();
  }
  /// Call this when another program replaces the present one, whose events are dropped from now on.
  void beginProgram() {
    const std::lock_guard lock(mutex_);
    ++program_;
    isTurn_ = false;
    events_.clear();
  }
  /// The number of the present program.
  std::uint64_t program() const {
    const std::lock_guard lock(mutex_);
    return program_;
  }
  /// Keeps or handles an event of a program.
  void add(std::uint64_t program, Event event) {
    {
      const std::lock_guard lock(mutex_);
      if (program != program_) return;
      if (isTurn_) {
        events_.push_back(std::move(event));
        return;
      }
    }
    event();
  }
  /// The same, of the present one.
  void add(Event event) { add(program(), std::move(event)); }

 private:
  mutable std::mutex mutex_;  // protects the rest
  std::uint64_t program_ = 0;
  bool isTurn_ = false;
  std::vector<Event> events_;
};

}  // namespace app
