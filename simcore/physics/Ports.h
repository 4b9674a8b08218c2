// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/rendering/RayCaster.h"
#include "simcore/world/Devices.h"
#include "simcore/world/RangeSensor.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Where a sensor's reading comes from, by the numbers of Physics.
struct SensorSource {
  enum class Kind : std::uint8_t { kAngle, kDistance, kAccelerometer, kGyroscope, kContact };
  Kind kind = Kind::kAngle;
  int model = 0;
  std::size_t hinge = 0;  ///< kAngle
  std::size_t body = 0;   ///< the others
  Pose3 poseInLink = Pose3::Identity();
  int collision = 0;
  double noise = 0, minimum = 0, maximum = 0;
};

/// A servo and what it was told.
struct ServoState {
  std::size_t hinge = 0;
  double target = 0;
  double torqueShare = 1;
};

/// All sensors, cameras, range sensors, servos and drives of a world, in the order of its models: a model's
/// joints come first, then its sensors. sources[i] belongs to sensors[i], servoStates[i] to servos[i],
/// driveModels[i] to drives[i]. The wheels of a drive are no joints here: their drive tells how they turn.
struct Ports {
  std::vector<Sensor> sensors;
  std::vector<SensorSource> sources;
  std::vector<CameraSensor> cameras;
  std::vector<RangeSensor> ranges;
  std::vector<RayCaster::BodyRange> rangeOwners;  ///< the bodies of the models that ranges are on
  std::vector<Servo> servos;
  std::vector<ServoState> servoStates;
  std::vector<WheelDrive> drives;
  std::vector<int> driveModels;

  static Ports of(const WorldDescription& world);
};

}  // namespace simcore
