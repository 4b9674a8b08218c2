// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/FieldUnits.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace widgets {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

/// Units by the full names of fields. For a field that is a message, the unit of all numbers in it that have
/// none of their own.
const std::map<std::string_view, const char*> kUnits{
    {"robotcontrol.Pose2.x", "m"},
    {"robotcontrol.Pose2.y", "m"},
    {"robotcontrol.Pose2.heading", "rad"},
    {"robotcontrol.Velocity2.x", "m/s"},
    {"robotcontrol.Velocity2.y", "m/s"},
    {"robotcontrol.Velocity2.rotation", "rad/s"},
    {"robotcontrol.BodySensors.acceleration", "m/s²"},
    {"robotcontrol.BodySensors.distance", "m"},
    {"robotcontrol.JointRequest.positions", "rad"},
    {"robotcontrol.CameraPose.camera_in_robot", "m"},
    {"robotcontrol.CameraPose.horizontal_angle", "rad"},
    {"robotcontrol.CameraPose.vertical_angle", "rad"},
    {"robotcontrol.CameraPose.width", "px"},
    {"robotcontrol.CameraPose.height", "px"},
    {"robotcontrol.OracleWorld.ball_in_field", "m"},
    {"robotcontrol.BehaviorState.seconds", "s"},
    {"robotcontrol.HeadMode.tilt", "rad"},
    {"robotcontrol.HeadMode.pan", "rad"},
    {"robotcontrol.HeadMode.roll", "rad"},
    {"robotcontrol.HeadMode.mouth", "rad"},
    {"robotcontrol.HeadRequest.tilt", "rad"},
    {"robotcontrol.HeadRequest.pan", "rad"},
    {"robotcontrol.HeadRequest.roll", "rad"},
    {"robotcontrol.HeadRequest.mouth", "rad"},
    {"robotcontrol.DriveState.left_speed", "m/s"},
    {"robotcontrol.DriveState.right_speed", "m/s"},
    {"robotcontrol.DriveState.battery", "V"},
    {"robotcontrol.DriveState.temperature", "°C"},
    {"robotcontrol.DriveState.compass", "rad"},
    {"robotcontrol.DriveState.rotation_rate", "rad/s"},
    {"robotcontrol.SonarReadings.Reading.range", "m"},
    {"robotcontrol.SonarReadings.opening_angle", "rad"},
    {"robotcontrol.SonarReadings.maximum", "m"},
    {"robotcontrol.DrivePath.points_in_field", "m"},
    {"robotcontrol.GroundMap.Line.x1", "m"},
    {"robotcontrol.GroundMap.Line.y1", "m"},
    {"robotcontrol.GroundMap.Line.x2", "m"},
    {"robotcontrol.GroundMap.Line.y2", "m"},
    {"robotcontrol.GroundMap.points", "m"},
    {"robotcontrol.LinkStatus.packets_per_second", "1/s"},
    {"robotcontrol.LinkStatus.bytes_per_second", "B/s"},
    {"robotcontrol.LinkStatus.skipped_bytes", "B"},
    {"robotcontrol.LinkStatus.round_trip", "s"},
    {"robotcontrol.LinkStatus.longest_gap", "s"},
    {"robotcontrol.LinkStatus.commands_per_second", "1/s"},
    {"robotcontrol.BallModel.position_in_robot", "m"},
    {"robotcontrol.BallModel.velocity_in_robot", "m/s"},
    {"robotcontrol.BallModel.seconds_since_seen", "s"},
    {"robotcontrol.BallModel.standard_deviation", "m"},
    {"robotcontrol.RobotPose.position_deviation", "m"},
    {"robotcontrol.RobotPose.heading_deviation", "rad"},
    {"robotcontrol.PlayersModel.Player.position_in_field", "m"},
    {"robotcontrol.ColorRegion.area", "px"},
    {"robotcontrol.ColorRegion.left", "px"},
    {"robotcontrol.ColorRegion.top", "px"},
    {"robotcontrol.ColorRegion.right", "px"},
    {"robotcontrol.ColorRegion.bottom", "px"},
    {"robotcontrol.ColorRegion.center_x", "px"},
    {"robotcontrol.ColorRegion.center_y", "px"},
    {"robotcontrol.ColorRegions.width", "px"},
    {"robotcontrol.ColorRegions.height", "px"},
    {"robotcontrol.BallPercept.center_in_image", "px"},
    {"robotcontrol.BallPercept.radius_in_image", "px"},
    {"robotcontrol.BallPercept.position_in_robot", "m"},
    {"robotcontrol.LandmarkPercept.bearing", "rad"},
    {"robotcontrol.LandmarkPercept.distance", "m"},
    {"robotcontrol.LandmarkPercept.left", "px"},
    {"robotcontrol.LandmarkPercept.top", "px"},
    {"robotcontrol.LandmarkPercept.right", "px"},
    {"robotcontrol.LandmarkPercept.bottom", "px"},
    {"robotcontrol.RobotPercept.position_in_robot", "m"},
    {"foxglove.JointState.position", "rad"},
    {"foxglove.JointState.velocity", "rad/s"},
    {"foxglove.JointState.acceleration", "rad/s²"},
    {"foxglove.JointState.effort", "N m"},
    {"foxglove.LaserScan.start_angle", "rad"},
    {"foxglove.LaserScan.end_angle", "rad"},
    {"foxglove.LaserScan.ranges", "m"},
    {"foxglove.Pose.position", "m"},
    {"foxglove.Pose.orientation", ""},
    {"foxglove.FrameTransform.translation", "m"},
    {"foxglove.FrameTransform.rotation", ""},
    {"google.protobuf.Timestamp", "s"},
    {"google.protobuf.Duration", "s"}};

/// Returns "joints" for "joints[head.pan].position" and removes it, its index and the dot from the path.
std::string_view nextName(std::string_view& path) {
  const std::size_t end = std::min(path.find_first_of(".["), path.size());
  const std::string_view name = path.substr(0, end);
  path.remove_prefix(end);
  if (path.starts_with('[')) path.remove_prefix(std::min(path.find(']') + 1, path.size()));
  if (path.starts_with('.')) path.remove_prefix(1);
  return name;
}

}  // namespace

QString unitOf(const std::string& type, const std::string& field) {
  const Descriptor* message = google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(type);
  std::string_view path = field;
  const char* unit = "";
  while (message != nullptr && !path.empty()) {
    const FieldDescriptor* next = message->FindFieldByName(std::string(nextName(path)));
    if (next == nullptr) return {};
    message = next->message_type();
    const auto known = kUnits.find(next->full_name());
    if (known != kUnits.end()) unit = known->second;
    const auto ofType = message != nullptr ? kUnits.find(message->full_name()) : kUnits.end();
    if (ofType != kUnits.end()) unit = ofType->second;
  }
  return QString::fromUtf8(unit);
}

}  // namespace widgets
