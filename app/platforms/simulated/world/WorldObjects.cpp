// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/WorldObjects.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "app/platforms/SceneMessages.h"
#include "app/platforms/simulated/world/ObjectProperties.h"
#include "app/platforms/simulated/world/PortObjects.h"
#include "app/platforms/simulated/world/control/ControllerObjects.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/packages/Conversions.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/control/Controllers.h"
#include "simcore/world/WorldDescription.h"

namespace app {
namespace {

using robotcontrol::WorldObject;
using robotlink::Pose3;
using simcore::ModelDescription;
using Steps = std::vector<std::string>;

WorldObject::Kind kindOfModel(const ModelDescription& type) {
  if (!type.robot.empty()) return WorldObject::ROBOT;
  if (type.isBall) return WorldObject::BALL;
  return type.field.empty() ? WorldObject::MODEL : WorldObject::FIELD;
}

std::size_t shapesOf(const ModelDescription& type) {
  std::size_t count = 0;
  for (const auto& link : type.links) count += link.visuals.size() + link.collisions.size();
  return count;
}

/// Returns SDFormat's name of the joint type.
const char* jointKind(simcore::JointDescription::Kind kind) {
  using Kind = simcore::JointDescription::Kind;
  switch (kind) {
    case Kind::kHinge:
      return "revolute";
    case Kind::kFixed:
      return "fixed";
    case Kind::kSlider:
      return "prismatic";
    case Kind::kBall:
      return "ball";
    case Kind::kUniversal:
      return "universal";
  }
  return "";
}

/// A property of a shape, and the elements in <geometry> that say it.
struct ShapeNumbers {
  robotcontrol::WorldProperty* property = nullptr;
  Steps steps;
};

/// Adds what a shape is, and returns what of it can be changed.
std::vector<ShapeNumbers> addShape(WorldObject& to, const simcore::Shape& shape) {
  using Kind = simcore::Shape::Kind;
  std::vector<ShapeNumbers> numbers;
  const auto add = [&](const char* name, std::initializer_list<double> values, const char* kind) {
    numbers.push_back({&addNumbers(to, name, values, "m"), {"geometry", kind, name}});
  };
  switch (shape.kind) {
    case Kind::kBox:
      addText(to, "shape", "box");
      add("size", {shape.size.x(), shape.size.y(), shape.size.z()}, "box");
      break;
    case Kind::kPlane:
      addText(to, "shape", "plane");
      add("size", {shape.size.x(), shape.size.y()}, "plane");
      break;
    case Kind::kSphere:
      addText(to, "shape", "sphere");
      add("radius", {shape.radius}, "sphere");
      break;
    case Kind::kCylinder:
    case Kind::kCapsule: {
      const char* kind = shape.kind == Kind::kCylinder ? "cylinder" : "capsule";
      addText(to, "shape", kind);
      add("radius", {shape.radius}, kind);
      add("length", {shape.length}, kind);
      break;
    }
    case Kind::kMesh:
      addText(to, "shape", "mesh");
      break;
  }
  return numbers;
}

/// Adds the objects of one model.
class ModelWriter {
 public:
  ModelWriter(const simcore::ModelInstance& model, const std::string& sceneFile, bool isMovable,
              robotcontrol::WorldObjects& to)
      : model_(model), type_(*model.type), sceneFile_(sceneFile), to_(to) {
    addModel(isMovable);
    hasShapes_ = shapesOf(type_) <= kMaxShapes;
    for (std::size_t i = 0; i < type_.links.size(); ++i) addLink(i);
    for (const auto& joint : type_.joints) addJoint(joint);
  }

 private:
  std::string linkPath(std::size_t link) const { return model_.name + "/link:" + type_.links[link].name; }

