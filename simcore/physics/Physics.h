// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simcore/physics/Step.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

struct OdeWorld;

/// The bodies, hinges and contacts of a world in ODE: one world, a collision space for each moving model and
/// one for all static ones, no collisions inside a model. Steps by dWorldQuickStep without ODE's threads.
///
/// Bodies and hinges are numbered through all moving models in order; bodies thus like RenderScene::bodies
/// less one. One thread at a time may use it; several of them may run on several threads. `world` must
/// outlive it.
class Physics {
 public:
  /// Whether models with a drive are moved by forces, or by their odometry.
  enum class Drives : std::uint8_t { kDynamic, kKinematic };

  explicit Physics(const WorldDescription& world, Drives drives = Drives::kDynamic);
  ~Physics();

  /// Moves the world on. `seed` decides in which order the solver takes the constraints.
  void step(std::uint64_t seed);

  std::size_t bodyCount() const;
  Pose3 linkInWorld(std::size_t body) const;
  /// The velocity of a point that is fixed to a body and now at `point` (world).
  Vector3 velocityAt(std::size_t body, const Vector3& point) const;
  Vector3 angularVelocityOf(std::size_t body) const;

  double angle(std::size_t hinge) const;
  double angularVelocity(std::size_t hinge) const;
  /// How far a hinge's two anchors lie apart, m: the solver's drift.
  double anchorGap(std::size_t hinge) const;
  /// Lets a hinge turn at `velocity` as far as `maximumTorque` suffices, until told otherwise.
  void setMotor(std::size_t hinge, double velocity, double maximumTorque);

  /// Wheels are driven by the sides of drives: side 2 i is the left one of the i-th drive, 2 i + 1 its right
  /// one. m/s
  void setRimSpeed(std::size_t side, double speed);
  void setSideOn(std::size_t side, bool on);
  struct SideState {
    double travel = 0, speed = 0;  ///< m and m/s, of the rims
    bool blocked = false;
  };
  SideState sideState(std::size_t side) const;

  /// Whether a collision shape of a body touched anything in the last step.
  bool touched(std::size_t body, int collision) const;
  /// Whether two models touched each other in the last step.
  bool touched(int modelA, int modelB) const;
  /// Whether a model touched anything but a floor in the last step.
  bool touchedObstacle(int model) const;
  /// How far a ray of unit `direction` goes until it hits anything but `ownModel`; `length` if it hits
  /// nothing.
  double castRay(const Vector3& origin, const Vector3& direction, double length, int ownModel) const;

  /// Where a model is: where its first link's frame would be if that link had its place in the model.
  Pose3 modelInWorld(int model) const;
  /// Moves all of a model's bodies by a rigid transform and brings them to rest.
  void moveModel(int model, const Pose3& transform);
  /// The model into which a model sinks more than `tolerance` deep, if any; -1 is none.
  int overlappedModel(int model, double tolerance) const;

  /// A hash over the poses and velocities of all bodies.
  std::uint64_t digest() const;
  OdeWorld& ode() { return *ode_; }

 private:
  std::unique_ptr<OdeWorld> ode_;
};

}  // namespace simcore
