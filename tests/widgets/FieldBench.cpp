// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/FieldBench.h"

#include <cmath>

#include "foxglove/Image.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"

namespace widgets::test {
namespace {

using robotlink::Pose2;
using robotlink::Pose3;
using robotlink::Vector2;
using robotlink::Vector3;

constexpr double kBallRadius = 0.042;

void addTransform(foxglove::FrameTransforms& to, const std::string& frame, const Pose2& pose, double height) {
  auto& transform = *to.add_transforms();
  transform.set_parent_frame_id("field");
  transform.set_child_frame_id(frame);
  robotlink::assign(*transform.mutable_translation(), Vector3(pose.x, pose.y, height));
  transform.mutable_rotation()->set_z(std::sin(pose.heading / 2));
  transform.mutable_rotation()->set_w(std::cos(pose.heading / 2));
}

foxglove::SceneEntity& addEntity(foxglove::SceneUpdate& scene, const std::string& id,
                                 const std::string& frame, const std::string& model) {
  auto& entity = *scene.add_entities();
  entity.set_id(id);
  entity.set_frame_id(frame);
  if (model.empty()) return entity;
  auto& pair = *entity.add_metadata();
  pair.set_key("model");
  pair.set_value(model);
  return entity;
}

void addCube(foxglove::SceneEntity& entity, const Vector3& center, const Vector3& size,
             robotlink::Rgb color) {
  auto& cube = *entity.add_cubes();
  Pose3 pose = Pose3::Identity();
  pose.translation() = center;
  robotlink::assign(*cube.mutable_pose(), pose);
  robotlink::assign(*cube.mutable_size(), size);
  robotlink::assign(*cube.mutable_color(), color);
}

}  // namespace

void FieldBench::pushImage(const std::string& path, QSize size, robotlink::YCbCr color, QPoint spot,
                           robotlink::YCbCr spotColor) {
  robotlink::Image image(size.width(), size.height(), robotlink::PixelFormat::kYuyv);
  for (std::size_t i = 0; i < image.data.size(); i += 4) {
    image.data[i] = image.data[i + 2] = color.y;
    image.data[i + 1] = color.cb;
    image.data[i + 3] = color.cr;
  }
  if (spotColor != robotlink::YCbCr()) {
    std::uint8_t* pair = image.row(spot.y()) + std::ptrdiff_t{2} * (spot.x() & ~1);
    pair[spot.x() % 2 == 0 ? 0 : 2] = spotColor.y;
    pair[1] = spotColor.cb;
    pair[3] = spotColor.cr;
  }
  auto message = std::make_shared<foxglove::RawImage>();
  robotlink::assign(*message, image.view(), now(), "camera");
  push(path, message);
}

void FieldBench::pushFrame(const std::vector<FramePart>& parts) {
  robotcontrol::DebugQueue queue;
  queue.set_process("cognition");
  for (const auto& part : parts) part(queue);
  auto& end = *queue.add_messages();
  end.set_path("frames/cognition");
  end.mutable_frame()->set_process("cognition");
  end.mutable_frame()->set_number(++frame_);
  for (auto& message : *queue.mutable_messages()) robotlink::assign(*message.mutable_timestamp(), now());
  session.pushQueue("red1", robotlink::fromWire(std::move(queue)));
}

void FieldBench::pushScene() {
  const auto rgb = [this](const char* name) { return *context.field->color(name); };
  auto scene = std::make_shared<foxglove::SceneUpdate>();
  addCube(addEntity(*scene, "ground", "field", ""), {0, 0, -0.01}, {4.2, 2.7, 0.02}, rgb("green"));
  addCube(addEntity(*scene, "wall", "field", ""), {0, 1.4, 0.05}, {4.4, 0.1, 0.1}, rgb("white"));
  addCube(addEntity(*scene, "red1/body", "red1", "red1"), {0, 0, 0.12}, {0.25, 0.14, 0.1}, rgb("red"));
  auto& ball = *addEntity(*scene, "ball/ball", "ball", "ball").add_spheres();
  robotlink::assign(*ball.mutable_pose(), Pose3(Pose3::Identity()));
  robotlink::assign(*ball.mutable_size(), Vector3(Vector3::Constant(2 * kBallRadius)));
  robotlink::assign(*ball.mutable_color(), rgb("orange"));
  push("scene", scene);
}

void FieldBench::pushPoses(const Pose2& robot, const Vector2& ball) {
  auto transforms = std::make_shared<foxglove::FrameTransforms>();
  addTransform(*transforms, "red1", robot, 0);
  addTransform(*transforms, "ball", {ball.x(), ball.y(), 0}, kBallRadius);
  push("transforms", transforms);
}

void FieldBench::pushEstimates(const Pose2& robot, const Vector2& ballInRobot) {
  auto pose = std::make_shared<robotcontrol::RobotPose>();
  robotlink::assign(*pose->mutable_robot_in_field(), robot);
  pose->set_position_deviation(0.1);
  push("red1/models/pose", pose);
  auto ball = std::make_shared<robotcontrol::BallModel>();
  ball->set_known(true);
  robotlink::assign(*ball->mutable_position_in_robot(), ballInRobot);
  ball->set_standard_deviation(0.08);
  push("red1/models/ball", ball);
}

FieldBench::FramePart damagedDrawing(const std::string& key, const std::string& frame) {
  return [=](robotcontrol::DebugQueue& queue) {
    auto& message = *queue.add_messages();
    message.set_path("drawings/field/" + key);
    auto& entity = *message.mutable_scene_drawing()->add_entities();
    entity.set_frame_id(frame);
    auto& lines = *entity.add_lines();
    auto& triangles = *entity.add_triangles();
    for (const double x : {0.0, std::nan(""), 1.0}) {
      lines.add_points()->set_x(x);
      triangles.add_points()->set_x(x);
    }
    for (const std::uint32_t index : {0U, 1U, 7U, 0xFFFFFFFFU, 2U}) {
      lines.add_indices(index);
      triangles.add_indices(index);
    }
    entity.add_texts()->set_font_size(std::nan(""));
    entity.add_spheres()->mutable_size()->set_x(std::nan(""));
  };
}

FieldBench::FramePart imageDrawing(const std::string& key,
                                   const std::function<void(robotlink::ImageDrawing&)>& draw) {
  return [key, draw](robotcontrol::DebugQueue& queue) {
    auto& message = *queue.add_messages();
    message.set_path("drawings/image/" + key);
    robotlink::ImageDrawing drawing(*message.mutable_image_drawing());
    draw(drawing);
  };
}

FieldBench::FramePart worldDrawing(const std::string& kind, const std::string& key, const std::string& frame,
                                   const std::function<void(robotlink::SceneDrawing&)>& draw) {
  return [=](robotcontrol::DebugQueue& queue) {
    auto& message = *queue.add_messages();
    message.set_path("drawings/" + kind + "/" + key);
    auto& entity = *message.mutable_scene_drawing()->add_entities();
    entity.set_frame_id(frame);
    robotlink::SceneDrawing drawing(entity);
    draw(drawing);
  };
}

}  // namespace widgets::test
