// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "robotlink/arcos/RobotType.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {

/// A command to the motors: speeds of the wheels' rims, and whether the motors have power.
struct WheelCommand {
  /// Meters per second.
  double left = 0, right = 0;
  /// If off, the wheels roll freely.
  bool motorsOn = false;
  bool operator==(const WheelCommand&) const = default;
};

/// A robot's motion parameters, which it stores permanently (FLASH). SI units and radians.
struct MotionParameters {
  /// Maximal speed, also used by move().
  double speed = 0.75;
  /// Meters per second squared.
  double acceleration = 0.3, deceleration = 0.3;
  /// Maximal rotation, also used by turnTo().
  double rotation = radians(100.0);
  double rotationAcceleration = radians(100.0), rotationDeceleration = radians(100.0);
  /// Upper bounds that no command can exceed.
  double speedTop = 1.5, accelerationTop = 2.0;
  double rotationTop = radians(300.0), rotationAccelerationTop = radians(600.0);
  /// The effective distance of the wheels, m: rotation is (right - left) / track. For skid steering it is
  /// larger than the distance between the wheels.
  double track = RobotType{}.track;
  /// How long the motors have no power after a stall.
  Duration stallPause = std::chrono::milliseconds(200);
};

/// The motion control of a Pioneer's microcontroller. Two channels, translation and rotation, follow
/// trapezoidal profiles to a speed or to a position, with the wheel encoders as the only sensors (Pioneer 3
/// Operations Manual, "Client motion commands").
///
/// Stepped by its owner; knows neither packets nor clocks. Any sequence of calls and any numbers are safe:
/// values that are not finite count as 0, values that are too large are limited. Positions are in the
/// odometry frame, whose origin is where the robot was switched on or its odometry set. Not thread-safe.
class MotionController {
 public:
  /// The sensor readings of a step.
  struct Wheels {
    /// Travel of the wheels' rims by the encoders, m.
    double leftTravel = 0, rightTravel = 0;
    // The wheel does not turn although it is driven.
    bool leftBlocked = false, rightBlocked = false;
    /// The rate of a gyroscope, rad/s, if the heading is to be based on it rather than on the wheels.
    std::optional<double> rotationRate;
  };

  /// Starts with the motors off.
  explicit MotionController(MotionParameters flash = {});

  // Limits. Speeds apply to later commands, accelerations immediately. Signs are ignored; 0 changes nothing.
  void setSpeed(double speed);
  void setRotation(double rate);
  void setAcceleration(double acceleration);
  void setDeceleration(double deceleration);
  void setRotationAcceleration(double acceleration);
  void setRotationDeceleration(double deceleration);
  /// Restores the parameters of FLASH.
  void restoreParameters();
  const MotionParameters& parameters() const { return parameters_; }

  // Commands, ignored while the motors are off. Each replaces the previous command of its channel and does
  // not affect the other channel. m, m/s, rad and rad/s.
  void translate(double speed);
  void move(double distance);
  void rotate(double rate);
  void turnTo(double heading);
  /// Relative to the present heading.
  void turnBy(double angle);
  /// Relative to the goal of the last turn.
  void turnFromSetpoint(double angle);

  // Commands for both channels.
  /// Speeds of the wheels, converted to translation and rotation, each limited. This and the commands above
  /// replace each other.
  void driveWheels(double left, double right);
  /// Brakes with the configured deceleration.
  void stop();
  /// Stops at once.
  void emergencyStop();

  /// Switches the motors. A robot starts from rest, and commands are forgotten when the motors are switched
  /// off.
  void enable(bool motors);
  /// While held, the robot brakes and stands; afterward it resumes its command.
  void hold(bool held) { held_ = held; }
  /// Stops at once and sets the odometry to 0, for encoders that start again. Motors and parameters keep
  /// their state.
  void reset();
  /// Call this when the encoders continue from other numbers; the odometry stays.
  void encodersJumped() { last_.reset(); }
  /// Sets the pose of the odometry. The goal of a turn to a heading is adjusted, so that the turn ends where
  /// it would have.
  void setOdometry(const Pose2& pose);

  /// Advances by `passed`: updates the odometry, checks for stalls, and returns the command for the motors.
  WheelCommand step(const Wheels& wheels, Duration passed);

  const Pose2& odometry() const { return odometry_; }
  bool motorsOn() const { return motorsOn_; }
  bool leftStalled() const { return leftStalled_; }
  bool rightStalled() const { return rightStalled_; }
  /// The goal of the current turn, or the present heading if there is none.
  double headingSetpoint() const;
  /// Whether the robot is driven: a profile's speed is not 0.
  bool moving() const;
  /// Reacts as to a collision (for bumpers that count as stalls): the motors have no power for a while.
  void stall(bool left, bool right);

 private:
  /// The profile of translation or rotation.
  struct Channel {
    enum class Aim : std::uint8_t { kSpeed, kPosition };
    Aim aim = Aim::kSpeed;
    /// A speed or a position.
    double target = 0;
    /// Maximal speed on the way to a position.
    double limit = 0;
    /// Current speed of the profile.
    double speed = 0;
  };

  /// Ends a driveWheels() command, so that a command for one channel leaves the other at rest.
  void beginCommand();
  void updateOdometry(const Wheels& wheels, Duration passed);
  void checkStall(const Wheels& wheels, Duration passed);
  /// The speeds that the commands ask for now, before acceleration limits.
  double translationWanted(double passed);
  double rotationWanted(double passed);

  const MotionParameters flash_;
  MotionParameters parameters_;
  Channel translation_, rotation_;
  /// Whether the last command was driveWheels().
  bool wheelsDriven_ = false;
  bool motorsOn_ = false;
  bool held_ = false;
  Pose2 odometry_;
  /// Distance traveled by the robot's center, forwards minus backwards, m.
  double traveled_ = 0;
  /// The encoders of the previous step; empty after a reset.
  std::optional<Wheels> last_;
  bool leftStalled_ = false, rightStalled_ = false;
  /// How long the motors will have no power.
  Duration stallLeft_{};
};

}  // namespace robotlink::arcos
