// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Clock.h"

namespace robotlink {

/// Decides when something with a debug key's mode is due, with the same meaning of the modes as DebugContext,
/// for things that are not DebugKeys, such as packages on request. A plain value; internal to this folder.
class ModeCounter {
 public:
  /// Sets the mode and resets the counter; N_TIMES with n = 0 means OFF.
  void set(const robotcontrol::KeyMode& mode) {
    mode_ = mode;
    const bool never = mode.kind() == robotcontrol::KeyMode::N_TIMES && mode.n() == 0;
    if (never) mode_.set_kind(robotcontrol::KeyMode::OFF);
    if (mode_.kind() == robotcontrol::KeyMode::OFF || mode_.kind() == robotcontrol::KeyMode::ALWAYS)
      mode_.set_n(0);
    count_ = 0;
  }
  /// After N_TIMES has run out, the kind is OFF and n is kept.
  const robotcontrol::KeyMode& mode() const { return mode_; }
  /// Counts one use at time `now`; returns true if it is due.
  bool due(Instant now);

 private:
  robotcontrol::KeyMode mode_;
  /// Uses since set(), or since the last time it was due.
  std::uint32_t count_ = 0;
  /// The last time it was due, for EVERY_MS.
  Instant last_;
};

inline bool ModeCounter::due(Instant now) {
  using robotcontrol::KeyMode;
  switch (mode_.kind()) {
    case KeyMode::ALWAYS:
      return true;
    // Switches itself off with the last use.
    case KeyMode::N_TIMES:
      if (++count_ >= mode_.n()) mode_.set_kind(KeyMode::OFF);
      return true;
    // True at the n-th use, then at the 2n-th, ...
    case KeyMode::EVERY_N:
      if (++count_ < mode_.n()) return false;
      count_ = 0;
      return true;
    // True at the first use, then at least n ms apart; count_ is 0 only before the first.
    case KeyMode::EVERY_MS: {
      const Duration since = now - last_;
      const bool backInTime = since < Duration::zero();  // the simulation was reset
      if (count_ > 0 && !backInTime && since < std::chrono::milliseconds(mode_.n())) return false;
      count_ = 1;
      last_ = now;
      return true;
    }
    default:
      return false;
  }
}

}  // namespace robotlink
