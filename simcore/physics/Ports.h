// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/rendering/RayCaster.h"
#include "simcore/world/Devices.h"
#include "simcore/world/RangeSensor.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// The source of a sensor's reading, in the numbering of Physics.
struct SensorSource {
  enum class Kind : std::uint8_t { kAngle, kDistance, kAccelerometer, kGyroscope, kContact };
  Kind kind = Kind::kAngle;
  int model = 0;
  /// Only for kAngle.
  std::size_t hinge = 0;
  /// For all other kinds.
  std::size_t body = 0;
  Pose3 poseInLink = Pose3::Identity();
  /// Only for kContact: index in the body's collisions.
  int collision = 0;
  // Standard deviation, and limits of the reading; no limits if maximum <= minimum.
  double noise = 0, minimum = 0, maximum = 0;
};

/// A servo with its commands.
struct ServoState {
  std::size_t hinge = 0;
  /// Radians.
  double target = 0;
  /// Fraction of the maximum torque, 0 to 1.
  double torqueShare = 1;
};

/// All sensors, cameras, range sensors, servos and drives of a world, in the order of its models; for each
/// model, its joints come before its sensors. sources[i] belongs to sensors[i], servoStates[i] to servos[i],
/// driveModels[i] to drives[i]. Wheels of drives are not joints here; their drive reports how they turn.
struct Ports {
  std::vector<Sensor> sensors;
  std::vector<SensorSource> sources;
  std::vector<CameraSensor> cameras;
  std::vector<RangeSensor> ranges;
  /// For each range sensor the bodies of its own model, which it does not see.
  std::vector<RayCaster::BodyRange> rangeOwners;
  std::vector<Servo> servos;
  std::vector<ServoState> servoStates;
  std::vector<WheelDrive> drives;
  std::vector<int> driveModels;

  /// Collects the ports of a world.
  static Ports of(const WorldDescription& world);
};

}  // namespace simcore
