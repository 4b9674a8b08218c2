// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

/// What resources/robots/<name>.yaml says of a kind of robot that programs and the workbench need to know. A plain value.
struct RobotDescription {
  struct Joint {
    std::string name;
    double minimum = 0;  ///< rad, the software limit
    double maximum = 0;
    double maximumSpeed = 0;  ///< rad/s
    double stance = 0;  ///< rad, where it is when the robot stands
  };
  std::string name;   ///< "ers210"
  std::string title;  ///< "Sony Aibo ERS-210"
  std::vector<Joint> joints;  ///< in the order of JointRequest.positions
  std::vector<std::string> offers;  ///< packages that its platforms send, the simulated one's oracle among them
  std::vector<std::string> simulatedOnly;  ///< those of `offers` that only a simulator has
  std::vector<std::string> takes;  ///< packages that its platforms receive

  int jointIndex(const std::string& joint) const;  ///< -1 if there is none
};

tl::expected<RobotDescription, Errors> readRobotDescription(const std::filesystem::path& file);
/// `file` is the name that errors carry.
tl::expected<RobotDescription, Errors> parseRobotDescription(const std::string& text, const std::string& file);

}  // namespace robotlink
