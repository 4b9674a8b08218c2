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

// What the payloads of 2009 hold, in SI units. The readers yield nothing where a payload has another size
// than that of 2009. Layouts and where they come from: MESSAGE_QUEUES.md.

constexpr std::size_t kJointCount = 22;

/// The NAO's joints in the order of all its lists.
constexpr std::array<std::string_view, kJointCount> kJointNames = {
    "headPan",   "headTilt",  "armLeft0",  "armLeft1",  "armLeft2",  "armLeft3", "armRight0", "armRight1",
    "armRight2", "armRight3", "legLeft0",  "legLeft1",  "legLeft2",  "legLeft3", "legLeft4",  "legLeft5",
    "legRight0", "legRight1", "legRight2", "legRight3", "legRight4", "legRight5"};

struct CameraImage {
  robotlink::Instant time;
  robotlink::Image image;  ///< kYuyv
  std::string damage;      ///< of its JPEG; empty if it is whole
};
/// Read the messages Image and JPEGImage. They fail where no image can be read; take memory only for up to 4
/// megapixels.
robotlink::Result<CameraImage> readImage(std::span<const std::uint8_t> payload);
robotlink::Result<CameraImage> readJpegImage(std::span<const std::uint8_t> payload);

struct JointAngles {
  std::array<std::optional<double>, kJointCount> angles;  ///< rad; nothing for a joint that is off
  robotlink::Instant time;
};
std::optional<JointAngles> readJointData(std::span<const std::uint8_t> payload);

/// A value that a sensor told; sensors that are missing or off have none.
struct Reading {
  std::string name;  ///< "gyroX", "temperature/headPan"
  double value = 0;
  std::string unit;
};
struct SensorReadings {
  std::vector<Reading> readings;
  std::optional<robotlink::Vector3> acceleration;  ///< m/s^2, as BodySensors has it
  robotlink::Instant time;
};
std::optional<SensorReadings> readSensorData(std::span<const std::uint8_t> payload);
/// 1 for a key that is pressed.
std::optional<std::vector<Reading>> readKeyStates(std::span<const std::uint8_t> payload);

std::optional<robotlink::Pose2> readOdometryData(std::span<const std::uint8_t> payload);

struct CameraPlace {
  robotlink::Pose3 cameraInRobot = robotlink::Pose3::Identity();
  bool valid = true;  ///< the robot moved steadily enough for it to be relied on
};
/// Nothing also where its rotation is none.
std::optional<CameraPlace> readCameraMatrix(std::span<const std::uint8_t> payload);

struct CameraOptics {
  int width = 320;  ///< pixels
  int height = 240;
  double horizontalAngle = 0.78674;  ///< rad, whole opening angles; the NAO's of 2009, as the logs tell them
  double verticalAngle = 0.60349;
};
std::optional<CameraOptics> readImageCoordinateSystem(std::span<const std::uint8_t> payload);

}  // namespace logplayer::bhuman
