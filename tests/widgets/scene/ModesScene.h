// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/scene/ShownScene.h"

namespace widgets::test {

/// A view of a scene with objects: a green floor, and a model "crate", which is a red box of 0.6 m with a
/// blue ball in it that hangs at a joint; a camera looks ahead on top of it, and a laser sits before it.
struct ModesScene : ShownScene {
  using Object = robotcontrol::WorldObject;
  static inline const robotlink::Vector3 kTop{0, 0, 0.6};

  ModesScene() {
    pushShapes();
    pushSolids();
    pushObjects();
    moveTo({0, 0, 0});
    SceneCamera near = SceneCamera::beside(3.2);
    near.target.z() = 0.3;
    canvas->setCamera(near);
    if (!step()) qFatal("nothing is drawn");
  }

  void moveTo(const robotlink::Pose2& pose) {
    auto transforms = std::make_shared<foxglove::FrameTransforms>();
    for (const char* link : {"box", "core"}) {
      auto& transform = *transforms->add_transforms();
      transform.set_parent_frame_id("field");
      transform.set_child_frame_id(std::string("body:crate/") + link);
      transform.mutable_translation()->set_x(pose.x);
      transform.mutable_translation()->set_y(pose.y);
      transform.mutable_translation()->set_z(0.3);
      transform.mutable_rotation()->set_w(std::cos(pose.heading / 2));
      transform.mutable_rotation()->set_z(std::sin(pose.heading / 2));
    }
    world.push("transforms", transforms);
  }

  /// Waits until the camera rests.
  bool rest() {
    settle();
    return step();
  }
  int count(const std::function<bool(const QColor&)>& is) const {
    const QImage shown = picture();
    int found = 0;
    for (int y = 0; y < shown.height(); ++y)
      for (int x = 0; x < shown.width(); ++x) found += is(shown.pixelColor(x, y)) ? 1 : 0;
    return found;
  }
  int red() const {
    return count([](const QColor& c) { return c.red() > 90 && c.green() < 60 && c.blue() < 60; });
  }
  int blue() const {
    return count([](const QColor& c) { return c.blue() > 90 && c.blue() > c.red() + 50 && c.green() < 110; });
  }
  int green() const {
    return count([](const QColor& c) { return c.green() > 60 && c.green() > c.red() + 40 && c.blue() < 80; });
  }
  int orange() const {
    return count([](const QColor& c) {
      return c.red() > 100 && c.green() > 55 && c.green() < c.red() - 20 && c.blue() < 110;
    });
  }
  /// How many pixels have the first of the calm colors, which is a grayish blue; the sky is paler.
  int calmBlue() const {
    return count([](const QColor& c) {
      return c.hslHue() > 195 && c.hslHue() < 230 && c.hslSaturationF() > 0.2 && c.hslSaturationF() < 0.5 &&
             c.lightnessF() < 0.66;
    });
  }
  /// How many blue pixels have the color of their left neighbor.
  int alike() const {
    const QImage shown = picture();
    int found = 0;
    for (int y = 0; y < shown.height(); ++y) {
      for (int x = 1; x < shown.width(); ++x) {
        const QColor c = shown.pixelColor(x, y);
        found += c.blue() > c.red() + 50 && shown.pixel(x, y) == shown.pixel(x - 1, y) ? 1 : 0;
      }
    }
    return found;
  }

