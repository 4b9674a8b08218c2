// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"

namespace robotlink {

/// Which instant a session shows; all of its views follow it. Live: the newest; else a chosen one, while the
/// robot goes on. The GUI's thread only.
class Timeline {
 public:
  bool live() const { return live_; }
  Instant shown() const { return live_ ? newest_ : chosen_; }
  Instant newest() const { return newest_; }

  /// The instant that views show as 0 s: the platform's own zero, unless somebody chose to count from a log's
  /// begin.
  Instant origin() const { return origin_; }
  void setOrigin(Instant time) { origin_ = time; }
  /// What views show for an instant.
  Duration sinceOrigin(Instant time) const { return time - origin_; }

  void goLive() { live_ = true; }
  void show(Instant time) {
    live_ = false;
    chosen_ = time;
  }
  void setNewest(Instant time) { newest_ = time; }

 private:
  bool live_ = true;
  Instant newest_;
  Instant chosen_;
  Instant origin_;
};

}  // namespace robotlink
