// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"

namespace logplayer::bhuman {

// The contents of the payloads of 2009, in SI units. The functions return an empty value if a payload does
// not have the size of 2009. Layouts and their sources: MESSAGE_QUEUES.md.

/// Number of joints of the NAO.
constexpr std::size_t kJointCount = 22;

/// The NAO's joints, in the order of all lists in the payloads.
constexpr std::array<std::string_view, kJointCount> kJointNames = {
    "headPan",   "headTilt",  "armLeft0",  "armLeft1",  "armLeft2",  "armLeft3", "armRight0", "armRight1",
    "armRight2", "armRight3", "legLeft0",  "legLeft1",  "legLeft2",  "legLeft3", "legLeft4",  "legLeft5",
    "legRight0", "legRight1", "legRight2", "legRight3", "legRight4", "legRight5"};

/// An image with the time at which it was taken.
struct CameraImage {
  robotlink::Instant time;
  /// In the format kYuyv.
  robotlink::Image image;
  /// Damage of its JPEG; empty if it is intact.
  std::string damage;
};
/// Read the messages Image and JPEGImage. They fail where no image can be read; take memory only for up to 4
/// megapixels.
robotlink::Result<CameraImage> readImage(std::span<const std::uint8_t> payload);
robotlink::Result<CameraImage> readJpegImage(std::span<const std::uint8_t> payload);

/// Measured angles of all joints.
struct JointAngles {
  std::array<std::optional<double>, kJointCount> angles;  ///< rad; empty for a joint that is off
  robotlink::Instant time;
};
std::optional<JointAngles> readJointData(std::span<const std::uint8_t> payload);

/// A sensor's value; sensors that are missing or off have no entry.
struct Reading {
  /// The name of the sensor, such as "gyroX", "temperature/headPan".
  std::string name;
  double value = 0;
  /// The unit of `value`, for display.
  std::string unit;
};
/// All sensor values of one payload.
struct SensorReadings {
  std::vector<Reading> readings;
  std::optional<robotlink::Vector3> acceleration;  ///< m/s^2, in the frame of BodySensors
  robotlink::Instant time;
};
std::optional<SensorReadings> readSensorData(std::span<const std::uint8_t> payload);
/// The value of a pressed key is 1.
std::optional<std::vector<Reading>> readKeyStates(std::span<const std::uint8_t> payload);

/// The accumulated odometry, in m and rad.
std::optional<robotlink::Pose2> readOdometryData(std::span<const std::uint8_t> payload);

/// The pose of the camera as computed by the robot's program.
struct CameraPlace {
  robotlink::Pose3 cameraInRobot = robotlink::Pose3::Identity();
  /// Whether the robot moved steadily enough for the pose to be reliable.
  bool valid = true;
};
/// Returns an empty value also if the rotation matrix is invalid.
std::optional<CameraPlace> readCameraMatrix(std::span<const std::uint8_t> payload);

/// Image size and fields of view. The defaults are those of the NAO in logs of 2009.
struct CameraOptics {
  int width = 320;  ///< pixels
  int height = 240;
  /// Full fields of view, in rad.
  double horizontalAngle = 0.78674;
  double verticalAngle = 0.60349;
};
std::optional<CameraOptics> readImageCoordinateSystem(std::span<const std::uint8_t> payload);

}  // namespace logplayer::bhuman
