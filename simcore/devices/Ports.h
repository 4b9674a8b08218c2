// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/noise/NoiseProcess.h"
#include "simcore/rendering/RayCaster.h"
#include "simcore/world/Devices.h"
#include "simcore/world/ImageSensor.h"
#include "simcore/world/RangeSensor.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// A hash of a path, which gives a sensor the same random numbers whatever else is in the scene.
std::uint64_t hashOfPath(const std::string& path);

/// The source of a sensor's reading, in the numbering of Physics.
struct SensorSource {
  enum class Kind : std::uint8_t {
    kAngle,
    kDistance,
    kAccelerometer,
    kGyroscope,
    kContact,
    kJointSpeed,
    kJointLoad,
    kForceTorque,
    kWhisker,
    kMagnetometer,
    kNavSat,
    kAltimeter,
    kOdometry,
    kBattery,
    kSlide,
    /// The travel and speed of a vehicle's wheel; its number is `hinge`, its radius `length`.
    kWheelAngle,
    kWheelSpeed,
  };
  Kind kind = Kind::kAngle;
  int model = 0;
  /// Only for joints. Of a fixed one, which kForceTorque may be in, it is the number among those of its kind.
  std::size_t hinge = 0;
  bool isFixed = false;
  /// For all other kinds, and for kForceTorque the child of the joint.
  std::size_t body = 0;
  Pose3 poseInLink = Pose3::Identity();
  /// Only for kContact: index in the body's collisions, of which there are `collisions`; -1 for all of them.
  int collision = 0, collisions = 0;
  /// The number of its values.
  std::size_t size = 1;
  /// The sensor's errors, and which random numbers it has.
  SensorErrors errors;
  NoiseProcess::Stream stream;
  // Limits of the reading; there are none if maximum <= minimum.
  double minimum = 0, maximum = 0;
  /// Only for kWhisker and wheels, m.
  double length = 0;
  /// Only for kOdometry: the drive and its track; -1 if the model has none.
  int drive = -1;
  double track = 1;
  /// Only for kForceTorque: 1 for what the parent exerts on the child, -1 for the reverse.
  double sign = 1;
  BatteryDescription battery = {};
};

/// A servo with its commands.
struct ServoState {
  std::size_t hinge = 0;
  /// The command that counts: position, speed or torque.
  double target = 0;
  /// Fraction of the maximum torque, 0 to 1.
  double torqueShare = 1;
};

/// The means with which a guide moves its model.
struct GuideMeans {
  enum class Kind : std::uint8_t {
    /// Pushed by forces.
    kPushed,
    /// Rolled by its own wheels.
    kWheels,
    /// Without forces; see ModelInstance::follows().
    kFollows,
  };
  Kind kind = Kind::kPushed;
  // Null if the model has none; they are those of the world.
  const VehicleDescription* vehicle = nullptr;
  const WalkDescription* walk = nullptr;
  /// The first wheel of the model, in the numbering of Physics.
  std::size_t firstWheel = 0;
  /// The servos of VehicleDescription::steering.
  std::vector<std::size_t> steering = {};
};

/// All sensors, cameras, range and image sensors, servos, drives and guides of a world, in the order of its
/// models; for each model, its joints come before its sensors. sources[i] belongs to sensors[i],
/// servoStates[i] to servos[i], driveModels[i] to drives[i]. Wheels of drives are not joints here; their
/// drive reports how they turn.
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
  std::vector<ImageSensor> images;
  /// For each image sensor the bodies of its own model.
  std::vector<RayCaster::BodyRange> imageOwners;
  std::vector<Guide> guides;
  std::vector<GuideMeans> guideMeans;
  std::vector<Door> doors;
  /// For each servo and each guide the index of its model.
  std::vector<int> servoModels, guideModels;
  /// For each servo the bodies that it moves, in the numbering of Physics.
  std::vector<std::vector<std::size_t>> servoBodies;

  /// Collects the ports of a world.
  static Ports of(const WorldDescription& world);
};

}  // namespace simcore
