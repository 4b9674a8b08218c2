// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/truth/Bodies.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "simcore/physics/shapes/LumpedLink.h"
#include "tests/TestFolder.h"

namespace simcore::truth {

std::shared_ptr<const Scene> sceneOf(const std::string& contents) {
  const TestFolder folder(TestFolder::Where::kMemory);
  // SDFormat's default is 9.8.
  const bool hasGravity = contents.find("<gravity>") != std::string::npos;
  const std::string gravity = hasGravity ? "" : "<gravity>0 0 -9.81</gravity>";
  const auto scene = Scene::load(folder.write(
      "truth.sdf", "<sdf version='1.9' xmlns:robotcontrol='urn:robotcontrol:sdf'><world name='truth'>" +
                       gravity + contents + "</world></sdf>"));
  if (!scene) ADD_FAILURE() << describe(scene.error());
  return scene ? *scene : nullptr;
}

std::unique_ptr<Simulation> simulationOf(const std::string& contents, SimulationOptions options) {
  const auto scene = sceneOf(contents);
  if (scene == nullptr) throw std::runtime_error("the scene of a test cannot be loaded");
  auto simulation = Simulation::create(scene, options);
  if (!simulation) throw std::runtime_error(simulation.error().text);
  return std::move(*simulation);
}

void advance(Simulation& simulation, double seconds) {
  for (int i = static_cast<int>(std::lround(seconds / kStepSeconds)); i > 0; --i) simulation.step();
}

double read(const Simulation& simulation, const std::string& path, std::size_t channel) {
  const auto values = simulation.read(path);
  if (!values || values->size() <= channel) {
    ADD_FAILURE() << "there is no " << path;
    return std::nan("");
  }
  return (*values)[channel];
}

std::string numbers(const Vector3& vector) {
  return fmt::format("{} {} {}", vector.x(), vector.y(), vector.z());
}

std::string inertial(double mass, const Vector3& moments, const Vector3& center) {
  return fmt::format(
      "<inertial><pose>{} 0 0 0</pose><mass>{}</mass><inertia><ixx>{}</ixx><iyy>{}</iyy><izz>{}</izz>"
      "<ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial>",
      numbers(center), mass, moments.x(), moments.y(), moments.z());
}

std::string box(const Vector3& size) {
  return "<geometry><box><size>" + numbers(size) + "</size></box></geometry>";
}

std::string sphere(double radius) {
  return fmt::format("<geometry><sphere><radius>{}</radius></sphere></geometry>", radius);
}

std::string cylinder(double radius, double length) {
  return fmt::format("<geometry><cylinder><radius>{}</radius><length>{}</length></cylinder></geometry>",
                     radius, length);
}

std::string solid(const std::string& shape, double friction, double restitution) {
  return fmt::format(
      "<collision name='solid'>{}<surface><friction><ode><mu>{}</mu></ode></friction><bounce>"
      "<restitution_coefficient>{}</restitution_coefficient></bounce></surface></collision>",
      shape, friction, restitution);
}

std::string sensor(const std::string& name, const std::string& type, const std::string& pose,
                   const std::string& contents) {
  return "<sensor name='" + name + "' type='" + type + "'><pose>" + pose + "</pose>" + contents + "</sensor>";
}

std::string model(const std::string& name, const std::string& pose, const std::string& inLink,
                  const std::string& inModel) {
  return "<model name='" + name + "'><pose>" + pose + "</pose><link name='body'>" + inLink + "</link>" +
         inModel + "</model>";
}

std::string ground(double slope, double friction, double restitution) {
  return fmt::format(
      "<model name='ground'><static>true</static><pose>0 0 0 0 {} 0</pose><link name='l'>{}</link></model>",
      slope,
      solid("<geometry><plane><normal>0 0 1</normal><size>50 50</size></plane></geometry>", friction,
            restitution));
}

std::string jointToWorld(const std::string& type, const std::string& axis, const std::string& inJoint) {
  return "<joint name='joint' type='" + type + "'><parent>world</parent><child>body</child>" + axis +
         inJoint + "</joint>";
}

Vector3 momentsOfBox(double mass, const Vector3& size) {
  const Vector3 squares = size.cwiseProduct(size);
  return mass / 12 * Vector3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
}

Vector3 momentsOfSphere(double mass, double radius) {
  return Vector3::Constant(0.4 * mass * radius * radius);
}

Vector3 momentsOfCylinder(double mass, double radius, double length) {
  const double across = mass * (3 * radius * radius + length * length) / 12;
  return {across, across, mass * radius * radius / 2};
}

Bodies::Bodies(const std::string& contents) : scene_(sceneOf(contents)) {
  if (scene_ == nullptr) throw std::runtime_error("the scene of a test cannot be loaded");
  physics_ = std::make_unique<Physics>(scene_->contents().world);
}

void Bodies::run(double seconds) {
  for (int i = static_cast<int>(std::lround(seconds / kStepSeconds)); i > 0; --i) step();
}

int Bodies::index(const std::string& name) const {
  const auto& models = scene_->contents().world.models;
  return static_cast<int>(std::ranges::find(models, name, &ModelInstance::name) - models.begin());
}

Physics::BodyMotion Bodies::motion(const std::string& name, std::size_t body) const {
  return physics_->motionOf(index(name)).at(body);
}

void Bodies::throwModel(const std::string& name, const Vector3& velocity, const Vector3& turning) {
  auto motions = physics_->motionOf(index(name));
  for (Physics::BodyMotion& motion : motions) {
    motion.velocity = velocity + turning.cross(motion.position - motions.front().position);
    motion.angularVelocity = turning;
  }
  physics_->setMotion(index(name), motions);
}

Bodies::Sums Bodies::sums() const {
  Sums sums;
  const WorldDescription& world = scene_->contents().world;
  for (std::size_t m = 0; m < world.models.size(); ++m) {
    if (world.models[m].type->isStatic) continue;
    const auto motions = physics_->motionOf(static_cast<int>(m));
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const Physics::BodyMotion& motion = motions[i];
      const ModelDescription& type = *world.models[m].type;
      const LinkDescription link = lumpedLink(type, rigidParts(type), static_cast<int>(motion.link));
      const Eigen::Matrix3d rotation = motion.rotation.toRotationMatrix();
      const Vector3 spin = rotation * link.inertia * rotation.transpose() * motion.angularVelocity;
      sums.momentum += link.mass * motion.velocity;
      sums.angularMomentum += spin + link.mass * motion.position.cross(motion.velocity);
      sums.kinetic += link.mass * motion.velocity.squaredNorm() / 2 + motion.angularVelocity.dot(spin) / 2;
      sums.potential -= link.mass * world.gravity.dot(motion.position);
    }
  }
  return sums;
}

}  // namespace simcore::truth
