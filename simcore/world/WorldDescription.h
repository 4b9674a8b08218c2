// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"
#include "simcore/world/CameraModel.h"
#include "simcore/world/RenderScene.h"

namespace simcore {

using robotlink::Vector3;

/// A solid, centred on its frame's origin; cylinders and capsules along z. A plane's normal is its frame's
/// z-axis, and it is solid below. A mesh is where its vertices are, and nothing collides with it.
struct Shape {
  enum class Kind : std::uint8_t { kBox, kSphere, kCylinder, kCapsule, kPlane, kMesh };
  Kind kind = Kind::kBox;
  Vector3 size = Vector3::Zero();  ///< box: edges; plane: x and y are those of its picture
  double radius = 0;
  double length = 0;                      ///< of a cylinder, and of a capsule's cylindrical part
  std::shared_ptr<const Mesh> mesh = {};  ///< kMesh, which is for visuals only
};

struct CollisionDescription {
  std::string name;
  Pose3 poseInLink = Pose3::Identity();
  Shape shape;
  double friction = 1;
  double restitution = 0;  ///< 0 (no bounce) to 1
};

/// A colour is fixed, or that of the robot's team.
struct VisualDescription {
  std::string name;
  Pose3 poseInLink = Pose3::Identity();
  Shape shape;
  Rgb color;
  std::string colorName;  ///< of a palette; empty: none, or the team's
  bool teamColor = false;
  bool castsShadow = true;
};

struct LinkDescription {
  std::string name;
  Pose3 poseInModel = Pose3::Identity();  ///< with all joints at 0
  double mass = 0;
  Vector3 centerOfMass = Vector3::Zero();                 ///< in the link
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();  ///< about the centre of mass, axes of the link
  double linearDamping = 0, angularDamping = 0;           ///< share of the velocity lost in a second
  std::vector<CollisionDescription> collisions;
  std::vector<VisualDescription> visuals;
};

struct JointDescription {
  std::string name;
  bool fixed = false;  ///< else a hinge
  int parent = -1;     ///< index of a link; -1 is the world
  int child = 0;
  Vector3 anchorInModel = Vector3::Zero();  ///< with all joints at 0
  Vector3 axisInModel = Vector3::UnitZ();
  double lower = 0, upper = 0;
  bool servo = false;  ///< can be requested; else it turns freely
  double maximumSpeed = 0, maximumTorque = 0;
  double initialAngle = 0;
  double positionNoise = 0;  ///< standard deviation, rad
  bool wheel = false;        ///< turned by the model's drive
};

/// Wheels on two sides of a model. Each is a joint whose child has one solid, a cylinder about the joint's
/// axis.
struct DriveDescription {
  std::string name = "drive";
  std::string controller;        ///< the protocol of its microcontroller ("arcos"); empty: it has none
  std::vector<int> left, right;  ///< joints
  double wheelRadius = 0;
  double track = 0;         ///< that the model turns about on firm ground
  double maximumSpeed = 0;  ///< m/s of the rims
  double maximumForce = 0;  ///< N at the rim of each wheel
  double idleForce = 0;     ///< N by which the rim of each wheel resists without power
};

/// Where a sonar or a laser measures; see RangeSensor.
struct RangeGeometry {
  int readings = 1;
  double startAngle = 0, endAngle = 0;
  double openingAngle = 0, mostIncidence = 0;
};

struct SensorDescription {
  enum class Kind : std::uint8_t { kCamera, kDistance, kAccelerometer, kGyroscope, kContact, kSonar, kLaser };
  Kind kind = Kind::kCamera;
  std::string name;
  int link = 0;
  Pose3 poseInLink = Pose3::Identity();
  double noise = 0;                 ///< standard deviation in the reading's unit; cameras: grey values
  double minimum = 0, maximum = 0;  ///< distance: range, m; imus: range of each axis, m/s^2 or rad/s
  int collision = 0;                ///< contact: index in the link's collisions
  int width = 0, height = 0;        ///< camera
  double horizontalAngle = 0, verticalAngle = 0, rate = 0;  ///< camera; rad, Hz
  Vignetting vignetting;                                    ///< camera
  RangeGeometry range;                                      ///< sonar, laser
};

/// Where a robot of a team stands at the start, on a field.
struct HomeDescription {
  std::string team;        ///< empty: of any
  robotlink::Pose2 place;  ///< in the model
};

/// What a model file describes. Parsed once and shared by all models that include it.
struct ModelDescription {
  std::string file;
  std::string name;
  std::string robot;  ///< which resources/robots/<robot>.yaml; empty if the model is no robot
  std::string field;  ///< which resources/fields/<field>.yaml the model shows; empty if it is no field
  bool isStatic = false;
  bool isBall = false;
  std::vector<LinkDescription> links;
  std::vector<JointDescription> joints;
  std::vector<SensorDescription> sensors;
  std::optional<DriveDescription> drive;
  std::vector<HomeDescription> homes;
};

struct ModelInstance {
  std::string name;
  std::shared_ptr<const ModelDescription> type;
  Pose3 poseInWorld = Pose3::Identity();
  std::optional<Rgb> teamColor;
  std::string teamColorName;
  robotlink::FilePosition where;  ///< its <include> or <model>
};

/// A world, checked: every index is valid, every number finite and of a sensible size. A plain value.
struct WorldDescription {
  std::string name;
  Vector3 gravity = {0, 0, -9.81};
  float ambient = 0.4F;
  Rgb background;
  std::vector<Lamp> lamps;
  std::vector<ModelInstance> models;
};

}  // namespace simcore