  /// Sets the pose of an object that is fixed to a link.
  void place(WorldObject& object, std::size_t link, const Pose3& inLink) const {
    if (type_.isStatic) {
      object.set_frame("field");
      robotlink::assign(*object.mutable_pose_in_frame(),
                        Pose3(model_.poseInWorld * type_.links[link].poseInModel * inLink));
      return;
    }
    object.set_frame("body:" + model_.name + "/" + type_.links[link].name);
    robotlink::assign(*object.mutable_pose_in_frame(), inLink);
  }

  /// Says where a file has a property; nothing if the model is from none.
  void locate(robotcontrol::WorldProperty& property, const Steps& steps) const {
    if (type_.file.empty()) return;
    property.set_file(type_.file);
    property.add_element(type_.file == sceneFile_ ? "instance[" + model_.name + "]" : "model");
    for (const std::string& step : steps) property.add_element(step);
  }

  WorldObject& add(WorldObject::Kind kind, const std::string& path, const std::string& name,
                   const std::string& parent) {
    WorldObject& object = *to_.add_objects();
    object.set_kind(kind);
    object.set_path(path);
    object.set_name(name);
    object.set_parent(parent);
    object.set_model(model_.name);
    return object;
  }

  void addModel(bool isMovable) {
    WorldObject& object = add(kindOfModel(type_), model_.name, model_.name, {});
    object.set_is_movable(isMovable);
    if (!type_.links.empty()) place(object, 0, type_.links[0].poseInModel.inverse());
    double mass = 0;
    for (const auto& link : type_.links) mass += link.mass;
    // The mass of a single link is listed with the other editable properties of the link.
    if (!type_.isStatic && type_.links.size() > 1) addNumbers(object, "mass", {mass}, "kg");
    addText(object, "type", type_.name);
    addText(object, "file", type_.file);
    auto& pose = addNumbers(object, "initial_pose", numbersOf(model_.poseInWorld), "m, rad");
    if (model_.where.line == 0) return;
    pose.set_file(sceneFile_);
    pose.add_element("instance[" + model_.name + "]");
    pose.add_element("pose");
  }

  void addLink(std::size_t index) {
    const auto& link = type_.links[index];
    std::string parent = model_.name;
    for (const auto& joint : type_.joints)
      if (joint.child == static_cast<int>(index)) parent = model_.name + "/joint:" + joint.name;
    WorldObject& object = add(WorldObject::LINK, linkPath(index), link.name, parent);
    place(object, index, Pose3::Identity());
    if (!type_.isStatic) {
      const std::string own = "link[" + link.name + "]";
      locate(addNumbers(object, "mass", {link.mass}, "kg"), {own, "inertial", "mass"});
      const auto& center = link.centerOfMass;
      addNumbers(object, "center_of_mass", {center.x(), center.y(), center.z()}, "m");
      const auto& moments = link.inertia;
      locate(addNumbers(
                 object, "inertia",
                 {moments(0, 0), moments(1, 1), moments(2, 2), moments(0, 1), moments(0, 2), moments(1, 2)},
                 "kg m^2"),
             {own, "inertial", "inertia", "ixx,iyy,izz,ixy,ixz,iyz"});
      locate(addNumbers(object, "linear_damping", {link.linearDamping}, "1/s"),
             {own, "velocity_decay", "linear"});
      locate(addNumbers(object, "angular_damping", {link.angularDamping}, "1/s"),
             {own, "velocity_decay", "angular"});
    }
    if (!hasShapes_) return;
    for (const auto& visual : link.visuals) addVisual(index, visual);
    for (const auto& solid : link.collisions) addSolid(index, solid);
  }

