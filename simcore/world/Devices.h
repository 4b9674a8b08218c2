// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "simcore/world/ActuatorDescription.h"
#include "simcore/world/CameraModel.h"
#include "simcore/world/PortInfo.h"
#include "simcore/world/RenderScene.h"
#include "simcore/world/SensorErrors.h"

namespace simcore {

/// A sensor that yields numbers. The reading is that of the last step, including noise.
struct Sensor {
  PortInfo info;
  /// In the unit and shape of `info`.
  std::vector<double> values;
  /// The step of the simulation in which it was measured.
  std::uint64_t step = 0;
};

/// A camera on a robot; its images are rendered by a CameraRenderer.
struct CameraSensor {
  PortInfo info;
  CameraModel model;
  /// Index in RenderScene::bodies.
  int body = 0;
  Pose3 cameraInBody = Pose3::Identity();
  /// The time between images.
  robotlink::Duration period{};
  /// Standard deviation of each channel in gray values; to be applied only if the simulation's options ask
  /// for noise.
  double noise = 0;
  /// Exposure and readout of the rows.
  ShutterModel shutter = {};
  /// Only its timing counts: delay, rate and drop-outs.
  SensorErrors errors = {};
};

/// The servo of a joint: it turns to a requested angle with limited speed and torque. That of a prismatic
/// joint moves to a requested position; then all is in m, m/s and N.
struct Servo {
  /// The port of the command, such as "red1/legFL1/request".
  PortInfo info;
  /// Radians.
  double minimum = 0, maximum = 0;
  /// Radians per second.
  double maximumSpeed = 0;
  /// Newton meters.
  double maximumTorque = 0;
  /// The kind of the command, and how the servo follows it.
  MotorControl control = {};
};

/// The reference to a door's sensor.
struct DoorSensor {
  enum class Kind : std::uint8_t { kNone, kNumber, kRange };
  Kind kind = Kind::kNone;
  /// Among the sensors or the range sensors.
  std::size_t index = 0;
  /// Whether the sensor reads 0 or 1 instead of a distance.
  bool isContact = false;
};

/// A joint that opens by itself and on command; see DoorDescription.
struct Door {
  /// "gate/hinge/door": a scalar, 1 opens it and 0 closes it.
  PortInfo info;
  DoorDescription description;
  /// The index of its servo.
  std::size_t servo = 0;
  DoorSensor sensor = {};
};

/// A model that moves as it is commanded.
struct Guide {
  /// "ball/motion": shape {6}, {3} or {2}; see GuidedMotion.
  PortInfo info;
  GuidedMotion motion;
};

/// The state of an actuator after its last command.
struct ActuatorState {
  /// Whether its position (servos), speed or torque is that of the command, within 1 % of its range.
  bool reached = false;
  /// Since the command, what it moves has touched nothing but floors: of a servo the links below its joint,
  /// of a drive or a guide the whole model.
  bool unobstructed = true;
};

/// Driven wheels on the two sides of a robot ("skid steering"). The wheels of a side have one speed.
struct WheelDrive {
  PortInfo info;            ///< "p3at1/drive": the speeds of the left and the right rims, {2}, m/s
  std::string controller;   ///< the protocol of its microcontroller ("arcos"); empty: it has none
  double wheelRadius = 0;   ///< m
  double track = 0;         ///< m; while nothing is in the way, the robot turns by (right - left) / track
  double maximumSpeed = 0;  ///< m/s, of the rims
};

/// The readings of a drive's encoders and motors. Travel is that of the rims, the mean of a side's wheels,
/// since the simulation began. It never wraps, and counts on while wheels slip.
struct WheelState {
  /// Meters.
  double leftTravel = 0, rightTravel = 0;
  /// Meters per second.
  double leftSpeed = 0, rightSpeed = 0;
  /// True if for at least 0.1 s the motors have been at their limit and the wheels have hardly turned.
  bool leftBlocked = false, rightBlocked = false;
};

}  // namespace simcore
