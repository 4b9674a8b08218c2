// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SensorShapes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/StreamStore.h"
#include "widgets/drive/RadarReadings.h"
#include "widgets/scene/render/MeshBuilder.h"

namespace widgets {
namespace {

using robotlink::Pose3;
using robotlink::Vector3;

constexpr double kPyramidLength = 0.5;  // m
/// Sonars and lasers measure in a plane; their packages do not say how high it is.
constexpr double kRangeHeight = 0.25;  // m
constexpr robotlink::Duration kEchoMemory = std::chrono::seconds(1);
constexpr std::array<std::uint8_t, 4> kCameraColor{250, 210, 60, 230}, kDistanceColor{230, 60, 60, 230},
    kSonarColor{60, 130, 240, 150}, kLaserColor{250, 140, 40, 130};

/// The pose of a camera, and half of its fields of view.
struct CameraSight {
  Pose3 inRobot;
  double halfWidth = 0, halfHeight = 0;
};

std::optional<CameraSight> sightOf(const robotlink::StreamStore& store, const std::string& robot,
                                   const robotlink::RobotDescription* description, robotlink::Instant shown) {
  const auto* pose =
      store.latestAs<robotcontrol::CameraPose>(robot + '/' + robotlink::kCameraPose.name, shown);
  if (pose != nullptr)
    return CameraSight{robotlink::pose3(pose->camera_in_robot()), pose->horizontal_angle() / 2,
                       pose->vertical_angle() / 2};
  if (description == nullptr || !description->camera) return std::nullopt;
  // Images are four to three unless a camera says otherwise.
  const double half = description->camera->horizontalAngle / 2;
  return CameraSight{description->camera->inRobot, half, std::atan(0.75 * std::tan(half))};
}

void add(SceneLines& lines, const Vector3& from, const Vector3& to,
         const std::array<std::uint8_t, 4>& color) {
  if (from.allFinite() && to.allFinite()) lines.segments.push_back({packed(from), packed(to), color, 1.5F});
}

void addPyramid(SceneLines& lines, const CameraSight& sight) {
  if (!(sight.halfWidth > 0 && sight.halfWidth < 1.5 && sight.halfHeight > 0 && sight.halfHeight < 1.5))
    return;
  const double y = kPyramidLength * std::tan(sight.halfWidth),
               z = kPyramidLength * std::tan(sight.halfHeight);
  const Vector3 apex = sight.inRobot.translation();
  const std::array<Vector3, 4> corners{
      sight.inRobot * Vector3(kPyramidLength, y, z), sight.inRobot * Vector3(kPyramidLength, -y, z),
      sight.inRobot * Vector3(kPyramidLength, -y, -z), sight.inRobot * Vector3(kPyramidLength, y, -z)};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    add(lines, apex, corners[i], kCameraColor);
    add(lines, corners[i], corners[(i + 1) % corners.size()], kCameraColor);
  }
}

Vector3 raised(const robotlink::Vector2& place) {
  return {place.x(), place.y(), kRangeHeight};
}

}  // namespace

SceneLines sensorLines(const robotlink::StreamStore& store, const std::string& robot,
                       const robotlink::RobotDescription* description, robotlink::Instant shown) {
  SceneLines lines;
  const auto sight = sightOf(store, robot, description, shown);
  if (sight) addPyramid(lines, *sight);
  // The distance sensor of a legged robot is next to its camera.
  const auto* body =
      store.latestAs<robotcontrol::BodySensors>(robot + '/' + robotlink::kBodySensors.name, shown);
  if (sight && body != nullptr && body->distance() > 0)
    add(lines, sight->inRobot.translation(), sight->inRobot * Vector3(body->distance(), 0, 0),
        kDistanceColor);
  const RadarReadings readings = radarReadings(store, robot, description, shown, kEchoMemory);
  for (const RadarReadings::Echo& echo : readings.echoes) {
    if (echo.newest && !echo.nothing)
      add(lines, raised(echo.sensorInRobot.translation()),
          raised(echo.sensorInRobot * robotlink::Vector2(echo.range, 0)), kSonarColor);
  }
  for (const auto& hit : readings.laser) add(lines, raised(readings.laserInRobot), raised(hit), kLaserColor);
  return lines;
}

bool areSame(const SceneLines& a, const SceneLines& b) {
  return std::ranges::equal(a.segments, b.segments, [](const auto& one, const auto& other) {
    return one.from == other.from && one.to == other.to && one.color == other.color &&
           one.width == other.width;
  });
}

}  // namespace widgets