  void addVisual(std::size_t link, const simcore::VisualDescription& visual) {
    WorldObject& object =
        add(WorldObject::SHAPE, linkPath(link) + "/visual:" + visual.name, visual.name, linkPath(link));
    place(object, link, visual.poseInLink);
    const Steps start{"link[" + type_.links[link].name + "]", "visual[" + visual.name + "]"};
    locateShape(addShape(object, visual.shape), start);
    const robotlink::Rgb color = visual.teamColor && model_.teamColor ? *model_.teamColor : visual.color;
    auto& property = addNumbers(object, "color", {double(color.r), double(color.g), double(color.b)});
    property.set_text(visual.teamColor ? "team" : visual.colorName);
    if (visual.teamColor) return;
    if (!visual.colorName.empty()) {
      addText(object, "palette_color", visual.colorName);
      return locate(*object.mutable_properties()->rbegin(), {start[0], start[1], "robotcontrol:color"});
    }
    // Without a palette color, the material defines the color.
    auto& diffuse = addNumbers(object, "diffuse", {color.r / 255.0, color.g / 255.0, color.b / 255.0});
    locate(diffuse, {start[0], start[1], "material", "diffuse"});
  }

  void locateShape(const std::vector<ShapeNumbers>& numbers, const Steps& start) const {
    for (const ShapeNumbers& one : numbers) {
      Steps steps = start;
      steps.insert(steps.end(), one.steps.begin(), one.steps.end());
      locate(*one.property, steps);
    }
  }

  void addSolid(std::size_t link, const simcore::CollisionDescription& solid) {
    WorldObject& object =
        add(WorldObject::SOLID, linkPath(link) + "/solid:" + solid.name, solid.name, linkPath(link));
    place(object, link, solid.poseInLink);
    const Steps own{"link[" + type_.links[link].name + "]", "collision[" + solid.name + "]"};
    locateShape(addShape(object, solid.shape), own);
    const Steps start{own[0], own[1], "surface"};
    const auto below = [&](std::initializer_list<const char*> names) {
      Steps steps = start;
      steps.insert(steps.end(), names.begin(), names.end());
      return steps;
    };
    locate(addNumbers(object, "friction", {solid.friction}), below({"friction", "ode", "mu"}));
    locate(addNumbers(object, "restitution", {solid.restitution}),
           below({"bounce", "restitution_coefficient"}));
  }

  void addJoint(const simcore::JointDescription& joint) {
    const std::string parent =
        joint.parent < 0 ? model_.name : linkPath(static_cast<std::size_t>(joint.parent));
    WorldObject& object = add(WorldObject::JOINT, model_.name + "/joint:" + joint.name, joint.name, parent);
    const auto child = static_cast<std::size_t>(joint.child);
    Pose3 anchor = Pose3::Identity();
    anchor.translate(type_.links[child].poseInModel.inverse() * joint.anchorInModel);
    place(object, child, anchor);
    using Kind = simcore::JointDescription::Kind;
    const bool slides = joint.kind == Kind::kSlider;
    addText(object, "type", jointKind(joint.kind));
    const bool hasAxis = slides || joint.kind == Kind::kHinge || joint.kind == Kind::kUniversal;
    if (!hasAxis) return;
    const char* unit = slides ? "m" : "rad";
    addNumbers(object, "axis", componentsOf(joint.axisInModel));
    const Eigen::Matrix3d modelInLink = type_.links[child].poseInModel.linear().transpose();
    const bool isUniversal = joint.kind == Kind::kUniversal;
    addNumbers(object, "axis_in_link",
               componentsOf(modelInLink * (isUniversal ? joint.secondAxisInModel : joint.axisInModel)));
    if (isUniversal) return;
    const auto ofAxis = [&](const char* group, const char* name) -> Steps {
      return {"joint[" + joint.name + "]", "axis", group, name};
    };
    if (joint.upper > joint.lower && std::isfinite(joint.upper - joint.lower)) {
      locate(addNumbers(object, "lower_limit", {joint.lower}, unit), ofAxis("limit", "lower"));
      locate(addNumbers(object, "upper_limit", {joint.upper}, unit), ofAxis("limit", "upper"));
    }
    if (!joint.servo && !joint.wheel) {
      locate(addNumbers(object, "damping", {joint.damping}, slides ? "N s/m" : "N m s"),
             ofAxis("dynamics", "damping"));
      locate(addNumbers(object, "friction", {joint.friction}, slides ? "N" : "N m"),
             ofAxis("dynamics", "friction"));
    }
    if (!joint.servo) return;
    const auto [speed, torque] = addMotor(object, slides, joint.maximumSpeed, joint.maximumTorque);
    locate(*speed, ofAxis("limit", "velocity"));
    locate(*torque, ofAxis("limit", "effort"));
    addNumbers(object, "noise", {whiteNoise(joint.positionErrors)}, unit);
  }

