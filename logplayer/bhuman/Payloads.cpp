// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bhuman/Payloads.h"

#include <cmath>

#include "robotlink/base/bytes/ByteReader.h"

namespace logplayer::bhuman {
namespace {

/// The value of a joint or a sensor that is off or missing.
constexpr double kOff = 1000;
/// The value of a joint that must not move.
constexpr double kIgnore = 2000;
constexpr double kGravity = 9.81;  // m/s^2

using robotlink::ByteReader;

/// B-Human's streams store a bool in four bytes.
bool takeBool(ByteReader& reader) {
  return reader.take<std::uint32_t>() != 0;
}

robotlink::Instant takeTime(ByteReader& reader) {
  return robotlink::Instant(std::chrono::milliseconds(reader.take<std::uint32_t>()));
}

struct Sensor {
  const char* name;
  const char* unit;
  double scale = 1;
};
/// In the order of SensorData. Gyroscopes and foot sensors have units of their own; ultrasound is in
/// millimeters.
constexpr std::array<Sensor, 18> kSensors = {{{"gyroX", ""},
                                              {"gyroY", ""},
                                              {"gyroZ", ""},
                                              {"accX", "m/s^2", kGravity},
                                              {"accY", "m/s^2", kGravity},
                                              {"accZ", "m/s^2", kGravity},
                                              {"batteryLevel", ""},
                                              {"footLeft/frontLeft", ""},
                                              {"footLeft/frontRight", ""},
                                              {"footLeft/backLeft", ""},
                                              {"footLeft/backRight", ""},
                                              {"footRight/frontLeft", ""},
                                              {"footRight/frontRight", ""},
                                              {"footRight/backLeft", ""},
                                              {"footRight/backRight", ""},
                                              {"ultrasound", "m", 0.001},
                                              {"angleX", "rad"},
                                              {"angleY", "rad"}}};
constexpr std::size_t kAccX = 3;

constexpr std::array<const char*, 5> kKeys = {"rightFootRight", "rightFootLeft", "leftFootRight",
                                              "leftFootLeft", "chest"};

bool isRotation(const Eigen::Matrix3d& matrix) {
  constexpr double kTolerance = 1e-3;
  return matrix.allFinite() &&
         (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).norm() < kTolerance &&
         matrix.determinant() > 0;
}

}  // namespace

std::optional<JointAngles> readJointData(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  JointAngles joints;
  for (auto& angle : joints.angles) {
    const double value = reader.take<double>();
    if (std::isfinite(value) && value != kOff && value != kIgnore) angle = value;
  }
  joints.time = takeTime(reader);
  if (!reader.complete()) return std::nullopt;
  return joints;
}

std::optional<SensorReadings> readSensorData(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  SensorReadings sensors;
  std::array<double, kSensors.size()> values{};
  for (std::size_t i = 0; i < kSensors.size(); ++i) {
    values[i] = static_cast<double>(reader.take<float>());
    if (std::isfinite(values[i]) && values[i] != kOff)
      sensors.readings.push_back({kSensors[i].name, values[i] * kSensors[i].scale, kSensors[i].unit});
  }
  const robotlink::Vector3 gravity(values[kAccX], values[kAccX + 1], values[kAccX + 2]);
  // These accelerometers measure the direction of gravity; at rest a body is accelerated in the opposite
  // direction.
  if (gravity.allFinite() && (gravity.array() != kOff).all()) sensors.acceleration = -kGravity * gravity;
  for (const std::string_view joint : kJointNames)
    sensors.readings.push_back(
        {"current/" + std::string(joint), static_cast<double>(reader.take<std::int16_t>()), ""});
  for (const std::string_view joint : kJointNames)
    sensors.readings.push_back(
        {"temperature/" + std::string(joint), static_cast<double>(reader.take<std::uint8_t>()), "degC"});
  sensors.readings.push_back({"ultrasoundMode", static_cast<double>(reader.take<std::int32_t>()), ""});
  sensors.time = takeTime(reader);
  if (!reader.complete()) return std::nullopt;
  return sensors;
}

std::optional<std::vector<Reading>> readKeyStates(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  std::vector<Reading> keys;
  keys.reserve(std::size(kKeys));
  for (const char* key : kKeys) keys.push_back({"key/" + std::string(key), takeBool(reader) ? 1.0 : 0.0, ""});
  if (!reader.complete()) return std::nullopt;
  return keys;
}

std::optional<robotlink::Pose2> readOdometryData(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  const double heading = reader.take<double>();
  const double xMm = reader.take<double>(), yMm = reader.take<double>();
  if (!reader.complete() || !std::isfinite(heading) || !std::isfinite(xMm) || !std::isfinite(yMm))
    return std::nullopt;
  return robotlink::Pose2{xMm / 1000, yMm / 1000, robotlink::normalizedAngle(heading)};
}

std::optional<CameraPlace> readCameraMatrix(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  Eigen::Matrix3d rotation;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) rotation(row, column) = reader.take<double>();
  robotlink::Vector3 translation;
  for (int i = 0; i < 3; ++i) translation[i] = reader.take<double>() / 1000;
  CameraPlace place;
  place.valid = takeBool(reader);
  if (!reader.complete() || !isRotation(rotation) || !translation.allFinite()) return std::nullopt;
  place.cameraInRobot.linear() = rotation;
  place.cameraInRobot.translation() = translation;
  return place;
}

std::optional<CameraOptics> readImageCoordinateSystem(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  // Skips the rotation from and to the horizon and its origin (all of which follow from the camera's pose),
  // and the motion since the last image, which serves a rolling shutter correction that is not done here.
  reader.take(14 * sizeof(double));
  CameraOptics optics;
  optics.width = reader.take<std::int32_t>();
  optics.height = reader.take<std::int32_t>();
  optics.horizontalAngle = reader.take<double>();
  optics.verticalAngle = reader.take<double>();
  reader.take(3 * sizeof(double));  // focal length and optical center, which are redundant
  const auto possible = [](double angle) { return angle > 0.01 && angle < 3.1; };
  const bool plausible = optics.width > 0 && optics.width <= 1 << 14 && optics.height > 0 &&
                         optics.height <= 1 << 14 && possible(optics.horizontalAngle) &&
                         possible(optics.verticalAngle);
  if (!reader.complete() || !plausible) return std::nullopt;
  return optics;
}

}  // namespace logplayer::bhuman
