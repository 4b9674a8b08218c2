// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"
#include "simcore/physics/Physics.h"

namespace simcore::truth {

inline constexpr double kGravity = 9.81;

/// The scene of a world with these contents; fails the test, and returns null, if it cannot be loaded.
std::shared_ptr<const Scene> sceneOf(const std::string& contents);
/// A simulation of such a world, without noise unless `options` ask for it.
std::unique_ptr<Simulation> simulationOf(const std::string& contents,
                                         SimulationOptions options = {.seed = 1, .noise = false});
void advance(Simulation& simulation, double seconds);
/// A reading; fails the test if there is no such port.
double read(const Simulation& simulation, const std::string& path, std::size_t channel = 0);

// Pieces of SDFormat.
/// Numbers with spaces between them.
std::string numbers(const Vector3& vector);
std::string inertial(double mass, const Vector3& moments, const Vector3& center = Vector3::Zero());
std::string box(const Vector3& size);
std::string sphere(double radius);
std::string cylinder(double radius, double length);
/// A collision of a shape with friction and restitution.
std::string solid(const std::string& shape, double friction = 1, double restitution = 0);
/// A sensor; the last is what it contains.
std::string sensor(const std::string& name, const std::string& type, const std::string& pose = "0 0 0 0 0 0",
                   const std::string& contents = "");
inline std::string sensorWith(const std::string& name, const std::string& type,
                              const std::string& contents = "") {
  return sensor(name, type, "0 0 0 0 0 0", contents);
}
inline std::string customSensor(const std::string& name, const std::string& contents) {
  return sensorWith(name, "custom", contents);
}
/// A model with one link, "body".
std::string model(const std::string& name, const std::string& pose, const std::string& inLink,
                  const std::string& inModel = "");
/// A static plane through the origin that falls towards +x by an angle, rad.
std::string ground(double slope = 0, double friction = 1, double restitution = 0);
/// A joint of `body` to the world.
std::string jointToWorld(const std::string& type, const std::string& axis, const std::string& inJoint = "");

// Moments of inertia of homogeneous bodies about their center of mass, kg m^2.
Vector3 momentsOfBox(double mass, const Vector3& size);
Vector3 momentsOfSphere(double mass, double radius);
/// About x, y and its axis z.
Vector3 momentsOfCylinder(double mass, double radius, double length);

/// The physics of a world alone, whose bodies can be thrown.
class Bodies {
 public:
  explicit Bodies(const std::string& contents);
  Physics& physics() { return *physics_; }
  void step() { physics_->step(static_cast<std::uint64_t>(++steps_)); }
  void run(double seconds);
  double time() const { return steps_ * kStepSeconds; }
  /// How the center of mass of a model's body stands and moves.
  Physics::BodyMotion motion(const std::string& name, std::size_t body = 0) const;
  /// Gives all bodies of a model these velocities, in the world.
  void throwModel(const std::string& name, const Vector3& velocity, const Vector3& turning = Vector3::Zero());
  /// Sums over all moving bodies: momentum, angular momentum about the world's origin, kinetic energy, and
  /// potential energy in the scene's gravity.
  struct Sums {
    Vector3 momentum = Vector3::Zero(), angularMomentum = Vector3::Zero();
    double kinetic = 0, potential = 0;
    double energy() const { return kinetic + potential; }
  };
  Sums sums() const;

 private:
  int index(const std::string& name) const;

  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<Physics> physics_;
  int steps_ = 0;
};

}  // namespace simcore::truth
