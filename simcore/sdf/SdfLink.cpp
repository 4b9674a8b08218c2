// SPDX-License-Identifier: GPL-3.0-or-later
// readLink(), readSensors() and resolvedPose() of SdfConversion.h: links with their shapes and sensors.
#include <algorithm>
#include <cmath>

#include "simcore/sdf/SdfConversion.h"

namespace simcore {
namespace {

constexpr double kSmallest = 1e-5, kLargest = 1000;  // meters
constexpr double kFarAway = 10'000;

Vector3 checkedSize(const ignition::math::Vector3d& size, const sdf::ElementPtr& element,
                    const SdfContext& context) {
  Vector3 result = toEigen(size);
  for (double& edge : result) edge = context.within(edge, kSmallest, kLargest, "a box's edge", element);
  return result;
}

Shape readShape(const sdf::Geometry& geometry, const SdfContext& context) {
  const sdf::ElementPtr element = geometry.Element();
  const auto size = [&](double value, const char* what) {
    return context.within(value, kSmallest, kLargest, what, element);
  };
  Shape shape;
  if (const sdf::Box* box = geometry.BoxShape()) {
    shape.kind = Shape::Kind::kBox;
    shape.size = checkedSize(box->Size(), element, context);
  } else if (const sdf::Sphere* sphere = geometry.SphereShape()) {
    shape.kind = Shape::Kind::kSphere;
    shape.radius = size(sphere->Radius(), "a sphere's radius");
  } else if (const sdf::Cylinder* cylinder = geometry.CylinderShape()) {
    shape.kind = Shape::Kind::kCylinder;
    shape.radius = size(cylinder->Radius(), "a cylinder's radius");
    shape.length = size(cylinder->Length(), "a cylinder's length");
  } else if (const sdf::Capsule* capsule = geometry.CapsuleShape()) {
    shape.kind = Shape::Kind::kCapsule;
    shape.radius = size(capsule->Radius(), "a capsule's radius");
    shape.length = size(capsule->Length(), "a capsule's length");
  } else if (const sdf::Plane* plane = geometry.PlaneShape()) {
    shape.kind = Shape::Kind::kPlane;
    shape.size = {size(plane->Size().X(), "a plane's size"), size(plane->Size().Y(), "a plane's size"), 0};
    if (plane->Normal() != ignition::math::Vector3d::UnitZ) {
      context.fail(element, "scene.plane", "a plane's normal must be 0 0 1: turn it by its pose");
    }
  } else {
    context.fail(element, "scene.geometry",
                 "of shapes, only box, sphere, cylinder, capsule and plane are known");
  }
  return shape;
}

/// Converts a channel of SDFormat's colors, 0 to 1, to a byte.
std::uint8_t channel(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.F, 1.F) * 255));
}

void readColor(const sdf::Visual& visual, VisualDescription& result, const SdfContext& context) {
  const sdf::ElementPtr element = visual.Element();
  if (!element->HasElement("robotcontrol:color")) {
    if (const sdf::Material* material = visual.Material()) {
      const auto diffuse = material->Diffuse();
      result.color = {channel(diffuse.R()), channel(diffuse.G()), channel(diffuse.B())};
    }
    return;
  }
  const auto name = element->Get<std::string>("robotcontrol:color");
  const auto found = context.palette.find(name);
  result.teamColor = name == "team";
  if (found != context.palette.end()) {
    result.color = found->second;
    result.colorName = name;
  }
  if (!result.teamColor && found == context.palette.end()) {
    context.fail(element->GetElement("robotcontrol:color"), "scene.color",
                 "no palette has the color '" + name + "'");
  }
}

VisualDescription readVisual(const sdf::Visual& visual, const SdfContext& context) {
  VisualDescription result;
  result.name = visual.Name();
  result.poseInLink = resolvedPose(visual.SemanticPose(), "", visual.Element(), context);
  result.shape = readShape(*visual.Geom(), context);
  result.castsShadow = visual.CastShadows();
  readColor(visual, result, context);
  return result;
}

