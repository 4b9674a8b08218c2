// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {

/// A kind of robot as resources/robots/<name>.yaml describes it: what robot programs and the workbench need
/// to know. Everything is in the frame of the robot: x to the front, y to the left, meters and radians. A
/// plain value.
struct RobotDescription {
  /// A joint that the program commands.
  struct Joint {
    std::string name;
    /// Lower software limit, rad.
    double minimum = 0;
    /// Upper software limit, rad.
    double maximum = 0;
    double maximumSpeed = 0;  ///< rad/s
    /// The angle of the joint when the robot stands, rad.
    double stance = 0;
    /// The joint that moves like this one when a motion is mirrored at the robot's plane of symmetry: that of
    /// the other side, or this one; its angle has the other sign there if `mirrorIsNegated`.
    std::string mirror = {};
    bool mirrorIsNegated = false;
  };
  /// A differential drive: one or more wheels on each side, and the body around them.
  struct Drive {
    /// Size of the body, m; its center is the origin.
    double length = 0, width = 0;
    /// Radius of the circle around the robot that must stay free of obstacles, m.
    double radius = 0;
    double wheelRadius = 0;  ///< m
    /// The effective distance between the two sides, m: the robot turns by (right - left) / track. For skid
    /// steering it is larger than the distance between the wheels.
    double track = 0;
    /// m/s and rad/s.
    double maximumSpeed = 0, maximumRotation = 0;
    /// m/s^2 and rad/s^2.
    double acceleration = 0, rotationAcceleration = 0;
  };
  /// A single ultrasonic sensor.
  struct Sonar {
    /// The pose of the sonar, which measures along its x-axis.
    Pose2 inRobot;
  };
  /// The ring of sonars.
  struct Sonars {
    /// Ordered by their numbers in packages.
    std::vector<Sonar> sensors;
    /// The full field of view of a sonar's cone, rad.
    double openingAngle = 0;
    /// The range of the sensors, m.
    double maximum = 0;
  };
  /// A laser range finder that scans a plane.
  struct Laser {
    Pose2 inRobot;
    /// The angles of the first and the last reading, rad, counterclockwise in its own frame.
    double startAngle = 0, endAngle = 0;
    int readings = 0;
    /// The range, m.
    double maximum = 0;
  };
  /// A camera that is fixed to the robot, or a camera on a tripod that is all there is.
  struct Camera {
    /// The camera's frame: x along the optical axis, y left, z up. The robot's origin is on the ground.
    Pose3 inRobot = Pose3::Identity();
    /// The whole field of view across the image's width, rad. Pixels are square.
    double horizontalAngle = 0;
  };
  /// The thresholds of the battery's voltage, V.
  struct Battery {
    /// At this voltage the robot switches itself off.
    double empty = 0;
    /// Below this voltage it should be charged soon.
    double low = 0;
    double full = 0;
    bool operator==(const Battery&) const = default;
  };
  /// The identifier in scenes and packages: "ers210".
  std::string name;
  /// The name that users see: "Sony Aibo ERS-210".
  std::string title;
  /// The shipped process layout that the robot's program uses unless another one is chosen.
  std::string layout = "compact";
  /// In the order of JointRequest.positions.
  std::vector<Joint> joints;
  /// Packages that its platforms send, including the simulated platform's oracle.
  std::vector<std::string> offers;
  /// The packages of `offers` that only a simulated robot publishes, such as the oracle.
  std::vector<std::string> simulatedOnly;
  /// Only of robots on wheels.
  std::optional<Drive> drive;
  std::optional<Sonars> sonars;
  std::optional<Laser> laser;
  /// Only where the camera does not move with joints.
  std::optional<Camera> camera;
  /// Only of robots that report the voltage of their battery.
  std::optional<Battery> battery;
  /// Packages that its platforms receive.
  std::vector<std::string> takes;

  /// -1 if there is no such joint.
  int jointIndex(const std::string& joint) const;
};

/// Reads a description; all problems are reported, each with its line.
tl::expected<RobotDescription, Errors> readRobotDescription(const std::filesystem::path& file);
/// Reads the text of a description; `file` is the name that errors carry.
tl::expected<RobotDescription, Errors> parseRobotDescription(const std::string& text,
                                                             const std::string& file);

}  // namespace robotlink
