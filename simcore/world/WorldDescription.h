// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"
#include "simcore/world/ActuatorDescription.h"
#include "simcore/world/CameraModel.h"
#include "simcore/world/ControllerDescription.h"
#include "simcore/world/Radiation.h"
#include "simcore/world/RenderScene.h"
#include "simcore/world/SensorDescription.h"

namespace simcore {

using robotlink::Vector3;

/// A shape centered at its frame's origin; cylinders and capsules are along z. A plane's normal is the z-axis
/// of its frame, and it is solid below. A mesh is located by its vertices; it is a solid of static models
/// only.
struct Shape {
  enum class Kind : std::uint8_t { kBox, kSphere, kCylinder, kCapsule, kPlane, kMesh };
  Kind kind = Kind::kBox;
  /// Box: edge lengths; plane: x and y of the visible part.
  Vector3 size = Vector3::Zero();
  /// Meters.
  double radius = 0;
  /// Length of a cylinder, or of a capsule's cylindrical part.
  double length = 0;
  /// Only for kMesh.
  std::shared_ptr<const Mesh> mesh = {};
};

/// A solid of a link, for collisions.
struct CollisionDescription {
  std::string name;
  Pose3 poseInLink = Pose3::Identity();
  Shape shape;
  /// Coulomb's friction coefficient; of two touching solids the smaller one counts.
  double friction = 1;
  /// The restitution, from 0 (no bounce) to 1.
  double restitution = 0;
};

/// A visible part of a link. Its color is fixed, or that of the robot's team.
struct VisualDescription {
  std::string name;
  Pose3 poseInLink = Pose3::Identity();
  Shape shape;
  Rgb color;
  /// In the palette; empty if it has none or if it is the team's.
  std::string colorName;
  bool teamColor = false;
  bool castsShadow = true;
  /// The reflection and emission of radiation classes by the surface.
  std::vector<SurfaceRadiation> radiation;
};

/// A rigid body of a model.
struct LinkDescription {
  std::string name;
  /// With all joints at 0.
  Pose3 poseInModel = Pose3::Identity();
  /// Kilograms.
  double mass = 0;
  /// In the link's frame.
  Vector3 centerOfMass = Vector3::Zero();
  /// The inertia about the center of mass, in the axes of the link, kg m^2.
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();
  /// Fraction of the velocity lost per second.
  double linearDamping = 0, angularDamping = 0;
  /// Gravity does not pull it.
  bool weightless = false;
  std::vector<CollisionDescription> collisions;
  std::vector<VisualDescription> visuals;
  std::vector<Emitter> emitters;
};

/// A joint of a model. Joints are ordered such that those of parents come first, and those that close a cycle
/// last.
struct JointDescription {
  /// Hinges turn about the axis, sliders move along it, balls turn freely; a universal joint turns about the
  /// axis, which is fixed to the parent, and a second one, which is fixed to the child.
  enum class Kind : std::uint8_t { kHinge, kFixed, kSlider, kBall, kUniversal };
  std::string name;
  Kind kind = Kind::kHinge;
  /// Whether the child has another joint to a parent: then this one does not determine the child's pose.
  bool closesCycle = false;
  /// Index of a link; -1 is the world.
  int parent = -1;
  int child = 0;
  /// With all joints at 0.
  Vector3 anchorInModel = Vector3::Zero();
  Vector3 axisInModel = Vector3::UnitZ();
  // Limits, rad, or m of sliders; -kFullTurn and kFullTurn of hinges, infinite of sliders, are none.
  double lower = 0, upper = 0;
  static constexpr double kFullTurn = 2 * robotlink::kPi;
  /// Only for universal joints.
  Vector3 secondAxisInModel = Vector3::UnitX();
  double secondLower = -kFullTurn, secondUpper = kFullTurn;
  /// Resistance: N m s or N s/m, and N m or N (also at rest); about each axis. Only joints without a servo.
  double damping = 0, friction = 0;
  /// Driven by a servo; otherwise it turns freely.
  bool servo = false;
  // rad/s and N m, of the servo; of a slider m/s and N.
  double maximumSpeed = 0, maximumTorque = 0;
  /// rad or m.
  double initialAngle = 0;
  /// Errors of its position sensor, rad or m.
  SensorErrors positionErrors;
  /// Driven by the model's drive.
  bool wheel = false;
  /// A fixed one whose forces a sensor measures, so that its links are no rigid body.
  bool isMeasured = false;
  bool slides() const { return kind == Kind::kSlider; }
  /// Whether it has one degree of freedom, with a sensor of its position.
  bool hasPosition() const { return (kind == Kind::kHinge || kind == Kind::kSlider) && !wheel; }
  /// How its motor is controlled, if it has one (`servo`).
  MotorControl control;
  /// Set if the joint is that of a door that its motor opens.
  std::optional<DoorDescription> door;
  /// Sensors of its speed (rad/s) and of the torque that turns it (N m).
  std::optional<SensorErrors> speedSensor, loadSensor;
};

/// Wheels on the two sides of a model. Each wheel is a joint whose child link has one solid, a cylinder about
/// the joint's axis.
struct DriveDescription {
  std::string name = "drive";
  std::string controller;        ///< the protocol of its microcontroller ("arcos"); empty: it has none
  std::vector<int> left, right;  ///< joints
  double wheelRadius = 0;
  /// The effective track on firm ground, m.
  double track = 0;
  /// Speed of the rims, m/s.
  double maximumSpeed = 0;
  /// The maximum force at the rim of each wheel, N.
  double maximumForce = 0;
  /// Resistance at the rim of each wheel without power, N.
  double idleForce = 0;
};

/// An initial position of a team's robots on a field.
struct HomeDescription {
  /// Empty: for any team.
  std::string team;
  /// In the model's frame.
  robotlink::Pose2 place;
};

/// The contents of a model file. Parsed once and shared by all instances of the model.
struct ModelDescription {
  std::string file;
  std::string name;
  /// The kind of robot (resources/robots/<robot>.yaml); empty if it is not a robot.
  std::string robot;
  /// See SceneRobot::layout.
  std::string layout;
  /// The field that it shows (resources/fields/<field>.yaml); empty if it is not a field.
  std::string field;
  /// Whether it never moves.
  bool isStatic = false;
  /// Whether its contacts with robots are counted.
  bool isBall = false;
  std::vector<LinkDescription> links;
  std::vector<JointDescription> joints;
  std::vector<SensorDescription> sensors;
  std::optional<DriveDescription> drive;
  std::optional<GuidedMotion> guided;
  /// Only with `guided`, which then says what it is commanded.
  std::optional<VehicleDescription> vehicle;
  std::optional<WalkDescription> walk;
  MotionMode motion = MotionMode::kUnset;
  std::vector<HomeDescription> homes;
  std::vector<ControllerDescription> controllers;
  /// Whether it has something that can be commanded without forces; drives have a motion of their own.
  bool canFollow() const {
    if (isStatic || drive) return false;
    if (guided) return vehicle || guided->kind != GuidedMotion::Kind::kFree;
    return walk || std::ranges::any_of(joints, [](const JointDescription& joint) { return joint.servo; });
  }
  /// Whether a joint holds it at the world, so that it cannot be elsewhere, whatever its links do: a
  /// pendulum, a door with its frame.
  bool isFixedToWorld() const {
    return std::ranges::any_of(joints, [](const JointDescription& joint) { return joint.parent < 0; });
  }
};

/// A model in the world.
struct ModelInstance {
  std::string name;
  std::shared_ptr<const ModelDescription> type;
  Pose3 poseInWorld = Pose3::Identity();
  /// Color and name of its team, if it has one.
  std::optional<Rgb> teamColor;
  std::string teamColorName;
  /// See SceneRobot::layout; empty: that of its type.
  std::string layout;
  /// See SceneRobot::role.
  std::string role;
  /// The mode that its <include> chooses; kUnset: the mode of its type.
  MotionMode motion = MotionMode::kUnset;
  MotionMode chosenMotion() const { return motion != MotionMode::kUnset ? motion : type->motion; }
  /// Whether it moves in the plane as it is commanded, and its joints, without forces.
  bool follows() const { return type->canFollow() && chosenMotion() >= MotionMode::kKinematic; }
  /// The position of its <include> or <model> in the file.
  robotlink::FilePosition where;
};

/// A checked world: every index is valid, every number finite and of a sensible magnitude. A plain value.
struct WorldDescription {
  std::string name;
  /// The rules of the game that is played in it (resources/games/<game>.yaml); empty: there is none.
  std::string game;
  /// The place in the file that names the game.
  robotlink::FilePosition gameWhere = {};
  /// Meters per second squared.
  Vector3 gravity = {0, 0, -9.81};
  /// Whether bodies that rest are computed only when something touches or moves them.
  bool sleeps = true;
  float ambient = 0.4F;
  Rgb background;
  std::vector<Lamp> lamps;
  /// In the world's frame, T.
  Vector3 magneticField = {5.5645e-6, 22.8758e-6, -42.3884e-6};
  std::vector<RadiationClass> radiationClasses;
  /// Their names in the world's file, by lamp.
  std::vector<std::string> lampNames;
  /// The directions of the lamps as in the world's file, in their own frames, by lamp; meaningless for point
  /// lights.
  std::vector<Vector3> lampDirections;
  /// Where they are and how they are turned, by lamp.
  std::vector<Pose3> lampPoses;
  /// The radiation that the lamps emit in each class, by lamp.
  std::vector<std::vector<ClassIntensity>> lampRadiation;
  /// The controllers that belong to no model.
  std::vector<ControllerDescription> controllers;
  std::vector<ModelInstance> models;
};

}  // namespace simcore