/// The descendant of `element` along a path of names; null if there is none.
sdf::ElementPtr descendant(sdf::ElementPtr element, std::initializer_list<const char*> path) {
  for (const char* name : path) {
    if (!element || !element->HasElement(name)) return nullptr;
    element = element->GetElement(name);
  }
  return element;
}

void readSurface(const sdf::ElementPtr& surface, CollisionDescription& result, const SdfContext& context) {
  if (const auto friction = descendant(surface, {"friction", "ode", "mu"})) {
    result.friction = context.within(friction->Get<double>(), 0, 1000, "mu", friction);
  }
  if (const auto bounce = descendant(surface, {"bounce", "restitution_coefficient"})) {
    result.restitution = context.within(bounce->Get<double>(), 0, 1, "restitution_coefficient", bounce);
  }
}

CollisionDescription readCollision(const sdf::Collision& collision, const SdfContext& context) {
  CollisionDescription result;
  const sdf::ElementPtr element = collision.Element();
  result.name = collision.Name();
  result.poseInLink = resolvedPose(collision.SemanticPose(), "", element, context);
  result.shape = readShape(*collision.Geom(), context);
  if (element->HasElement("surface")) readSurface(element->GetElement("surface"), result, context);
  return result;
}

void readInertia(const sdf::Link& link, LinkDescription& result, const SdfContext& context) {
  const auto& inertial = link.Inertial();
  result.mass = context.within(inertial.MassMatrix().Mass(), 1e-6, 1e4, "a mass", link.Element());
  const Pose3 centerInLink = toEigen(inertial.Pose());
  result.centerOfMass = centerInLink.translation();
  const auto moments = inertial.MassMatrix().Moi();
  Eigen::Matrix3d inertia;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      inertia(row, column) = moments(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
    }
  }
  const Eigen::Matrix3d& rotation = centerInLink.linear();
  result.inertia = rotation * inertia * rotation.transpose();
  if (!result.inertia.allFinite() || !result.centerOfMass.allFinite()) {
    context.fail(link.Element(), "scene.inertia", "the inertia of '" + link.Name() + "' is not finite");
    result.inertia.setIdentity();
  }
}

void readCamera(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::Camera& camera = *sensor.CameraSensor();
  const sdf::ElementPtr element = sensor.Element()->GetElement("camera");
  result.kind = SensorDescription::Kind::kCamera;
  result.width = static_cast<int>(context.within(camera.ImageWidth(), 2, 8192, "an image's width", element));
  result.height =
      static_cast<int>(context.within(camera.ImageHeight(), 2, 8192, "an image's height", element));
  result.horizontalAngle =
      context.within(camera.HorizontalFov().Radian(), 0.01, 3, "horizontal_fov", element);
  result.rate = context.within(sensor.UpdateRate(), 0.1, 250, "a camera's update_rate", sensor.Element());
  result.noise = context.within(camera.ImageNoise().StdDev(), 0, 100, "stddev", element);
  result.verticalAngle = 2 * std::atan(std::tan(result.horizontalAngle / 2) * result.height / result.width);
  if (element->HasElement("robotcontrol:vertical_fov")) {
    result.verticalAngle =
        context.within(element->Get<double>("robotcontrol:vertical_fov"), 0.01, 3, "vertical_fov", element);
  }
  const auto share = [&](const char* name) {
    const std::string key = std::string("robotcontrol:") + name;
    return element->HasElement(key) ? context.within(element->Get<double>(key), 0, 1, name, element) : 0.0;
  };
  result.vignetting = {share("vignetting"), share("vignetting_tint")};
}

