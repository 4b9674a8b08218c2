// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/localization/LandmarkMemory.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Pose2;
using robotlink::Vector2;

void LandmarkMemory::add(double time, const Pose2& robotInOdometry, std::span<const LandmarkMeasurement> seen,
                         double memory) {
  std::erase_if(sightings_, [&](const Sighting& sighting) { return time - sighting.time > memory; });
  for (const LandmarkMeasurement& landmark : seen) {
    const Vector2 inRobot(landmark.distance * std::cos(landmark.bearing),
                          landmark.distance * std::sin(landmark.bearing));
    const Sighting now{landmark.position, robotInOdometry * inRobot, time, landmark.isGoal};
    const auto known = std::ranges::find(sightings_, landmark.position, &Sighting::position);
    if (known == sightings_.end())
      sightings_.push_back(now);
    else
      *known = now;
  }
}

Pose2 LandmarkMemory::poseFrom(const Vector2& first, const Vector2& firstInRobot, const Vector2& second,
                               const Vector2& secondInRobot) {
  const Vector2 apart = second - first, apartInRobot = secondInRobot - firstInRobot;
  const double heading = robotlink::normalizedAngle(std::atan2(apart.y(), apart.x()) -
                                                    std::atan2(apartInRobot.y(), apartInRobot.x()));
  const Vector2 center = 0.5 * (first + second);
  const Vector2 turned = Pose2{0, 0, heading} * Vector2(0.5 * (firstInRobot + secondInRobot));
  return {center.x() - turned.x(), center.y() - turned.y(), heading};
}

}  // namespace modules
