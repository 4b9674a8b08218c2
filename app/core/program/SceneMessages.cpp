// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/SceneMessages.h"

#include "foxglove/Geometry.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/MapConversions.h"
#include "simcore/ModelParts.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"

namespace app {
namespace {

constexpr const char* kFieldFrame = "field";

robotlink::Instant now(const simcore::Simulation& simulation) {
  return robotlink::Instant(simulation.time());
}

/// Returns "red1" for the body "red1/legFL2" if that is a movable model; otherwise an empty text.
std::string modelOf(const std::string& body, const std::vector<std::string>& movable) {
  for (const std::string& model : movable) {
    if (body == model || body.rfind(model + "/", 0) == 0) return model;
  }
  return {};
}

/// The name of a body's frame. Bodies have a prefix, since the frame on the ground below a robot has the
/// robot's own name.
std::string frameOf(const std::string& body) {
  return body == "world" ? kFieldFrame : "body:" + body;
}

void assignMesh(foxglove::TriangleListPrimitive& to, const simcore::Mesh& mesh) {
  for (const auto& vertex : mesh.vertices) {
    auto& point = *to.add_points();
    point.set_x(vertex.x());
    point.set_y(vertex.y());
    point.set_z(vertex.z());
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) to.add_indices(index);
  }
}

void addShape(foxglove::SceneEntity& to, const simcore::RenderInstance& instance,
              const simcore::RenderScene& scene) {
  auto& triangles = *to.add_triangles();
  robotlink::assign(*triangles.mutable_pose(), instance.meshInBody);
  robotlink::assign(*triangles.mutable_color(), instance.color);
  assignMesh(triangles, scene.meshes[static_cast<std::size_t>(instance.mesh)]);
}

void addTransform(foxglove::FrameTransforms& to, const std::string& child, const robotlink::Pose3& pose,
                  robotlink::Instant time) {
  auto& transform = *to.add_transforms();
  robotlink::assign(*transform.mutable_timestamp(), time);
  transform.set_parent_frame_id(kFieldFrame);
  transform.set_child_frame_id(child);
  foxglove::Pose message;
  robotlink::assign(message, pose);
  transform.mutable_translation()->Swap(message.mutable_position());
  transform.mutable_rotation()->Swap(message.mutable_orientation());
}

/// The frame on the ground at a pose, z up.
robotlink::Pose3 onGround(const robotlink::Pose2& pose) {
  robotlink::Pose3 result = robotlink::Pose3::Identity();
  result.translate(robotlink::Vector3(pose.x, pose.y, 0));
  result.rotate(Eigen::AngleAxisd(pose.heading, robotlink::Vector3::UnitZ()));
  return result;
}

}  // namespace

std::vector<std::string> movableModels(const simcore::Simulation& simulation) {
  std::vector<std::string> models;
  for (const auto& robot : simulation.scene().robots()) models.push_back(robot.name);
  const auto& balls = simulation.scene().balls();
  models.insert(models.end(), balls.begin(), balls.end());
  return models;
}

std::shared_ptr<const robotcontrol::GroundMap> mapMessage(const robotlink::GroundMap& map,
                                                          robotlink::Instant now) {
  auto message = std::make_shared<robotcontrol::GroundMap>();
  robotlink::assign(*message, map);
  robotlink::assign(*message->mutable_timestamp(), now);
  return message;
}

std::shared_ptr<const foxglove::SceneUpdate> sceneMessage(const simcore::Simulation& simulation,
                                                          std::optional<robotlink::Instant> at) {
  auto update = std::make_shared<foxglove::SceneUpdate>();
  // A scene that was edited has other entities.
  auto& before = *update->add_deletions();
  before.set_type(foxglove::SceneEntityDeletion::ALL);
  robotlink::assign(*before.mutable_timestamp(), now(simulation));
  const auto scene = simulation.renderScene();
  const std::vector<std::string> movable = movableModels(simulation);
  for (std::size_t i = 0; i < scene->instances.size(); ++i) {
    const simcore::RenderInstance& instance = scene->instances[i];
    const std::string& body = scene->bodies[static_cast<std::size_t>(instance.body)];
    auto& entity = *update->add_entities();
    robotlink::assign(*entity.mutable_timestamp(), at.value_or(now(simulation)));
    entity.set_frame_id(frameOf(body));
    entity.set_id(std::to_string(i) + ":" + instance.name);
    if (const std::string model = modelOf(body, movable); !model.empty()) {
      auto& pair = *entity.add_metadata();
      pair.set_key("model");
      pair.set_value(model);
    }
    addShape(entity, instance, *scene);
  }
  return update;
}

std::shared_ptr<const foxglove::SceneUpdate> modelMessage(const simcore::ModelParts& model) {
  auto update = std::make_shared<foxglove::SceneUpdate>();
  for (std::size_t i = 0; i < model.links.size(); ++i)
    update->add_entities()->set_id(model.shapes->bodies[i + 1]);
  // Body 0 is the world, in which nothing is.
  for (const simcore::RenderInstance& instance : model.shapes->instances)
    addShape(*update->mutable_entities(instance.body - 1), instance, *model.shapes);
  return update;
}

std::shared_ptr<const foxglove::FrameTransforms> transformsMessage(const simcore::Simulation& simulation,
                                                                   std::optional<robotlink::Instant> at) {
  const robotlink::Instant time = at.value_or(now(simulation));
  auto message = std::make_shared<foxglove::FrameTransforms>();
  const auto scene = simulation.renderScene();
  const auto poses = simulation.bodyPoses();
  for (std::size_t i = 1; i < poses.size(); ++i) {
    addTransform(*message, frameOf(scene->bodies[i]), poses[i], time);
  }
  for (const auto& robot : simulation.scene().robots()) {
    if (const auto pose = simulation.modelPose(robot.name)) {
      addTransform(*message, robot.name, onGround(robotlink::groundPose(*pose)), time);
    }
  }
  return message;
}

std::shared_ptr<const robotcontrol::WorldForces> forcesMessage(const simcore::Simulation& simulation,
                                                               robotlink::Instant at) {
  const auto set = [](auto* to, const robotlink::Vector3& from) {
    to->set_x(from.x());
    to->set_y(from.y());
    to->set_z(from.z());
  };
  const simcore::Forces forces = simulation.forces();
  auto message = std::make_shared<robotcontrol::WorldForces>();
  robotlink::assign(*message->mutable_timestamp(), at);
  for (const simcore::ContactForce& contact : forces.contacts) {
    auto& to = *message->add_contacts();
    to.set_first(contact.first);
    to.set_second(contact.second);
    set(to.mutable_point(), contact.point);
    set(to.mutable_normal(), contact.normal);
    to.set_depth(contact.depth);
    set(to.mutable_force(), contact.force);
  }
  for (const simcore::JointForce& joint : forces.joints) {
    auto& to = *message->add_joints();
    to.set_joint(joint.joint);
    set(to.mutable_anchor(), joint.anchor);
    set(to.mutable_force(), joint.force);
    set(to.mutable_torque(), joint.torque);
  }
  for (const simcore::HandForce& hand : forces.hands) {
    auto& to = *message->add_hands();
    const bool isDrag = hand.kind == simcore::HandForce::Kind::kDrag;
    to.set_kind(isDrag ? robotcontrol::HandForce::DRAG : robotcontrol::HandForce::PUSH);
    to.set_path(hand.link);
    set(to.mutable_point(), hand.point);
    if (isDrag) set(to.mutable_target(), hand.target);
    set(to.mutable_force(), hand.force);
  }
  return message;
}

}  // namespace app
