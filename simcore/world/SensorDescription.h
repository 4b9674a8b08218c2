// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "simcore/world/CameraModel.h"
#include "simcore/world/ImageSensor.h"
#include "simcore/world/SensorErrors.h"

namespace simcore {

/// The directions in which a sonar or a laser measures; see RangeSensor.
struct RangeGeometry {
  int readings = 1;
  double startAngle = 0, endAngle = 0;
  double openingAngle = 0, mostIncidence = 0;
};

/// A battery as a sensor reports it: {voltage V, charge 0 to 1}.
struct BatteryDescription {
  double capacity = 1e5;     ///< J, when it is full
  double charge = 1;         ///< at the start, 0 to 1
  double fullVoltage = 12;   ///< V; the voltage between the two is linear in the charge
  double emptyVoltage = 10;  ///< V
  double idlePower = 5;      ///< W, without any motion
  double efficiency = 0.7;   ///< mechanical by electrical power of the motors
  bool operator==(const BatteryDescription&) const = default;
};

/// A sensor of a link, or of the joint above it.
struct SensorDescription {
  enum class Kind : std::uint8_t {
    kCamera,
    kDistance,
    kAccelerometer,
    kGyroscope,
    kContact,
    kSonar,
    kLaser,
    /// A contact sensor of all collisions of the link, such as the switch below a foot.
    kSwitch,
    kWhisker,
    kMagnetometer,
    kNavSat,
    kAltimeter,
    kForceTorque,
    kOdometry,
    kBattery,
    /// The measurement of an ImageSensor.
    kImage,
  };
  Kind kind = Kind::kCamera;
  std::string name;
  int link = 0;
  robotlink::Pose3 poseInLink = robotlink::Pose3::Identity();
  /// In the unit of the reading; for cameras in gray values.
  SensorErrors errors;
  /// Distance, whiskers and ranges: m; accelerometers and gyroscopes: range of each axis, m/s^2 or rad/s, or
  /// kNoRange.
  double minimum = 0, maximum = 0;
  static constexpr double kNoRange = 1e6;
  /// Contact only: index in the link's collisions.
  int collision = 0;
  /// Force-torque only: index of the joint.
  int joint = 0;
  /// Force-torque only: what the child exerts on the parent, instead of the reverse.
  bool towardsParent = false;
  /// Camera only.
  int width = 0, height = 0;
  /// Camera only (rate also for range and image sensors): rad, and Hz.
  double horizontalAngle = 0, verticalAngle = 0, rate = 0;
  /// Camera only.
  LensVignetting vignetting;
  LensDistortion distortion;
  ShutterModel shutter;
  /// Sonar and laser only.
  RangeGeometry range;
  BatteryDescription battery;
  /// Image sensors only.
  ImageGeometry image;
};

/// Whether a sensor measures what is around it, and not what happens to its own body.
inline bool looksAround(SensorDescription::Kind kind) {
  using enum SensorDescription::Kind;
  return kind == kCamera || kind == kImage || kind == kDistance || kind == kSonar || kind == kLaser;
}

}  // namespace simcore
