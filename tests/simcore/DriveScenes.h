// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "robotlink/base/Geometry.h"
#include "simcore/Simulation.h"

namespace simcore {

/// The name of the first Pioneer.
inline constexpr const char* kRobot = "p3at1";

/// A Pioneer that stands somewhere, for a world's text.
std::string pioneerAt(const std::string& name, double x, double y, double heading = 0);
/// The SDF of a static box, and of a wall of many boxes.
std::string boxAt(const std::string& name, const robotlink::Vector3& center, const robotlink::Vector3& size,
                  double pitch = 0);

/// A wall across the way of a robot at the origin, its face at x = 1.45.
std::string wallAhead();
std::string piecesAt(double x, double y0, double y1, int count);

/// A world with a floor, `contents`, and the shipped models.
std::shared_ptr<const Scene> floorWith(const std::string& contents);

/// A simulation of such a world with functions for driving.
class DrivenWorld {
 public:
  explicit DrivenWorld(const std::string& contents, SimulationOptions options = {.seed = 1, .noise = false});
  Simulation* operator->() { return simulation_.get(); }
  /// Drives the wheels at these rim speeds (m/s) for a time, with at most 0.3 m/s^2, as the robot's firmware
  /// does.
  void drive(double left, double right, double seconds, std::size_t robot = 0);
  /// The same without a ramp.
  void jerk(double left, double right, double seconds, std::size_t robot = 0);
  robotlink::Pose2 pose(const std::string& robot = kRobot);
  double reading(const std::string& path, std::size_t axis = 0);

 private:
  std::unique_ptr<Simulation> simulation_;
  double left_ = 0, right_ = 0;
};

}  // namespace simcore