/// An accelerometer, or a gyroscope if only <angular_velocity> is described.
void readImu(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context) {
  const sdf::Imu& imu = *sensor.ImuSensor();
  const bool turns = descendant(sensor.Element(), {"imu", "angular_velocity"}) != nullptr &&
                     descendant(sensor.Element(), {"imu", "linear_acceleration"}) == nullptr;
  result.kind = turns ? SensorDescription::Kind::kGyroscope : SensorDescription::Kind::kAccelerometer;
  const sdf::Noise& noise = turns ? imu.AngularVelocityXNoise() : imu.LinearAccelerationXNoise();
  result.noise = context.within(noise.StdDev(), 0, 1000, "stddev", sensor.Element());
  result.maximum = 1e6;
  if (sensor.Element()->HasElement("robotcontrol:range")) {
    result.maximum = context.within(sensor.Element()->Get<double>("robotcontrol:range"), 0.01, 1e6, "range",
                                    sensor.Element());
  }
  result.minimum = -result.maximum;
}

void readContact(const sdf::Sensor& sensor, const LinkDescription& link, SensorDescription& result,
                 const SdfContext& context) {
  result.kind = SensorDescription::Kind::kContact;
  const sdf::ElementPtr element = sensor.Element()->GetElement("contact");
  const auto name = element->Get<std::string>("collision");
  const auto found = std::ranges::find(link.collisions, name, &CollisionDescription::name);
  if (found == link.collisions.end()) {
    context.fail(element, "scene.contact", "the link '" + link.name + "' has no collision '" + name + "'");
    return;
  }
  result.collision = static_cast<int>(found - link.collisions.begin());
}

}  // namespace

Pose3 resolvedPose(const sdf::SemanticPose& semantic, const std::string& frame,
                   const sdf::ElementPtr& element, const SdfContext& context) {
  ignition::math::Pose3d pose;
  context.take(semantic.Resolve(pose, frame), element);
  if (pose.Pos().IsFinite() && pose.Pos().Length() <= kFarAway && pose.Rot().IsFinite()) return toEigen(pose);
  context.fail(element, "scene.pose", "a pose must be finite and at most 10 km away");
  return Pose3::Identity();
}

LinkDescription readLink(const sdf::Link& link, const SdfContext& context) {
  LinkDescription result;
  result.name = link.Name();
  result.poseInModel = resolvedPose(link.SemanticPose(), "__model__", link.Element(), context);
  readInertia(link, result, context);
  if (link.Element()->HasElement("velocity_decay")) {
    const sdf::ElementPtr decay = link.Element()->GetElement("velocity_decay");
    result.linearDamping = context.within(decay->Get<double>("linear"), 0, 100, "linear", decay);
    result.angularDamping = context.within(decay->Get<double>("angular"), 0, 100, "angular", decay);
  }
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i) {
    result.collisions.push_back(readCollision(*link.CollisionByIndex(i), context));
  }
  for (std::uint64_t i = 0; i < link.VisualCount(); ++i) {
    result.visuals.push_back(readVisual(*link.VisualByIndex(i), context));
  }
  return result;
}

void readSensors(const sdf::Link& link, int linkIndex, ModelDescription& model, const SdfContext& context) {
  for (std::uint64_t i = 0; i < link.SensorCount(); ++i) {
    const sdf::Sensor& sensor = *link.SensorByIndex(i);
    SensorDescription result;
    result.name = sensor.Name();
    result.link = linkIndex;
    result.poseInLink = resolvedPose(sensor.SemanticPose(), "", sensor.Element(), context);
    if (sensor.CameraSensor() != nullptr) {
      readCamera(sensor, result, context);
    } else if (sensor.LidarSensor() != nullptr) {
      readLidar(sensor, result, context);
    } else if (sensor.Type() == sdf::SensorType::SONAR) {
      readSonar(sensor, result, context);
    } else if (sensor.ImuSensor() != nullptr) {
      readImu(sensor, result, context);
    } else if (sensor.Type() == sdf::SensorType::CONTACT) {
      readContact(sensor, model.links[static_cast<std::size_t>(linkIndex)], result, context);
    } else {
      context.fail(
          sensor.Element(), "scene.sensor",
          "of sensors, only camera, lidar, sonar, imu and contact are known, not '" + sensor.TypeStr() + "'");
    }
    model.sensors.push_back(result);
  }
}

}  // namespace simcore
