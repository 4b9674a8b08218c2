// SPDX-License-Identifier: GPL-3.0-or-later
// Driven wheels in ODE; for Physics and what belongs to it only.
//
// A wheel is no body of its own. Its mass is lumped into the body that carries it, and where it touches, the
// contact itself drives: the tread moves with the wheels' speed along the rolling direction, with a force
// that the side's motors limit. So a robot with four wheels is one body with four contacts instead of five
// bodies with four hinges, which costs a third and needs fewer iterations.
//
// Grip is Coulomb's: a tyre that slides is pulled against the direction in which it slides, by friction times
// load. ODE's own friction limits the two directions apart; with it, wheels that turn on the spot would roll
// without sliding and scrub sideways, and the robot would turn about the distance of its wheels. Here each
// direction's force is proportional to its share of the slip, by a factor that the slip of the last step
// gives (ODE's force-dependent slip, solved implicitly).
//
// What a skid-steered robot turns about follows. Let its wheels be at (+-a, +-b), s the slip of their treads
// and k the ratio of slip along to slip across at equal force. Turning on the spot at w, tyres slide by w a
// across and s along; the forces balance if s b = k w a^2, so rims run at w b + s, and the track is 2 (b + k
// a^2 / b). k is chosen so that this is the model's track.
#pragma once

#include <ode/ode.h>

#include <deque>
#include <vector>

#include "simcore/WorldDescription.h"
#include "simcore/physics/Footprint.h"

namespace simcore {

struct OdeWorld;
struct OdeGeom;

/// The wheels on one side of a drive: belts let them turn alike.
struct OdeWheelSide {
  std::size_t firstWheel = 0, wheelCount = 0;  ///< of OdeWorld::wheels
  double maximumForce = 0, idleForce = 0;      ///< N, of all its rims
  double target = 0;                           ///< m/s
  bool on = true;
  double speed = 0, travel = 0;  ///< of the rims, m/s and m
  int blockedSteps = 0;          ///< for how many steps it has been at its limit and hardly turned
};

struct OdeWheel {
  std::size_t body = 0;                   ///< that carries it, of OdeWorld::bodies
  std::size_t side = 0;                   ///< of OdeWorld::wheelSides
  Pose3 linkInBody = Pose3::Identity();   ///< at angle 0; in ODE's body, whose origin is its centre of mass
  Vector3 axisInBody = Vector3::UnitY();  ///< forwards is right-handed about it
  Vector3 axisInLink = Vector3::UnitY();
  Vector3 centerInLink = Vector3::Zero();  ///< of its cylinder, about which the link turns
  double radius = 0;
  double slipRatio = 1;  ///< of slip along to slip across at equal force
  double restLoad = 0;   ///< N that it carries if all wheels carry alike
  double load = 0;       ///< N that it carries
};

/// Where a wheel touched in this step.
struct OdeWheelContact {
  std::size_t wheel = 0;
  dBodyID other = nullptr;
  Vector3 point, normal, forward;
  double slipPerForce = 0;  ///< m/s per N, along
  double traction = 0;      ///< N, what the ground would take
  double limit = 0;         ///< N, what the motors give it
  dJointFeedback feedback{};
};

/// Wheels on two sides of a model.
struct OdeDrive {
  int model = 0;
  std::size_t body = 0;  ///< that carries the wheels, of OdeWorld::bodies
  double track = 0;
  Vector3 centerInBody = Vector3::Zero();  ///< between the wheels
  Vector3 axisInBody = Vector3::UnitY();   ///< of the axles, to the left
  double radius = 0;  ///< of a circle about the centre that holds the model, seen from above
  // Of a model that is moved by its odometry:
  std::size_t place = 0;               ///< of OdeWorld::places
  Footprint footprint;                 ///< seen from its centre, x to the front
  bool touches = false;                ///< something, where it is
  robotlink::Vector2 freeAt = {0, 0};  ///< where it was last looked how far away obstacles are
  double freeWay = 0;                  ///< and how far it can go from there
};

/// Whether it is only its flank by which a wheel touches something: a wheel is a sphere to ODE.
bool isFlank(const OdeWorld& ode, const OdeGeom& wheel, const dContactGeom& contact);
/// Adds the contact of a wheel's geom with another one, to which its flank is not turned.
void addWheelContact(OdeWorld& ode, const OdeGeom& wheel, const OdeGeom& other, const dContactGeom& contact);
/// After ODE's step: loads, speeds and travels of all wheels by what their contacts carried.
void settleWheels(OdeWorld& ode);
/// The link of a wheel that has rolled as far as its side has.
Pose3 wheelLinkPose(const OdeWorld& ode, const OdeWheel& wheel);

}  // namespace simcore