  const simcore::ModelInstance& model_;
  const ModelDescription& type_;
  const std::string& sceneFile_;
  robotcontrol::WorldObjects& to_;
  bool hasShapes_ = true;
};

void addLamps(const simcore::WorldDescription& world, const std::string& file,
              robotcontrol::WorldObjects& to) {
  for (std::size_t i = 0; i < world.lamps.size(); ++i) {
    const simcore::Lamp& lamp = world.lamps[i];
    const bool isNamed = i < world.lampNames.size() && !world.lampNames[i].empty();
    WorldObject& object = *to.add_objects();
    object.set_kind(WorldObject::LIGHT);
    object.set_name(isNamed ? world.lampNames[i] : "light " + std::to_string(i + 1));
    object.set_path(isNamed ? "light:" + object.name() : object.name());
    object.set_frame("field");
    Pose3 pose = Pose3::Identity();
    pose.translate(lamp.position.cast<double>());
    if (i < world.lampPoses.size()) pose = world.lampPoses[i];
    robotlink::assign(*object.mutable_pose_in_frame(), pose);
    const auto locate = [&](robotcontrol::WorldProperty& property, std::initializer_list<const char*> steps) {
      if (!isNamed) return;
      property.set_file(file);
      property.add_element("light[" + object.name() + "]");
      for (const char* step : steps) property.add_element(step);
    };
    locate(addNumbers(object, "intensity", {static_cast<double>(lamp.intensity)}), {"intensity"});
    locate(addNumbers(object, "diffuse", componentsOf(lamp.color.cast<double>())), {"diffuse"});
    locate(addNumbers(object, "attenuation", {static_cast<double>(lamp.attenuation)}, "1/m^2"),
           {"attenuation", "quadratic"});
    if (lamp.kind != simcore::Lamp::Kind::kPoint && i < world.lampDirections.size())
      locate(addNumbers(object, "direction", componentsOf(world.lampDirections[i])), {"direction"});
    locate(addNumbers(object, "initial_pose", numbersOf(pose), "m, rad"), {"pose"});
  }
}

}  // namespace

std::shared_ptr<const robotcontrol::WorldObjects> worldObjects(const simcore::Simulation& simulation,
                                                               const ExternalControllers* external,
                                                               std::optional<robotlink::Instant> at) {
  auto message = std::make_shared<robotcontrol::WorldObjects>();
  robotlink::assign(*message->mutable_timestamp(), at.value_or(robotlink::Instant(simulation.time())));
  const std::string file = simulation.scene().file().string();
  message->set_file(file);
  const auto movable = movableModels(simulation);
  const auto& robots = simulation.scene().robots();
  for (const auto& model : simulation.scene().world().models) {
    const bool isMovable = std::ranges::find(movable, model.name) != movable.end();
    const int first = message->objects_size();
    const ModelWriter writer(model, file, isMovable, *message);
    const auto robot = std::ranges::find(robots, model.name, &simcore::SceneRobot::name);
    if (robot == robots.end()) continue;
    // An empty one is added, too: then it is known that the robot has none.
    auto& team = *message->mutable_objects(first)->add_properties();
    team.set_name("team");
    team.set_text(robot->team);
  }
  addPorts(simulation, *message);
  addControllers(simulation, external, *message);
  addLamps(simulation.scene().world(), file, *message);
  return message;
}

}  // namespace app
