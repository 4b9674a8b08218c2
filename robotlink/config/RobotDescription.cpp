// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/RobotDescription.h"

#include <algorithm>

#include "robotlink/base/Geometry.h"
#include "robotlink/config/YamlReader.h"

namespace robotlink {
namespace {

RobotDescription::Joint readJoint(const YamlNode& node) {
  RobotDescription::Joint joint;
  joint.name = node.required<std::string>("name");
  const std::vector<double> limits = node.numbers("limits_deg", 2);
  if (limits.size() == 2) {
    joint.minimum = radians(limits[0]);
    joint.maximum = radians(limits[1]);
    if (limits[0] >= limits[1]) node.fail("robot.limits", "the lower limit must be below the upper one");
  }
  joint.maximumSpeed = node.numberIn("max_speed", 0, 100);
  joint.stance = radians(node.optional("stance_deg", 0.0));
  if (joint.stance < joint.minimum || joint.stance > joint.maximum) {
    node.fail("robot.stance", "the stance is outside the limits of joint " + joint.name, {joint.name});
  }
  return joint;
}

}  // namespace

int RobotDescription::jointIndex(const std::string& joint) const {
  const auto found = std::find_if(joints.begin(), joints.end(), [&](const Joint& j) { return j.name == joint; });
  return found == joints.end() ? -1 : static_cast<int>(found - joints.begin());
}

namespace {

tl::expected<RobotDescription, Errors> read(Result<YamlReader> reader) {
  if (!reader) return tl::unexpected(Errors{reader.error()});
  const YamlNode root = reader->root();
  RobotDescription robot;
  robot.name = root.required<std::string>("name");
  robot.title = root.required<std::string>("title");
  for (const YamlNode& node : root.child("joints").items()) {
    RobotDescription::Joint joint = readJoint(node);
    if (robot.jointIndex(joint.name) >= 0) {
      node.fail("robot.joint-twice", "joint " + joint.name + " is listed twice", {joint.name});
    }
    robot.joints.push_back(std::move(joint));
  }
  const YamlNode platform = root.child("platform");
  robot.offers = platform.required<std::vector<std::string>>("offers");
  robot.simulatedOnly = platform.optional<std::vector<std::string>>("simulated_only", {});
  robot.takes = platform.required<std::vector<std::string>>("takes");
  if (auto finished = reader->finish(); !finished) return tl::unexpected(finished.error());
  return robot;
}

}  // namespace

tl::expected<RobotDescription, Errors> readRobotDescription(const std::filesystem::path& file) {
  return read(YamlReader::load(file));
}

tl::expected<RobotDescription, Errors> parseRobotDescription(const std::string& text, const std::string& file) {
  return read(YamlReader::parse(text, file));
}

}  // namespace robotlink
