// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/motion/GaitParameters.h"
#include "modules/motion/LegKinematics.h"
#include "robotlink/base/Clock.h"

namespace modules {

/// A trot by the wheel model: the requested motion of the robot gives each leg a step vector, as if it were a
/// wheel of a vehicle, and each paw runs through a closed curve along its vector; half of the cycle on the
/// ground.
///
/// The model is that of the walking engines of the four-legged teams of 2002. Speeds change by bounded steps,
/// so a request may jump. A pure function of its calls; 8 ms a frame. Paw positions are those of the sphere's
/// centre, metres, in the frame of the robot's body (origin between the J1 axes); the body is pitched if fore
/// and hind height differ.
class WheelModelGait {
 public:
  explicit WheelModelGait(const GaitParameters& parameters, const RobotDimensions& dimensions = {});

  void setParameters(const GaitParameters& parameters) { parameters_ = parameters; }
  const GaitParameters& parameters() const { return parameters_; }
  /// Within what the gait can do; see limited().
  void request(const WalkSpeed& speed) { requested_ = limited(speed); }
  /// Go on walking on the spot if the request is zero, or come to a stand.
  enum class Idle { kStep, kStand };
  void advance(robotlink::Duration frame, Idle idle);
  /// Standing at once, at the beginning of a cycle.
  void reset();

  /// A speed shrunk to the ellipsoid of speeds that the parameters allow, in its direction.
  WalkSpeed limited(const WalkSpeed& speed) const;
  const WalkSpeed& requested() const { return requested_; }
  /// What the robot does now, as far as the model knows.
  const WalkSpeed& speed() const { return speed_; }
  bool standing() const { return standing_; }
  /// In [0, 1).
  double phase() const { return phase_; }
  bool onGround(Leg leg) const;
  robotlink::Vector3 pawInBody(Leg leg) const;
  LegAngles angles(Leg leg) const;
  /// The way of a paw over the ground in one cycle, metres; half of it before and half behind the paw's
  /// place.
  robotlink::Vector3 stepVector(Leg leg) const;

 private:
  robotlink::Vector3 standInHip(Leg leg) const;
  double legPhase(Leg leg) const;
  double pitch() const;
  robotlink::Vector3 pawInHip(Leg leg) const;

  GaitParameters parameters_;
  LegKinematics kinematics_;
  WalkSpeed requested_, speed_;
  double phase_ = 0;
  bool standing_ = true;
};

}  // namespace modules
