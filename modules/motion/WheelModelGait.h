// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/motion/GaitParameters.h"
#include "modules/motion/Legs.h"
#include "robotlink/base/Clock.h"

namespace modules {

/// A trot by the wheel model: the requested motion of the robot gives each leg a step vector, as if it were
/// the wheel of a vehicle, and each paw follows a closed curve along its vector, half of the cycle on the
/// ground.
///
/// The model is that of the walking engines of the four-legged teams of 2002. Changes of speed are limited,
/// so requests may jump. The result depends only on the calls; frames have 8 ms. Paw positions are those of
/// the sphere's center in meters in the body's frame (origin between the J1 axes); the body is pitched if
/// fore and hind height differ. Not thread-safe.
class WheelModelGait {
 public:
  explicit WheelModelGait(const GaitParameters& parameters, const RobotDimensions& dimensions = {});

  /// Takes effect with the next frame.
  void setParameters(const GaitParameters& parameters) { parameters_ = parameters; }
  const GaitParameters& parameters() const { return parameters_; }
  /// Requests a speed, limited to what the gait can do: see limited().
  void request(const WalkSpeed& speed) { requested_ = limited(speed); }
  /// Whether to step on the spot if the request is zero, or to stand.
  enum class Idle { kStep, kStand };
  /// Advances by a frame.
  void advance(robotlink::Duration frame, Idle idle);
  /// Stands immediately, at the beginning of a cycle.
  void reset();

  /// Scales a speed to the ellipsoid of allowed speeds, keeping its direction.
  WalkSpeed limited(const WalkSpeed& speed) const;
  const WalkSpeed& requested() const { return requested_; }
  /// The present speed of the robot according to the model.
  const WalkSpeed& speed() const { return speed_; }
  bool standing() const { return standing_; }
  /// Whether all paws are on the ground: the robot stands, or a step of the trot has just ended.
  bool betweenSteps() const { return standing_ || betweenSteps_; }
  /// The phase of the cycle, in [0, 1).
  double phase() const { return phase_; }
  // State of a leg in the present frame.
  bool onGround(Leg leg) const;
  robotlink::Vector3 pawInBody(Leg leg) const;
  LegAngles angles(Leg leg) const;
  /// The travel of a paw over the ground in a cycle, m; one half in front of and one half behind the paw's
  /// neutral position.
  robotlink::Vector3 stepVector(Leg leg) const;

 private:
  /// The neutral position of a paw.
  robotlink::Vector3 standInHip(Leg leg) const;
  /// The phase of a leg, in [0, 1).
  double legPhase(Leg leg) const;
  /// The pitch of the body that follows from the heights of the legs, rad, nose down.
  double pitch() const;
  /// The present position of a paw.
  robotlink::Vector3 pawInHip(Leg leg) const;

  GaitParameters parameters_;
  LegKinematics kinematics_;
  WalkSpeed requested_, speed_;
  double phase_ = 0;
  bool standing_ = true;
  bool betweenSteps_ = false;
};

}  // namespace modules
