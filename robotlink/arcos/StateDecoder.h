// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/arcos/RobotState.h"
#include "robotlink/arcos/RobotType.h"
#include "robotlink/arcos/codec/StandardInformation.h"

namespace robotlink::arcos {

/// Converts a robot's information packets to its state: SI units, an odometry that does not wrap, and the
/// latest range of every sonar although each packet contains only some. For one connection; not thread-safe.
class StateDecoder {
 public:
  explicit StateDecoder(RobotType type);

  /// Updates the state with a packet that arrived at `now`.
  void take(const StandardInformation& information, Instant now);
  /// Prepares for a reset of the robot's odometry commanded at `now`: it will jump within half a second.
  void expectReset(Instant now) { resetUntil_ = now + kResetTime; }

  /// The pose that corresponds to an odometry of the wire, as of a scan: near state().pose, because it does
  /// not wrap, either. `heading` in rad.
  Pose2 odometryAt(int xMm, int yMm, double heading) const;

  const RobotState& state() const { return state_; }
  const RobotType& type() const { return type_; }

 private:
  /// How long a reset of the odometry is expected after its command.
  static constexpr Duration kResetTime = std::chrono::milliseconds(500);

  /// Unwraps the position, and recognizes resets.
  void followOdometry(const StandardInformation& information, Instant now);
  /// Updates the ranges that a packet has.
  void takeSonars(const StandardInformation& information, Instant now);

  RobotType type_;
  RobotState state_;
  /// Position in units of the wire.
  struct Counts {
    int x = 0, y = 0;
  };
  /// The counts of the last packet, before unwrapping.
  std::optional<Counts> last_;
  /// The time until which a position near the origin counts as the reset.
  std::optional<Instant> resetUntil_;
};

}  // namespace robotlink::arcos
