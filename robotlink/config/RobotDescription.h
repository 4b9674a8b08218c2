// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {

/// What resources/robots/<name>.yaml says of a kind of robot that programs and the workbench need to know. A
/// plain value.
struct RobotDescription {
  struct Joint {
    std::string name;
    double minimum = 0;  ///< rad, the software limit
    double maximum = 0;
    double maximumSpeed = 0;  ///< rad/s
    double stance = 0;        ///< rad, where it is when the robot stands
  };
  /// Wheels on two sides.
  struct Drive {
    double length = 0, width = 0;  ///< m, of the body, its centre in the middle
    double radius = 0;             ///< m, of the circle about the robot that nothing may come into
    double wheelRadius = 0;        ///< m
    double track =
        0;  ///< m, what turns by (right - left) / track; of skid steering more than between the wheels
    double maximumSpeed = 0, maximumRotation = 0;       ///< m/s, rad/s
    double acceleration = 0, rotationAcceleration = 0;  ///< m/s^2, rad/s^2
  };
  struct Sonar {
    Pose2 inRobot;  ///< it measures along its x-axis
  };
  struct Sonars {
    std::vector<Sonar> sensors;  ///< by their numbers
    double openingAngle = 0;     ///< rad, of the whole cone
    double maximum = 0;          ///< m
  };
  struct Laser {
    Pose2 inRobot;
    double startAngle = 0, endAngle = 0;  ///< rad, of the first and the last reading, counter-clockwise
    int readings = 0;
    double maximum = 0;  ///< m
  };
  std::string name;   ///< "ers210"
  std::string title;  ///< "Sony Aibo ERS-210"
  std::string layout =
      "compact";  ///< name of the shipped process layout that its program has unless another one is chosen
  std::vector<Joint> joints;  ///< in the order of JointRequest.positions
  std::vector<std::string>
      offers;  ///< packages that its platforms send, the simulated one's oracle among them
  std::vector<std::string> simulatedOnly;  ///< those of `offers` that only a simulator has
  std::optional<Drive> drive;              ///< robots on wheels
  std::optional<Sonars> sonars;
  std::optional<Laser> laser;
  std::vector<std::string> takes;  ///< packages that its platforms receive

  int jointIndex(const std::string& joint) const;  ///< -1 if there is none
};

tl::expected<RobotDescription, Errors> readRobotDescription(const std::filesystem::path& file);
/// `file` is the name that errors carry.
tl::expected<RobotDescription, Errors> parseRobotDescription(const std::string& text,
                                                             const std::string& file);

}  // namespace robotlink
