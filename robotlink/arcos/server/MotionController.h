// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink::arcos {

/// What the motors are told: speeds of the wheels' rims, and whether they have power at all.
struct WheelCommand {
  double left = 0, right = 0;  ///< m/s
  bool motorsOn = false;       ///< off: the wheels roll freely
  bool operator==(const WheelCommand&) const = default;
};

/// The robot's parameters of motion, as it keeps them over a restart (FLASH). SI units and radians.
struct MotionParameters {
  double speed = 0.75;  ///< at most, also of move()
  double acceleration = 0.3, deceleration = 0.3;
  double rotation = radians(100.0);  ///< at most, also of turnTo()
  double rotationAcceleration = radians(100.0), rotationDeceleration = radians(100.0);
  /// What no command can go beyond.
  double speedTop = 1.5, accelerationTop = 2.0;
  double rotationTop = radians(300.0), rotationAccelerationTop = radians(600.0);
  /// Turning is (right - left) / track; skid steering makes it wider than the wheels are apart.
  double track = 0.588;
  /// How long the motors stay without power after a stall.
  Duration stallPause = std::chrono::milliseconds(200);
};

/// How a Pioneer's microcontroller moves the robot: two channels, translation and rotation, each led along a
/// trapezoidal profile to a speed or to a position; wheels' encoders as its only sense (Pioneer 3 Operations
/// Manual, "Client motion commands").
///
/// Stepped by its owner; knows no packets and no clock. Any order of calls and any numbers are harmless: what
/// is not finite counts as 0, what is too large is limited. Positions are those of the odometry, whose frame
/// begins where the robot was switched on.
class MotionController {
 public:
  struct Wheels {
    double leftTravel = 0, rightTravel = 0;  ///< m of the rims, as the encoders count them
    bool leftBlocked = false, rightBlocked = false;
    std::optional<double>
        rotationRate;  ///< rad/s, of a gyroscope that the heading shall go by instead of by the wheels
  };

  explicit MotionController(MotionParameters flash = {});

  // Limits. Speeds hold for the commands that follow, accelerations at once. Signs are ignored; 0 changes
  // nothing.
  void setSpeed(double speed);
  void setRotation(double rate);
  void setAcceleration(double acceleration);
  void setDeceleration(double deceleration);
  void setRotationAcceleration(double acceleration);
  void setRotationDeceleration(double deceleration);
  /// Those of FLASH again.
  void restoreParameters();
  const MotionParameters& parameters() const { return parameters_; }

  // Commands; without motors they are ignored. Each replaces what its channel did before, and leaves the
  // other one alone.
  void translate(double speed);
  void move(double distance);
  void rotate(double rate);
  void turnTo(double heading);
  void turnBy(double angle);            ///< from the present heading
  void turnFromSetpoint(double angle);  ///< from where the last turn was to end

  // Commands to both channels.
  /// Taken apart into translation and rotation, each limited; whichever of this and the commands above comes
  /// later ends the other.
  void driveWheels(double left, double right);
  void stop();           ///< along the profile
  void emergencyStop();  ///< at once

  /// Motors that are switched on begin at rest; those that are switched off forget what they did.
  void enable(bool motors);
  /// While held, the robot stops along the profile and stays; then it goes on with what it was told.
  void hold(bool held) { held_ = held; }
  /// Stands still at once, with the odometry at 0 and encoders that begin anew; motors and parameters stay as
  /// they are.
  void reset();
  /// The robot is there now; a turn to a heading ends where it would have ended.
  void setOdometry(const Pose2& pose);

  WheelCommand step(const Wheels& wheels, Duration passed);

  const Pose2& odometry() const { return odometry_; }
  bool motorsOn() const { return motorsOn_; }
  bool leftStalled() const { return leftStalled_; }
  bool rightStalled() const { return rightStalled_; }
  /// Where a turn shall end, or the present heading when none was asked for.
  double headingSetpoint() const;
  /// Whether a command moves it, or the profile still runs out.
  bool moving() const;
  /// Treats the robot as if it had run into something (a bumper that shall count as a stall).
  void stall(bool left, bool right);

 private:
  struct Channel {
    enum class Aim : std::uint8_t { kSpeed, kPosition };
    Aim aim = Aim::kSpeed;
    double target = 0;  ///< speed, or position
    double limit = 0;   ///< of the speed on the way to a position
    double speed = 0;   ///< where the profile is
  };

  void beginCommand();
  void updateOdometry(const Wheels& wheels, Duration passed);
  void checkStall(const Wheels& wheels, Duration passed);
  double translationWanted(double passed);
  double rotationWanted(double passed);

  const MotionParameters flash_;
  MotionParameters parameters_;
  Channel translation_, rotation_;
  bool wheelsDriven_ = false;  ///< the last command was driveWheels()
  bool motorsOn_ = false;
  bool held_ = false;
  Pose2 odometry_;
  double travelled_ = 0;  ///< m, of the robot's centre, forwards less backwards
  std::optional<Wheels> last_;
  bool leftStalled_ = false, rightStalled_ = false;
  Duration stallLeft_{};  ///< how long the motors stay without power
};

}  // namespace robotlink::arcos
