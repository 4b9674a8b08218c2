// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace robotlink::arcos {

/// The state of a gripper with two fingers and a lift. A plain value.
struct GripperState {
  /// The fingers are at their outer end, or at their inner one.
  bool open = false, closed = false;
  /// The fingers move.
  bool moving = false;
  /// The lift is at one of its ends, or moves.
  bool liftUp = false, liftDown = false, liftMoving = false;
  bool operator==(const GripperState&) const = default;
};

/// Reads the bits of a state packet.
constexpr GripperState gripperState(std::uint8_t bits) {
  const auto bit = [bits](unsigned number) { return (bits >> number & 1U) != 0; };
  return {bit(0), bit(1), bit(2), bit(4), bit(5), bit(6)};
}

/// The actions of a gripper: the arguments of the command GRIPPER.
enum class GripperAction : std::uint8_t {
  kOpen = 1,
  kClose = 2,
  kStop = 3,
  kLiftUp = 4,
  kLiftDown = 5,
  kLiftStop = 6,
  kStore = 7,   ///< closes, and lifts: for driving
  kDeploy = 8,  ///< opens, and lowers: for grasping
  kHalt = 15    ///< stops fingers and lift
};

}  // namespace robotlink::arcos
