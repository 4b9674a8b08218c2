// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/modeling/LandmarkLocalizer.h"

namespace modules {

/// Landmarks that were seen lately, at their places by dead reckoning, so that two of them determine the
/// robot's pose although they were not in the same image. A plain value; not thread-safe.
class LandmarkMemory {
 public:
  struct Sighting {
    /// In the field, m.
    robotlink::Vector2 position = robotlink::Vector2::Zero();
    /// In the frame of dead reckoning, m.
    robotlink::Vector2 inOdometry = robotlink::Vector2::Zero();
    /// The time at which it was seen, s.
    double time = 0;
    bool isGoal = false;
  };

  /// Adds what an image shows, and forgets what is older than `memory`, s. A landmark that is seen again
  /// takes the place of its former sighting.
  void add(double time, const robotlink::Pose2& robotInOdometry, std::span<const LandmarkMeasurement> seen,
           double memory);
  const std::vector<Sighting>& sightings() const { return sightings_; }
  void clear() { sightings_.clear(); }

  /// The pose in the field from which two landmarks appear at these places of the robot's frame: the
  /// direction between them determines the heading, their center the position.
  static robotlink::Pose2 poseFrom(const robotlink::Vector2& first, const robotlink::Vector2& firstInRobot,
                                   const robotlink::Vector2& second, const robotlink::Vector2& secondInRobot);

 private:
  std::vector<Sighting> sightings_;
};

}  // namespace modules
