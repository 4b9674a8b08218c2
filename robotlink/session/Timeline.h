// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"

namespace robotlink {

/// The instant that a session shows; all of its views follow it. Live, it is the newest instant; otherwise it
/// is one that the user chose, while the robot keeps running. Only in the GUI's thread.
class Timeline {
 public:
  /// Whether the newest instant is shown.
  bool live() const { return live_; }
  Instant shown() const { return live_ ? newest_ : chosen_; }
  Instant newest() const { return newest_; }

  /// The instant that views display as 0 s: the platform's zero, unless it was set to the start of a log.
  Instant origin() const { return origin_; }
  void setOrigin(Instant time) { origin_ = time; }
  /// The time that views display for an instant.
  Duration sinceOrigin(Instant time) const { return time - origin_; }

  void goLive() { live_ = true; }
  /// Stops following the newest instant and shows this one.
  void show(Instant time) {
    live_ = false;
    chosen_ = time;
  }
  /// Called by the session in each tick.
  void setNewest(Instant time) { newest_ = time; }

 private:
  bool live_ = true;
  Instant newest_;
  /// The instant that is shown while not live.
  Instant chosen_;
  Instant origin_;
};

}  // namespace robotlink
