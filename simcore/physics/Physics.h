// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simcore/physics/Step.h"
#include "simcore/world/WorldDescription.h"

namespace robotlink {
class ThreadPool;
}

namespace simcore {

struct OdeWorld;

/// The dynamics of a world, computed by ODE: bodies, hinges and contacts. There is a collision space for each
/// moving model and one for static solids (in large worlds a StaticGrid), and no collisions within a model.
/// Steps use dWorldQuickStep without ODE's threads; see IslandThreads for ours.
///
/// Bodies and hinges (with them sliders, which move in m instead of rad) are numbered through all moving
/// models in order; RenderScene::bodies has the same order
/// after its body 0, the world. One thread at a time may use an object; several objects may be used in
/// several threads. `world` must outlive it. SI units, in the world's frame.
class Physics {
 public:
  /// Whether models with a drive are moved by forces or follow their odometry.
  enum class Drives : std::uint8_t { kDynamic, kKinematic };

  /// With a pool its threads step what cannot touch, with the same results.
  explicit Physics(const WorldDescription& world, Drives drives = Drives::kDynamic,
                   std::shared_ptr<robotlink::ThreadPool> pool = nullptr);
  ~Physics();

  /// Advances by kStepSeconds. `seed` determines the order in which the solver processes constraints.
  void step(std::uint64_t seed);

  std::size_t bodyCount() const;
  /// The pose of a link.
  Pose3 linkInWorld(std::size_t body) const;
  /// The velocity of the point of a body that is now at `point` (in the world).
  Vector3 velocityAt(std::size_t body, const Vector3& point) const;
  Vector3 angularVelocityOf(std::size_t body) const;

  /// rad; of a slider m, as everywhere here.
  double angle(std::size_t hinge) const;
  /// The torque about its axis with which the hinge's motor (and its stops) turned the hinge in the last
  /// step, N m; of a slider the force along it, N; 0 before the first.
  double torque(std::size_t hinge) const;
  /// How fast it turns, rad/s.
  double rate(std::size_t hinge) const;
  /// What the joint exerted on its child in the last step, about its anchor, in the world; N and N m.
  struct Wrench {
    Vector3 force = Vector3::Zero(), torque = Vector3::Zero();
  };
  Wrench reaction(std::size_t hinge) const;
  /// The mechanical power of all motors of a model in the last step, W; braking counts as driving.
  double motorPower(int model) const;
  /// The distance between a hinge's two anchors, m: the drift of the solver; 0 for a slider.
  double anchorGap(std::size_t hinge) const;
  /// Makes a hinge turn at `velocity` (rad/s) with at most `maximumTorque` (N m), until it is called again.
  void setMotor(std::size_t hinge, double velocity, double maximumTorque);

  /// Sets the speed of a side's rims, m/s. Side 2 i is the left one of drive i, 2 i + 1 the right one.
  void setRimSpeed(std::size_t side, double speed);
  /// Switches the power of a side's motors.
  void setSideOn(std::size_t side, bool on);
  /// The encoders of a side.
  struct SideState {
    /// Travel and speed of the rims, m and m/s.
    double travel = 0, speed = 0;
    /// At the force limit, hardly turning for at least 0.1 s.
    bool blocked = false;
  };
  SideState sideState(std::size_t side) const;
  /// What setRimSpeed() set.
  double rimTarget(std::size_t side) const;

  /// Pushes a guided model (ModelDescription::guided) from the next step on so that its first body has these
  /// velocities in the world; in the plane only the first two and the last one count. `force` and `torque`
  /// limit the push along and about each axis, N and N m.
  void setGuide(int model, const Vector3& velocity, const Vector3& angularVelocity, double force,
                double torque);
  /// The mass of all bodies of a model, kg, and an upper bound of its moments of inertia about the center of
  /// its first body, kg m^2.
  double massOf(int model) const;
  double inertiaOf(int model) const;
  /// The center of mass of a model's first body, and the velocity of the model's origin, in the world.
  Vector3 firstCenter(int model) const;
  Vector3 velocityOfModel(int model) const;
  /// The turning rate of its first body, in the world, rad/s.
  Vector3 turningRateOfModel(int model) const;
  /// Lets a side turn as one of another world does: its speed and travel, and what was requested of it.
  void copySide(std::size_t side, const Physics& from, std::size_t fromSide);

  /// Whether a collision shape of a body touched anything in the last step.
  bool touched(std::size_t body, int collision) const;
  /// Whether two moving models touched each other in the last step.
  bool touched(int modelA, int modelB) const;
  /// Whether a model touched anything but a floor in the last step.
  bool touchedObstacle(int model) const;
  /// The distance along a ray of unit `direction` to the first solid that is not part of `ownModel`; `length`
  /// if there is none.
  double castRay(const Vector3& origin, const Vector3& direction, double length, int ownModel) const;

  /// The pose of a model: that of its first link, minus that link's initial pose in the model.
  Pose3 modelInWorld(int model) const;
  /// Moves all bodies of a model by a rigid transform and brings them to rest.
  void moveModel(int model, const Pose3& transform);
  /// How a body stands and moves, in the world.
  struct BodyMotion {
    Vector3 position, velocity, angularVelocity;
    Eigen::Quaterniond rotation;
  };
  /// How all bodies of a model stand and move, so that setMotion() can undo a moveModel().
  std::vector<BodyMotion> motionOf(int model) const;
  void setMotion(int model, const std::vector<BodyMotion>& motion);
  /// A model that this one overlaps by more than `tolerance`, m; -1 if there is none.
  int overlappedModel(int model, double tolerance) const;

  /// The models, in ascending order, that a moving model touches at its present pose; costs a search.
  std::vector<int> modelsTouching(int model) const;

  /// A hash of the poses and velocities of all bodies.
  std::uint64_t digest() const;
  /// Only for tests and benchmarks.
  OdeWorld& ode() { return *ode_; }

 private:
  std::unique_ptr<OdeWorld> ode_;
};

}  // namespace simcore
