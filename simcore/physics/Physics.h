// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "simcore/physics/ObstacleTouch.h"
#include "simcore/physics/Step.h"
#include "simcore/world/WorldDescription.h"

namespace robotlink {
class ThreadPool;
}

namespace simcore {

class StateStream;
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
  /// The reaction of a joint on its child in the last step, about its anchor, in the world; N and N m.
  struct Wrench {
    Vector3 force = Vector3::Zero(), torque = Vector3::Zero();
  };
  Wrench reaction(std::size_t hinge) const;
  /// The same of a fixed joint, by its number among those that are measured.
  Wrench fixedReaction(std::size_t joint) const;
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
    /// Whether it is at the force limit, hardly turning for at least 0.1 s.
    bool blocked = false;
  };
  SideState sideState(std::size_t side) const;
  /// Returns the speed set by setRimSpeed().
  double rimTarget(std::size_t side) const;

  /// Commands a wheel of a vehicle, numbered through all vehicles: the speed of its rim, m/s, and the most
  /// force there, N; without power it only resists.
  void setWheel(std::size_t wheel, double speed, double force, bool on);
  SideState wheelState(std::size_t wheel) const;
  /// Moves a model that follows (ModelInstance::follows()) from the next step on: m/s along its own axes,
  /// rad/s.
  void follow(int model, double ahead, double sideways, double turning);

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
  /// The bodies that touched anything but a floor in the last step, some of them several times; valid until
  /// the next one.
  std::span<const ObstacleTouch> obstacleTouches() const;
  /// Whether a model touched anything in the last step.
  bool touchesAnything(int model) const;
  /// How far a moving model is above what is below it, m; more than in any world if that is nothing.
  double gapBelow(int model) const;
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
  /// How the center of mass of a rigid body stands and moves, in the world.
  struct BodyMotion {
    Vector3 position, velocity, angularVelocity;
    Eigen::Quaterniond rotation;
    /// The center of mass in the frame of the body's first link, and the number of this link in its model.
    Vector3 centerInLink = Vector3::Zero();
    std::size_t link = 0;
  };
  /// How all rigid bodies of a model stand and move, so that setMotion() can undo a moveModel(). Links that
  /// fixed joints connect are one body.
  std::vector<BodyMotion> motionOf(int model) const;
  void setMotion(int model, const std::vector<BodyMotion>& motion);
  /// Whether a model rests, so that it is not computed until something touches or moves it; see Sleeping.h.
  bool isAsleep(int model) const;
  /// Turns off that forces move a body, which stands still then, or turns it on again.
  void setPinned(std::size_t body, bool pinned);
  bool isPinned(std::size_t body) const;
  /// Whether forces move a model at all: it is not static and does not follow its odometry.
  bool isMovedByForces(int model) const;
  /// Gives all bodies of a model the velocities of a rigid piece about their center of mass; what is pinned
  /// stays.
  void throwModel(int model, const Vector3& velocity, const Vector3& rate);
  /// Pushes a body during the next step at a point, both in the world, N and m.
  void addForce(std::size_t body, const Vector3& force, const Vector3& point);
  /// How hard a body is to move at a point (in the world), kg: at most its mass, and less far from its
  /// center.
  double massAt(std::size_t body, const Vector3& point) const;
  /// The bodies of a model: the first one and how many there are; wheels are among them.
  std::pair<std::size_t, std::size_t> bodiesOf(int model) const;
  /// A driven wheel, or a link that is fixed to an earlier one, has no body of its own: that of the link that
  /// carries it. Otherwise `body`.
  std::size_t carrierOf(std::size_t body) const;

  /// Whether the forces of contacts are measured, from the next step on; they cost some time.
  void readContacts(bool on);
  /// A contact of the last step between two collision shapes.
  struct Contact {
    int firstModel = 0, secondModel = 0;
    /// Bodies, or unset of static models.
    std::optional<std::size_t> firstBody, secondBody;
    Vector3 point = Vector3::Zero();
    /// A unit vector toward the first.
    Vector3 normal = Vector3::Zero();
    double depth = 0;
    /// The force on the first, N.
    Vector3 force = Vector3::Zero();
  };
  std::vector<Contact> contacts() const;
  /// Returns the point of reference of a hinge's reaction, in the world.
  Vector3 anchorOf(std::size_t hinge) const;

  /// Writes or reads everything on which later steps and readings depend.
  void transfer(StateStream& stream);

  /// A model that this one overlaps by more than `tolerance`, m; -1 if there is none. With how many pairs of
  /// solids it overlaps any is added to `pairs`.
  int overlappedModel(int model, double tolerance, std::size_t* pairs = nullptr) const;

  /// The models, in ascending order, that a moving model touches at its present pose; costs a search.
  std::vector<int> modelsTouching(int model) const;

  /// A hash of the poses and velocities of all bodies.
  std::uint64_t digest() const;
  /// Only for tests and benchmarks.
  OdeWorld& ode() { return *ode_; }

 private:
  void transferTouches(StateStream& stream);
  void wakeBody(std::size_t body);

  std::unique_ptr<OdeWorld> ode_;
};

}  // namespace simcore
