// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/RobotDescription.h"

#include <algorithm>

#include "robotlink/base/Geometry.h"
#include "robotlink/config/RobotUseReader.h"
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
  joint.mirror = node.optional<std::string>("mirror", joint.name);
  joint.mirrorIsNegated = joint.mirror.starts_with('-');
  if (joint.mirrorIsNegated) joint.mirror.erase(0, 1);
  return joint;
}

Pose2 readPose(const YamlNode& node, std::string_view key) {
  const std::vector<double> numbers = node.numbers(key, 3);
  if (numbers.size() != 3) return {};
  return {numbers[0], numbers[1], radians(numbers[2])};
}

RobotDescription::Drive readDrive(const YamlNode& node) {
  RobotDescription::Drive drive;
  drive.length = node.numberIn("length", 0.01, 10);
  drive.width = node.numberIn("width", 0.01, 10);
  drive.radius = node.numberIn("radius", 0.01, 10);
  drive.wheelRadius = node.numberIn("wheel_radius", 0.001, 1);
  drive.track = node.numberIn("track", 0.01, 10);
  drive.maximumSpeed = node.numberIn("max_speed", 0.01, 100);
  drive.maximumRotation = radians(node.numberIn("max_rotation_deg", 1, 3600));
  drive.acceleration = node.numberIn("acceleration", 0.01, 100);
  drive.rotationAcceleration = radians(node.numberIn("rotation_acceleration_deg", 1, 36000));
  return drive;
}

RobotDescription::Sonars readSonars(const YamlNode& node) {
  RobotDescription::Sonars sonars;
  sonars.openingAngle = radians(node.numberIn("opening_deg", 0, 180));
  sonars.maximum = node.numberIn("max", 0.01, 1000);
  for (const YamlNode& sensor : node.child("sensors").items())
    sonars.sensors.push_back({readPose(sensor, "pose")});
  return sonars;
}

RobotDescription::Laser readLaser(const YamlNode& node) {
  RobotDescription::Laser laser;
  laser.inRobot = readPose(node, "pose");
  laser.startAngle = radians(node.numberIn("start_deg", -360, 360));
  laser.endAngle = radians(node.numberIn("end_deg", -360, 360));
  laser.readings = node.wholeNumberIn("readings", 2, 10000);
  laser.maximum = node.numberIn("max", 0.01, 1000);
  if (laser.endAngle <= laser.startAngle) node.fail("robot.laser", "end_deg must be above start_deg");
  return laser;
}

RobotDescription::Camera readCamera(const YamlNode& node) {
  RobotDescription::Camera camera;
  const auto position = node.required<std::vector<double>>("position");
  if (position.size() != 3) node.fail("robot.camera", "position must be [x, y, z]");
  const double tilt = radians(node.numberIn("tilt_deg", -90, 90));
  if (position.size() == 3)
    camera.inRobot = Eigen::Translation3d(position[0], position[1], position[2]) *
                     Eigen::AngleAxisd(tilt, Vector3::UnitY());
  camera.horizontalAngle = radians(node.numberIn("horizontal_angle_deg", 1, 179));
  return camera;
}

RobotDescription::Battery readBattery(const YamlNode& node) {
  RobotDescription::Battery battery;
  battery.empty = node.numberIn("empty", 0, 1000);
  battery.low = node.numberIn("low", 0, 1000);
  battery.full = node.numberIn("full", 0, 1000);
  if (battery.low < battery.empty || battery.full <= battery.low)
    node.fail("robot.battery", "empty, low and full must be voltages in that order");
  return battery;
}

}  // namespace

int RobotDescription::jointIndex(const std::string& joint) const {
  const auto found =
      std::find_if(joints.begin(), joints.end(), [&](const Joint& j) { return j.name == joint; });
  return found == joints.end() ? -1 : static_cast<int>(found - joints.begin());
}

namespace {

tl::expected<RobotDescription, Errors> read(Result<YamlReader> reader) {
  if (!reader) return tl::unexpected(Errors{reader.error()});
  const YamlNode root = reader->root();
  RobotDescription robot;
  robot.name = root.required<std::string>("name");
  robot.title = root.required<std::string>("title");
  robot.layout = root.optional<std::string>("layout", robot.layout);
  for (const YamlNode& node : root.optionalChild("joints").items()) {
    RobotDescription::Joint joint = readJoint(node);
    if (robot.jointIndex(joint.name) >= 0) {
      node.fail("robot.joint-twice", "joint " + joint.name + " is listed twice", {joint.name});
    }
    robot.joints.push_back(std::move(joint));
  }
  for (const auto& joint : robot.joints) {
    if (robot.jointIndex(joint.mirror) < 0)
      root.fail("robot.mirror",
                "joint " + joint.name + " is mirrored by " + joint.mirror + ", which is no joint",
                {joint.name, joint.mirror});
  }
  if (const YamlNode drive = root.optionalChild("drive"); !drive.empty()) robot.drive = readDrive(drive);
  if (const YamlNode sonars = root.optionalChild("sonars"); !sonars.empty())
    robot.sonars = readSonars(sonars);
  if (const YamlNode laser = root.optionalChild("laser"); !laser.empty()) robot.laser = readLaser(laser);
  if (const YamlNode camera = root.optionalChild("camera"); !camera.empty())
    robot.camera = readCamera(camera);
  if (const YamlNode battery = root.optionalChild("battery"); !battery.empty())
    robot.battery = readBattery(battery);
  readRobotUse(root);  // The keys of RobotUse belong to the same file.
  if (robot.joints.empty() && !robot.drive && !robot.camera)
    root.fail("robot.moves", "a robot needs joints, a drive or a camera");
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

tl::expected<RobotDescription, Errors> parseRobotDescription(const std::string& text,
                                                             const std::string& file) {
  return read(YamlReader::parse(text, file));
}

}  // namespace robotlink
