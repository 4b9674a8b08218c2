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
};

}  // namespace robotlink
