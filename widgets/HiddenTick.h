// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace widgets {

/// A view that collects messages over time, and must not lack those that arrived while it was hidden. It
/// derives from this in addition to View. GUI thread.
class HiddenTick {
 public:
  virtual ~HiddenTick() = default;
  /// Called in place of View::tick() while the view is open, but behind another tab: takes what has arrived,
  /// which the session's history may drop before the view is seen again. Draws nothing, and costs little.
  virtual void tickHidden() = 0;
};

}  // namespace widgets
