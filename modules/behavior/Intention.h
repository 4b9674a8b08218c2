// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace modules {

/// A behavior's requests to the motion and head-control tasks.
struct Intention {
  // Motion of the body.
  enum class Motion { kStand, kWalk, kKick, kGetUp };
  // The target of the head.
  enum class Head { kAhead, kSearch, kTrack, kLookAround };
  Motion motion = Motion::kStand;
  double forward = 0, left = 0;  ///< m/s; only for kWalk
  double turn = 0;               ///< rad/s, counterclockwise
  Head head = Head::kAhead;
  /// Name of the key-frame motion, only for kKick; empty: the behavior's usual one.
  std::string kick = {};
  bool operator==(const Intention&) const = default;
};

}  // namespace modules
