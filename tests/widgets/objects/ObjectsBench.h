// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotcontrol/World.pb.h"
#include "tests/widgets/Bench.h"

namespace widgets::test {

/// A session with a simulated scene: the robot red1 with a link, a joint with its servo and sensor, a laser
/// and a camera, and a lamp.
struct ObjectsBench : Bench {
  using Kind = robotcontrol::WorldObject;

  ObjectsBench() : Bench({.robots = {"red1"}, .answers = true}) {
    auto& robot = add(Kind::ROBOT, "red1", "");
    robot.set_is_movable(true);
    robot.set_frame("field");
    robot.mutable_pose_in_frame()->mutable_position()->set_x(0.5);
    robot.mutable_pose_in_frame()->mutable_orientation()->set_w(1);
    auto& initial = *robot.add_properties();
    initial.set_name("initial_pose");
    initial.set_file("/scenes/w.sdf");
    initial.add_element("instance[red1]");
    initial.add_element("pose");
    auto& mass = *add(Kind::LINK, "red1/link:body", "red1").add_properties();
    mass.set_name("mass");
    mass.add_values(2);
    mass.set_unit("kg");
    mass.set_file("/scenes/model.sdf");
    for (const char* step : {"model", "link[body]", "inertial", "mass"}) mass.add_element(step);
    add(Kind::JOINT, "red1/joint:pan", "red1/link:body");
    auto& servo = addPort(Kind::ACTUATOR, "red1/pan/request", "red1/joint:pan", "angle");
    servo.set_is_actuator(true);
    servo.set_minimum(-1);
    servo.set_maximum(1);
    servo.set_unit("rad");
    addPort(Kind::SENSOR, "red1/pan/position", "red1/joint:pan", "angle").set_unit("rad");
    auto& laser = addPort(Kind::SENSOR, "red1/laser", "red1/link:body", "range");
    laser.add_shape(4);
    laser.set_maximum(8);
    laser.set_unit("m");
    auto& camera = addPort(Kind::SENSOR, "red1/cam/image", "red1/link:body", "image");
    camera.add_shape(120);
    camera.add_shape(160);
    camera.add_shape(3);
    camera.set_image_stream("red1/cam/image");
    add(Kind::LIGHT, "light 1", "");
    push("objects", objects, 1);
    for (const char* name : {"plots.add", "columns.show", "image.stream", "image.show", "view.show",
                             "scene.open", "scene.hide", "scene.show", "scene.draw", "scene.opacity",
                             "scene.follow", "scene.edit", "scene.copy", "scene.erase", "scene.rename"})
      addCommand(name);
  }

  robotcontrol::WorldObject& add(Kind::Kind kind, const std::string& path, const std::string& parent) {
    auto& object = *objects.add_objects();
    object.set_kind(kind);
    object.set_path(path);
    object.set_parent(parent);
    object.set_name(path.substr(path.find_last_of(":") + 1));
    if (path.starts_with("red1")) object.set_model("red1");
    return object;
  }
  robotcontrol::WorldPort& addPort(Kind::Kind kind, const std::string& path, const std::string& parent,
                                   const char* type) {
    auto& port = *add(kind, path, parent).mutable_port();
    port.set_path(path);
    port.set_robot("red1");
    port.set_type(type);
    return port;
  }
  /// A command with any words, which are noted.
  void addCommand(const std::string& name) {
    using Type = robotlink::CommandTable::Type;
    robotlink::CommandTable::Command command{name, "Notes its words", {{"first", Type::kText, ""}}};
    if (name.starts_with("image")) command.arguments.push_back({"second", Type::kText, ""});
    const bool hasOne = name == "scene.edit" || name == "scene.copy" || name == "scene.erase";
    if (name.starts_with("scene.") && !hasOne)
      command.arguments.push_back({"second", name == "scene.opacity" ? Type::kNumber : Type::kText, "",
                                   name == "scene.opacity" ? robotlink::CommandTable::Value(1.0)
                                                           : robotlink::CommandTable::Value(std::string())});
    if (name == "scene.draw" || name == "scene.opacity" || name == "scene.follow")
      command.arguments.push_back({"third", Type::kText, "", std::string()});
    command.run = [this, name](const robotlink::CommandTable::Values& values) -> robotlink::Result<void> {
      std::string line = name;
      for (const auto& value : values) {
        const auto* number = std::get_if<double>(&value);
        line += " " + (number == nullptr ? std::get<std::string>(value) : std::to_string(*number));
      }
      lines.push_back(line);
      return {};
    };
    if (name == "scene.show") command.offer = [this](const auto&) { return hidden; };
    commands.add(std::move(command));
  }
  /// Publishes readings of the angle and the laser, and at which value the servo is held.
  void publishReadings(double angle, std::optional<double> held = {}) {
    robotcontrol::PortReadings readings;
    auto& position = *readings.add_readings();
    position.set_port("red1/pan/position");
    position.add_values(angle);
    auto& laser = *readings.add_readings();
    laser.set_port("red1/laser");
    for (const double range : {1.0, 2.0, 4.0, 8.0}) laser.add_values(range);
    if (held) {
      auto& servo = *readings.add_held();
      servo.set_port("red1/pan/request");
      servo.add_values(*held);
    }
    push("ports", readings, 1 + 0.1 * ++published);
  }

  robotcontrol::WorldObjects objects;
  /// The commands that were run.
  std::vector<std::string> lines;
  /// What scene.show would show again.
  std::vector<std::string> hidden;
  int published = 0;
};

}  // namespace widgets::test
