// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "modules/driving/DynamicWindow.h"
#include "modules/driving/RangeMemory.h"
#include "modules/driving/SpeedLimiter.h"
#include "modules/driving/VectorField.h"
#include "tests/modules/driving/RollingRobot.h"

namespace modules {

enum class Avoidance { kVectorField, kDynamicWindow };

/// A RollingRobot that remembers obstacles and avoids them, like the solutions of its program.
class Ride {
 public:
  Ride(const FlatWorld& world, const RollingRobot::Options& options, Avoidance avoidance);

  /// Returns the desired velocity, given the obstacles in the robot's frame.
  using Desired = std::function<DriveVelocity(std::span<const robotlink::Vector2>)>;
  void run(double seconds, const Desired& desired);
  /// Runs until `done` returns true; returns false if it does not within `seconds`.
  bool runUntil(double seconds, const Desired& desired, const std::function<bool()>& done);

  RollingRobot& robot() { return robot_; }
  const DriveVelocity& request() const { return request_; }

 private:
  void cycle(const Desired& desired);

  RollingRobot robot_;
  Avoidance avoidance_;
  OdometryHistory odometry_;
  RangeMemory memory_{{}};
  VectorField vectorField_;
  DynamicWindow dynamicWindow_;
  SpeedLimiter limiter_;
  DriveVelocity request_;
};

}  // namespace modules