 private:
  static foxglove::SceneEntity& entity(foxglove::SceneUpdate& to, const char* frame, const char* object) {
    auto& added = *to.add_entities();
    added.set_id(object);
    added.set_frame_id(frame);
    auto& path = *added.add_metadata();
    path.set_key("object");
    path.set_value(object);
    return added;
  }
  static void cube(foxglove::SceneEntity& to, const robotlink::Vector3& size, robotlink::Rgb color) {
    auto& added = *to.add_cubes();
    robotlink::assign(*added.mutable_pose(), robotlink::Pose3::Identity());
    robotlink::assign(*added.mutable_size(), size);
    robotlink::assign(*added.mutable_color(), color);
  }
  void pushShapes() {
    auto shapes = std::make_shared<foxglove::SceneUpdate>();
    cube(entity(*shapes, "field", "floor/link:l/visual:v"), {8, 8, 0.01}, {0, 130, 30});
    cube(entity(*shapes, "body:crate/box", "crate/link:box/visual:skin"), {0.6, 0.6, 0.6}, {220, 20, 20});
    auto& ball = *entity(*shapes, "body:crate/core", "crate/link:core/visual:skin").add_spheres();
    robotlink::assign(*ball.mutable_pose(), robotlink::Pose3::Identity());
    robotlink::assign(*ball.mutable_size(), robotlink::Vector3(0.4, 0.4, 0.4));
    robotlink::assign(*ball.mutable_color(), robotlink::Rgb{20, 40, 230});
    world.push("scene", shapes);
  }
  void pushSolids() {
    auto solids = std::make_shared<foxglove::SceneUpdate>();
    cube(entity(*solids, "body:crate/box", "crate/link:box/solid:hull"), {0.8, 0.8, 0.8}, {250, 150, 40});
    world.push("solids", solids);
  }
  Object& add(Object::Kind kind, const std::string& path, const std::string& parent) {
    auto& object = *objects.add_objects();
    object.set_kind(kind);
    object.set_path(path);
    object.set_parent(parent);
    object.set_name(path.substr(path.find_last_of(":/") + 1));
    object.set_model(path.substr(0, path.find('/')));
    return object;
  }
  static void place(Object& object, const char* frame, const robotlink::Vector3& at = {0, 0, 0}) {
    object.set_frame(frame);
    robotlink::Pose3 pose = robotlink::Pose3::Identity();
    pose.translation() = at;
    robotlink::assign(*object.mutable_pose_in_frame(), pose);
  }
  static void addNumbers(Object& object, const char* name, std::initializer_list<double> values) {
    auto& property = *object.add_properties();
    property.set_name(name);
    for (const double value : values) property.add_values(value);
  }
  void pushObjects() {
    add(Object::MODEL, "floor", "");
    add(Object::LINK, "floor/link:l", "floor");
    auto& crate = add(Object::MODEL, "crate", "");
    place(crate, "body:crate/box");
    addNumbers(crate, "mass", {8});
    auto& box = add(Object::LINK, "crate/link:box", "crate");
    place(box, "body:crate/box");
    addNumbers(box, "mass", {8});
    addNumbers(box, "center_of_mass", {0, 0, 0.1});
    auto& joint = add(Object::JOINT, "crate/joint:swing", "crate/link:box");
    place(joint, "body:crate/core");
    addNumbers(joint, "axis_in_link", {0, 0, 1});
    place(add(Object::LINK, "crate/link:core", "crate/joint:swing"), "body:crate/core");
    add(Object::SHAPE, "crate/link:core/visual:skin", "crate/link:core");
    auto& laser = add(Object::SENSOR, "crate/laser", "crate/link:box");
    place(laser, "body:crate/box", {0.31, 0, 0.2});
    addNumbers(laser, "angles", {-0.5, 0.5});
    laser.mutable_port()->set_path("crate/laser");
    laser.mutable_port()->set_type("range");
    laser.mutable_port()->set_maximum(4);
    laser.mutable_port()->add_shape(3);
    auto& camera = add(Object::SENSOR, "crate/cam", "crate/link:box");
    place(camera, "body:crate/box", {0.35, 0, 0.3});
    addNumbers(camera, "opening_angles", {1.2, 0.9});
    camera.mutable_port()->set_path("crate/cam");
    camera.mutable_port()->set_type("image");
    world.push("objects", std::make_shared<robotcontrol::WorldObjects>(objects));
  }

  robotcontrol::WorldObjects objects;
};

}  // namespace widgets::test
