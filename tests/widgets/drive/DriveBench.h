// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Ranging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/Bench.h"

namespace widgets::test {

/// A bench with two Pioneers, "p3at1" (selected) and "p3at2", whose streams the test publishes.
struct DriveBench : Bench {
  DriveBench() : Bench({.robots = {"p3at1", "p3at2"}}) {
    auto description =
        robotlink::readRobotDescription(std::string(ROBOTCONTROL_SOURCE_DIR) + "/resources/robots/p3at.yaml");
    if (!description) qFatal("the description of the p3at cannot be read");
    const auto shared = std::make_shared<const robotlink::RobotDescription>(std::move(*description));
    context.robots = {{"p3at1", shared}, {"p3at2", shared}};
  }

  /// The program's key table, in which these packages are off.
  void pushKeys(const std::vector<std::string>& packages, double time = 0) {
    robotcontrol::KeyTable table;
    for (const std::string& package : packages) table.add_keys()->set_name("package/" + package);
    push("p3at1/tables/keys", table, time);
  }
  static robotcontrol::DriveState state() {
    robotcontrol::DriveState state;
    state.set_battery(12.6);
    state.set_motors_on(true);
    state.set_sonar_on(true);
    for (int i = 0; i < 5; ++i) {
      state.add_front_bumpers(false);
      state.add_rear_bumpers(false);
    }
    return state;
  }
  /// Ranges of sonars by number, at their poses on the robot.
  robotcontrol::SonarReadings sonar(const std::vector<std::pair<int, double>>& ranges) const {
    const auto& sonars = *context.robots.at("p3at1")->sonars;
    robotcontrol::SonarReadings readings;
    readings.set_opening_angle(sonars.openingAngle);
    readings.set_maximum(sonars.maximum);
    for (const auto& [number, range] : ranges) {
      auto& reading = *readings.add_readings();
      reading.set_number(static_cast<unsigned>(number));
      robotlink::assign(*reading.mutable_sensor_in_robot(),
                        sonars.sensors[static_cast<std::size_t>(number)].inRobot);
      reading.set_range(range);
    }
    return readings;
  }
  /// 181 readings; `range` returns the range at an angle in rad.
  template <typename F>
  static foxglove::LaserScan laser(F range) {
    foxglove::LaserScan scan;
    robotlink::Pose3 pose = robotlink::Pose3::Identity();
    pose.translation().x() = 0.125;
    robotlink::assign(*scan.mutable_pose(), pose);
    scan.set_start_angle(-robotlink::kPi / 2);
    scan.set_end_angle(robotlink::kPi / 2);
    for (int i = 0; i <= 180; ++i) scan.add_ranges(range(robotlink::radians(i - 90)));
    return scan;
  }
  void pushTruth(const std::map<std::string, robotlink::Pose2>& robots, double time) {
    foxglove::FrameTransforms transforms;
    for (const auto& [robot, pose] : robots) {
      auto& transform = *transforms.add_transforms();
      transform.set_parent_frame_id("field");
      transform.set_child_frame_id(robot);
      transform.mutable_translation()->set_x(pose.x);
      transform.mutable_translation()->set_y(pose.y);
      transform.mutable_rotation()->set_z(std::sin(pose.heading / 2));
      transform.mutable_rotation()->set_w(std::cos(pose.heading / 2));
    }
    push("transforms", transforms, time);
  }
  void pushEstimate(const std::string& robot, const robotlink::Pose2& pose, double time,
                    double deviation = 0.1) {
    robotcontrol::RobotPose estimate;
    robotlink::assign(*estimate.mutable_robot_in_field(), pose);
    estimate.set_position_deviation(deviation);
    push(robot + "/models/pose", estimate, time);
  }
  /// A room of 8 m by 6 m with a wall of points across it, a goal, a home position, and forbidden places.
  static robotcontrol::GroundMap room() {
    robotcontrol::GroundMap map;
    map.set_name("room");
    const auto line = [](robotcontrol::GroundMap::Line& to, double x1, double y1, double x2, double y2) {
      to.set_x1(x1), to.set_y1(y1), to.set_x2(x2), to.set_y2(y2);
    };
    line(*map.add_lines(), 0, 0, 8, 0);
    line(*map.add_lines(), 8, 0, 8, 6);
    line(*map.add_lines(), 8, 6, 0, 6);
    line(*map.add_lines(), 0, 6, 0, 0);
    for (int i = 0; i < 150; ++i) {
      map.add_points(4);
      map.add_points(static_cast<float>(0.02 * i));
    }
    const auto place = [&](robotcontrol::GroundMap::Place::Kind kind, const char* name, double x,
                           double y) -> auto& {
      auto& added = *map.add_places();
      added.set_kind(kind);
      added.set_name(name);
      added.mutable_pose()->set_x(x);
      added.mutable_pose()->set_y(y);
      return added;
    };
    using Place = robotcontrol::GroundMap::Place;
    place(Place::HOME, "", 1, 1);
    auto& desk = place(Place::GOAL, "Desk", 6, 4.5);
    desk.set_has_heading(true);
    desk.mutable_pose()->set_heading(robotlink::kPi / 2);
    line(*place(Place::FORBIDDEN_AREA, "", 0, 0).mutable_extent(), 5, 0.5, 7, 2);
    line(*place(Place::FORBIDDEN_LINE, "", 0, 0).mutable_extent(), 1, 5, 3, 5);
    return map;
  }
  /// The map of a file, relative to the source tree; empty if that is missing.
  static robotcontrol::GroundMap mapOf(const char* file) {
    robotcontrol::GroundMap message;
    const auto map = robotlink::GroundMap::load(std::filesystem::path(ROBOTCONTROL_SOURCE_DIR) / file);
    if (!map) return message;
    message.set_name(map->name);
    for (const auto& line : map->lines) {
      auto& added = *message.add_lines();
      added.set_x1(line.from.x()), added.set_y1(line.from.y()), added.set_x2(line.to.x()),
          added.set_y2(line.to.y());
    }
    for (const auto& point : map->points) {
      message.add_points(static_cast<float>(point.x()));
      message.add_points(static_cast<float>(point.y()));
    }
    for (const auto& place : map->places) {
      auto& added = *message.add_places();
      added.set_kind(static_cast<robotcontrol::GroundMap::Place::Kind>(place.kind));
      added.set_name(place.name);
      robotlink::assign(*added.mutable_pose(), place.pose);
      added.set_has_heading(place.hasHeading);
      auto& extent = *added.mutable_extent();
      extent.set_x1(place.extent.from.x()), extent.set_y1(place.extent.from.y());
      extent.set_x2(place.extent.to.x()), extent.set_y2(place.extent.to.y());
    }
    return message;
  }
  /// One message of link/packets.
  void pushPackets(const std::vector<std::pair<bool, robotlink::arcos::Bytes>>& packets, double time) {
    robotcontrol::LinkPackets published;
    for (const auto& [fromRobot, bytes] : packets) {
      auto& packet = *published.add_packets();
      packet.set_from_robot(fromRobot);
      packet.set_bytes(std::string(bytes.begin(), bytes.end()));
      robotlink::assign(*packet.mutable_timestamp(), robotlink::Instant(robotlink::fromSeconds(time)));
    }
    push("p3at1/link/packets", published, time);
  }
};

}  // namespace widgets::test
