// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SensorMarkers.h"

#include <algorithm>
#include <cmath>

#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"
#include "widgets/scene/MarkerShapes.h"
#include "widgets/scene/SceneObjects.h"
#include "widgets/scene/render/MeshBuilder.h"
#include "widgets/world/SceneState.h"

namespace widgets {
namespace {

using robotcontrol::WorldObject;
using robotlink::Pose3;
using robotlink::Vector3;

constexpr double kSightLength = 0.5;  // m
constexpr int kMaxRays = 4000;
constexpr MarkerColor kSightColor{250, 210, 60, 230}, kRayColor{250, 140, 40, 110},
    kHitColor{235, 50, 40, 255}, kFreeColor{120, 170, 120, 70}, kConeColor{60, 130, 240, 150},
    kSensorColor{60, 190, 200, 255};

void addSight(SceneShape& shape, double halfWidth, double halfHeight) {
  constexpr double kWidest = 1.5;  // rad; wider angles do not fit on a plane
  if (!(halfWidth > 0 && halfWidth < kWidest && halfHeight > 0 && halfHeight < kWidest)) return;
  const double y = kSightLength * std::tan(halfWidth), z = kSightLength * std::tan(halfHeight);
  const std::array<Vector3, 4> corners{Vector3(kSightLength, y, z), Vector3(kSightLength, -y, z),
                                       Vector3(kSightLength, -y, -z), Vector3(kSightLength, y, -z)};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    addMarkerLine(shape, Vector3::Zero(), corners[i], kSightColor);
    addMarkerLine(shape, corners[i], corners[(i + 1) % corners.size()], kSightColor);
  }
}

/// A ray with a point at its end if there it hits something.
void addRay(SceneShape& shape, double angle, double range, double maximum) {
  const Vector3 end(range * std::cos(angle), range * std::sin(angle), 0);
  const bool hits = !(maximum > 0) || range < 0.999 * maximum;
  addMarkerLine(shape, Vector3::Zero(), end, hits ? kRayColor : kFreeColor, 1);
  if (hits) addMarkerPoint(shape, end, kHitColor, 4);
}

void addCone(SceneShape& shape, double opening, double range, double maximum) {
  constexpr int kSides = 16;
  const double away = range * std::cos(opening / 2), radius = range * std::sin(opening / 2);
  const auto rim = [&](int side) {
    const double angle = 2 * robotlink::kPi * side / kSides;
    return Vector3(away, radius * std::cos(angle), radius * std::sin(angle));
  };
  for (int side = 0; side < kSides; ++side) {
    addMarkerLine(shape, rim(side), rim(side + 1), kConeColor, 1);
    if (side % 4 == 0) addMarkerLine(shape, Vector3::Zero(), rim(side), kConeColor, 1);
  }
  if (range < 0.999 * maximum) addMarkerPoint(shape, {range, 0, 0}, kHitColor, 5);
}

void addRanges(SceneShape& shape, const WorldObject& sensor, const std::vector<double>& values) {
  const double maximum = sensor.port().maximum();
  if (const auto opening = numberOf(sensor, "opening_angle")) {
    const double range = values.empty() ? maximum : values.front();
    return addCone(shape, std::clamp(*opening, 0.0, robotlink::kPi), range, maximum);
  }
  const double first = numberOf(sensor, "angles", 0).value_or(0),
               last = numberOf(sensor, "angles", 1).value_or(0);
  std::vector<double> ranges = values;
  // Unknown ranges are shown with their maximum.
  if (ranges.empty()) {
    const int count = sensor.port().shape_size() > 0 ? sensor.port().shape(0) : 1;
    ranges.assign(static_cast<std::size_t>(std::clamp(count, 1, kMaxRays)), maximum > 0 ? maximum : 1);
  }
  const std::size_t count = std::min<std::size_t>(ranges.size(), kMaxRays);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
    addRay(shape, first + share * (last - first), ranges[i], maximum);
  }
}

bool measuresRanges(const WorldObject& sensor) {
  return sensor.port().type() == "range" || sensor.port().type() == "distance";
}

/// Whether its marker shows its reading.
bool isReadForMarker(const WorldObject& sensor) {
  return measuresRanges(sensor) || sensor.port().type() == "contact";
}

}  // namespace

SceneShape sensorShape(const WorldObject& sensor, const std::vector<double>& values) {
  SceneShape shape;
  const auto width = numberOf(sensor, "opening_angles", 0), height = numberOf(sensor, "opening_angles", 1);
  if (width && height) {
    addSight(shape, *width / 2, *height / 2);
  } else if (measuresRanges(sensor)) {
    addRanges(shape, sensor, values);
  } else if (sensor.port().type() == "contact") {
    const bool touches = !values.empty() && values.front() > 0;
    MeshBuilder(shape.opaque)
        .sphere(Pose3::Identity(), Vector3::Constant(0.024), touches ? kHitColor : kSensorColor);
  } else {
    MeshBuilder(shape.opaque).box(Pose3::Identity(), Vector3::Constant(0.014), kSensorColor);
  }
  return shape;
}

std::vector<SceneBody> SensorMarkers::bodies(robotlink::Session& session, const SceneObjects& objects,
                                             const SceneState& scene, robotlink::Instant shown,
                                             const ObjectFilter& isShown) {
  std::vector<SceneBody> bodies;
  if (objects.all() == nullptr) return bodies;
  const auto* readings =
      session.store().latestAs<robotcontrol::PortReadings>(robotlink::streams::kPorts, shown);
  std::map<std::string, const robotcontrol::PortReading*> byPort;
  if (readings != nullptr)
    for (const auto& reading : readings->readings()) byPort.emplace(reading.port(), &reading);
  std::vector<std::string> wanted;
  for (const WorldObject& sensor : objects.all()->objects()) {
    if (!sensor.has_port() || sensor.port().is_actuator() || !sensor.has_pose_in_frame()) continue;
    const auto frame = scene.framePose(sensor.frame());
    if (!frame || !isShown(sensor.path())) continue;
    if (isReadForMarker(sensor) && wanted.size() < kMaxRead) wanted.push_back(sensor.port().path());
    const auto reading = byPort.find(sensor.port().path());
    std::vector<double> values;
    if (reading != byPort.end())
      values.assign(reading->second->values().begin(), reading->second->values().end());
    Marker& marker = markers_[sensor.path()];
    marker.used = true;
    if (!marker.shape || values != marker.values) {
      marker.shape = std::make_shared<const SceneShape>(sensorShape(sensor, values));
      marker.values = std::move(values);
    }
    bodies.push_back({marker.shape, Pose3(*frame * robotlink::pose3(sensor.pose_in_frame())), {}});
  }
  std::erase_if(markers_, [](const auto& entry) { return !entry.second.used; });
  for (auto& [path, marker] : markers_) marker.used = false;
  subscription_.want(session, wanted);
  return bodies;
}

}  // namespace widgets
