// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "simcore/control/Controllers.h"
#include "simcore/world/ViewEvent.h"

namespace simcore {

/// The part of a simulation that controllers and events are; only for its sources.
struct ControlState {
  /// Null before the first start.
  std::unique_ptr<Controllers> controllers = nullptr;
  /// The events that take effect at the next step, and those that took effect at the last one.
  std::vector<ViewEvent> waiting = {}, events = {};
  /// Whether the controllers were called for the step that comes.
  bool isDone = false;
  /// Whether the controllers are being called.
  bool isRunning = false;
  /// The state of the controllers of a snapshot, until Simulation::resumeControllers().
  Controllers::Memory restored = {};
  /// A hash of all events so far; 0 if there were none.
  std::uint64_t digest = 0;

  void restart() {
    waiting.clear();
    events.clear();
    isDone = false;
    digest = 0;
  }
};

}  // namespace simcore
