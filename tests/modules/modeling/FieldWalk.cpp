// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/modules/modeling/FieldWalk.h"

#include <cmath>
#include <stdexcept>

namespace modules {

using robotlink::Pose2;
using robotlink::Vector2;

namespace {

constexpr double kImage = 0.04;  // s

robotlink::FieldDescription readField() {
  auto field = robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml");
  if (!field) throw std::runtime_error(describe(field.error()));
  return *field;
}

}  // namespace

FieldWalk::FieldWalk(const Pose2& start, std::uint64_t seed)
    : field_(readField()), edges_(field_), random_(seed), pose_(start) {}

void FieldWalk::seeLandmarks(double pan) {
  const auto look = [&](const Vector2& position, bool isGoal) {
    const Vector2 place = pose_.inverse() * position;
    const double bearing = std::atan2(place.y(), place.x());
    if (std::abs(robotlink::normalizedAngle(bearing - pan)) > robotlink::radians(28)) return;
    landmarks_.push_back({position, bearing + 0.03 * random_.normal(),
                          place.norm() * (1 + 0.08 * random_.normal()), 0.8, isGoal});
  };
  for (const auto& beacon : field_.beacons) look(beacon.position, false);
  for (const auto& goal : field_.goals)
    look({goal.x + std::copysign(0.5 * field_.goalDepth, goal.x), 0}, true);
}

void FieldWalk::seeLines(double pan) {
  for (const FieldEdge& edge : edges_.edges()) {
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const Vector2 place = pose_.inverse() * Vector2(edge.start + share * (edge.end - edge.start));
      const double bearing = std::atan2(place.y(), place.x()), distance = place.norm();
      const double off = robotlink::normalizedAngle(bearing - pan);
      if (std::abs(off) > robotlink::radians(28) || distance > 1.5) continue;
      lines_.push_back(
          {place * (1 + 0.05 * random_.normal()), edge.direction() - pose_.heading + 0.1 * random_.normal()});
    }
  }
}

FieldMonteCarlo::Frame FieldWalk::step() {
  ++frame_;
  // A circle around the present place; dead reckoning is a tenth short.
  pose_ = pose_ * Pose2{0.004, 0, 0.012};
  odometry_ = odometry_ * Pose2{0.0036, 0, 0.011};
  const double pan = 1.2 * std::sin(2 * robotlink::kPi * frame_ * kImage / 3);
  landmarks_.clear();
  lines_.clear();
  if (showsLandmarks_) seeLandmarks(pan);
  if (showsLines_) seeLines(pan);
  FieldMonteCarlo::Frame frame;
  frame.time = frame_ * kImage;
  frame.robotInOdometry = odometry_;
  frame.landmarks = landmarks_;
  frame.lines = lines_;
  return frame;
}

double placeError(const PoseEstimate& estimate, const Pose2& truth) {
  return (estimate.robotInField.translation() - truth.translation()).norm();
}

double headingError(const PoseEstimate& estimate, const Pose2& truth) {
  return std::abs(robotlink::normalizedAngle(estimate.robotInField.heading - truth.heading));
}

}  // namespace modules
