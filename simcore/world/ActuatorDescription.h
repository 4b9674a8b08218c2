// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// How the motor of a joint follows its commands. A plain value.
struct MotorControl {
  enum class Kind : std::uint8_t {
    /// The command is a position, and the motor as stiff as its torque allows: with gains of 0, which is the
    /// default, it approaches the position within a few steps.
    kPosition,
    /// The command is a speed, rad/s or m/s.
    kVelocity,
    /// The command is a torque or force, N m or N.
    kTorque,
  };
  Kind kind = Kind::kPosition;
  /// Gains of a position servo; its torque is p * error + i * integral of the error - d * speed, limited to
  /// the motor's. N m/rad, N m/(rad s), N m s/rad (for slides N/m, ...). All 0: as stiff as the motor allows.
  double p = 0, i = 0, d = 0;
  /// From a command until it counts, s, 0 to 1.
  double delay = 0;
  bool usesGains() const { return p != 0 || i != 0 || d != 0; }
  bool operator==(const MotorControl&) const = default;
};

/// When the servo of a joint opens and closes it as a door. A plain value; positions are those of the joint,
/// rad or m.
struct DoorDescription {
  /// The name of the sensor of the same model that opens it; empty: only commands do.
  std::string sensor;
  /// It opens if the sensor reads less, m; without meaning for a sensor that feels, which opens it when it is
  /// touched.
  double below = 0;
  double open = 0, closed = 0;
  /// How long it stays open after the last reason to open it, s.
  double seconds = 3;
  bool operator==(const DoorDescription&) const = default;
};

/// A model that moves as it is commanded instead of by forces of its own: it is pushed with limited
/// acceleration, and stopped by what is in its way.
struct GuidedMotion {
  enum class Kind : std::uint8_t {
    /// {vx, vy, vz, wx, wy, wz} in the model's frame, m/s and rad/s: flies, without weight.
    kFree,
    /// {vx, vy, wz} in the model's frame: an omni-directional drive on the ground.
    kOmni,
    /// {speed of both sides: left, right}, m/s; the track is `track`.
    kDifferential,
    /// The same, but turning by the share `skid` of what its wheels do.
    kSkid,
    /// {speed m/s, steering angle rad} of a driven rear and a steered front axle `wheelbase` apart. The
    /// model's
    /// origin is above the rear axle.
    kAckermann,
    /// {vx, vy, wz} of a walking robot, which then stands upright and is moved in the plane only.
    kWalk,
  };
  Kind kind = Kind::kFree;
  std::string name = "motion";
  double maximumSpeed = 1;          ///< m/s
  double maximumRate = 3;           ///< rad/s
  double acceleration = 5;          ///< m/s^2
  double angularAcceleration = 20;  ///< rad/s^2
  double track = 0.3, wheelbase = 0.3, skid = 1, maximumSteering = 0.6;
  bool operator==(const GuidedMotion&) const = default;
};

}  // namespace simcore
