// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/SceneMessages.h"

#include <algorithm>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/MapConversions.h"
#include "simcore/ModelParts.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/world/WorldDescription.h"

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

void addMetadata(foxglove::SceneEntity& to, const char* key, const std::string& value) {
  auto& pair = *to.add_metadata();
  pair.set_key(key);
  pair.set_value(value);
}

std::string linkPath(const simcore::ModelInstance& model, const simcore::LinkDescription& link) {
  return model.name + "/link:" + link.name;
}

/// The paths of all visible parts, in the order of the instances of the render scene.
std::vector<std::string> visualPaths(const simcore::Simulation& simulation) {
  std::vector<std::string> paths;
  for (const simcore::ModelInstance& model : simulation.scene().world().models) {
    for (const simcore::LinkDescription& link : model.type->links) {
      for (const simcore::VisualDescription& visual : link.visuals)
        paths.push_back(linkPath(model, link) + "/visual:" + visual.name);
    }
  }
  return paths;
}

/// Adds what collides in one of the simple shapes of the message, or as triangles.
void addSolid(foxglove::SceneEntity& to, const simcore::Shape& shape, const robotlink::Pose3& pose) {
  using Kind = simcore::Shape::Kind;
  const robotlink::Rgb color{250, 150, 40};
  const auto add = [&](auto& primitive, const robotlink::Vector3& size) {
    robotlink::assign(*primitive.mutable_pose(), pose);
    robotlink::assign(*primitive.mutable_color(), color);
    primitive.mutable_size()->set_x(size.x());
    primitive.mutable_size()->set_y(size.y());
    primitive.mutable_size()->set_z(size.z());
  };
  const double width = 2 * shape.radius;
  switch (shape.kind) {
    case Kind::kBox:
      return add(*to.add_cubes(), shape.size);
    case Kind::kPlane:
      return add(*to.add_cubes(), {shape.size.x(), shape.size.y(), 0});
    case Kind::kSphere:
      return add(*to.add_spheres(), {width, width, width});
    case Kind::kCylinder: {
      auto& cylinder = *to.add_cylinders();
      cylinder.set_bottom_scale(1);
      cylinder.set_top_scale(1);
      return add(cylinder, {width, width, shape.length});
    }
    case Kind::kCapsule:
    case Kind::kMesh: {
      auto& triangles = *to.add_triangles();
      robotlink::assign(*triangles.mutable_pose(), pose);
      robotlink::assign(*triangles.mutable_color(), color);
      if (shape.kind == Kind::kMesh && shape.mesh == nullptr) return;
      return assignMesh(triangles, shape.kind == Kind::kMesh
                                       ? *shape.mesh
                                       : simcore::capsuleMesh(static_cast<float>(shape.radius),
                                                              static_cast<float>(shape.length)));
    }
  }
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
  const auto& all = simulation.scene().world().models;
  for (const simcore::ModelInstance& model : all) {
    if (std::ranges::find(models, model.name) == models.end()) models.push_back(model.name);
  }
  std::erase_if(models, [&](const std::string& name) {
    const auto model = std::ranges::find(all, name, &simcore::ModelInstance::name);
    return model == all.end() || model->type->isStatic || model->type->isFixedToWorld();
  });
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
  const std::vector<std::string> objects = visualPaths(simulation);
  for (std::size_t i = 0; i < scene->instances.size(); ++i) {
    const simcore::RenderInstance& instance = scene->instances[i];
    const std::string& body = scene->bodies[static_cast<std::size_t>(instance.body)];
    auto& entity = *update->add_entities();
    robotlink::assign(*entity.mutable_timestamp(), at.value_or(now(simulation)));
    entity.set_frame_id(frameOf(body));
    entity.set_id(std::to_string(i) + ":" + instance.name);
    if (i < objects.size()) addMetadata(entity, "object", objects[i]);
    if (const std::string model = modelOf(body, movable); !model.empty()) addMetadata(entity, "model", model);
    addShape(entity, instance, *scene);
  }
  return update;
}

std::shared_ptr<const foxglove::SceneUpdate> solidsMessage(const simcore::Simulation& simulation,
                                                           std::optional<robotlink::Instant> at) {
  auto update = std::make_shared<foxglove::SceneUpdate>();
  for (const simcore::ModelInstance& model : simulation.scene().world().models) {
    for (const simcore::LinkDescription& link : model.type->links) {
      const bool isStatic = model.type->isStatic;
      const robotlink::Pose3 linkInBody =
          isStatic ? robotlink::Pose3(model.poseInWorld * link.poseInModel) : robotlink::Pose3::Identity();
      for (const simcore::CollisionDescription& solid : link.collisions) {
        auto& entity = *update->add_entities();
        robotlink::assign(*entity.mutable_timestamp(), at.value_or(now(simulation)));
        entity.set_frame_id(isStatic ? kFieldFrame : frameOf(model.name + "/" + link.name));
        const std::string path = linkPath(model, link) + "/solid:" + solid.name;
        entity.set_id(std::to_string(update->entities_size()) + ":" + path);
        addMetadata(entity, "object", path);
        addSolid(entity, solid.shape, linkInBody * solid.poseInLink);
      }
    }
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
