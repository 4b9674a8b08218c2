// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
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
  /// The delay from a command until it counts, s, 0 to 1.
  double delay = 0;
  bool usesGains() const { return p != 0 || i != 0 || d != 0; }
  bool operator==(const MotorControl&) const = default;
};

/// When the servo of a joint opens and closes it as a door. A plain value; positions are those of the joint,
/// rad or m.
struct DoorDescription {
  /// The name of the sensor of the same model that opens it; empty: only commands do.
  std::string sensor;
  /// The distance, m, below which the sensor opens the door; ignored for contact sensors, which open it when
  /// they are touched.
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
    /// {speed m/s, steering angle rad} of two axles `wheelbase` apart, of which one is steered. The model's
    /// origin is above the other one.
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

/// How a model moves that can move by itself.
enum class MotionMode : std::uint8_t {
  /// The model moves as the simulation's options say.
  kUnset,
  /// The forces of its motors move it.
  kPhysics,
  /// The model moves as it is commanded, without forces: it pushes movable objects, and stops at the rest.
  kKinematic,
  /// The same, but it stops at whatever is in its way.
  kStopping,
};

/// The walking of a robot on request: the odometry model of its gait. A plain value; {ahead,
/// sideways, turning}.
struct WalkDescription {
  std::string name = "walk";
  /// The share of what is requested by which it really moves.
  std::array<double, 3> slip = {1, 1, 1};
  /// Standard deviations, m and rad, after a way of 1 m or a turn by 1 rad; they grow with the square root of
  /// the sum of both.
  std::array<double, 3> noise = {0, 0, 0};
  double maximumSpeed = 1;  ///< m/s
  double maximumRate = 3;   ///< rad/s
  bool operator==(const WalkDescription&) const = default;
};

/// A wheel of a vehicle.
struct VehicleWheel {
  /// Index of its joint; its child has one solid, a cylinder about the joint's axis.
  int joint = 0;
  bool driven = true;
  /// If its rim has free rollers: the angle from its rolling direction to that in which the rollers push,
  /// rad, to the left; 0 for omni wheels, +-pi/4 for mecanum wheels.
  std::optional<double> rollers = {};
  // The limits of its motor, at the rim: m/s and N; and its resistance without power, N.
  double maximumSpeed = 0, maximumForce = 0, idleForce = 0;
  double radius = 0;  ///< m
  /// The joint that steers it, an index of VehicleDescription::steering; -1 if none does.
  int steering = -1;
  // The center of the wheel, and the direction in which it rolls forward, in the model, with all joints at 0.
  robotlink::Vector3 center = robotlink::Vector3::Zero(), forward = robotlink::Vector3::UnitX();
  bool operator==(const VehicleWheel&) const = default;
};

/// Wheels that roll by forces, and joints that steer them. GuidedMotion::kind says what it is commanded.
struct VehicleDescription {
  std::vector<VehicleWheel> wheels;
  /// Joints with position servos. Of each also: 1 if it turns to the left for positive angles, otherwise -1.
  std::vector<int> steering;
  std::vector<double> steeringSigns;
  /// The command of its driven wheels is a torque of each of them, N m, instead of speeds.
  bool byTorque = false;
  bool operator==(const VehicleDescription&) const = default;
};

}  // namespace simcore
