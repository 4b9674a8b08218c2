// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/Physics.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "robotlink/base/Random.h"
#include "simcore/physics/Contacts.h"
#include "simcore/physics/FollowingModels.h"
#include "simcore/physics/FreeBodies.h"
#include "simcore/physics/KinematicDrives.h"
#include "simcore/physics/OdeGeoms.h"
#include "simcore/physics/OdeJoints.h"
#include "simcore/physics/OdeRays.h"
#include "simcore/physics/OdeWheels.h"
#include "simcore/physics/OdeWorld.h"
#include "simcore/physics/OdeWorldBuilder.h"
#include "simcore/physics/Sleeping.h"
#include "simcore/physics/threads/OdeRandom.h"

namespace simcore {
namespace {

constexpr int kBlockedSteps = 25;

/// Returns the reaction of a joint on its first body, about a point in the world.
Physics::Wrench wrenchAbout(const Vector3& point, const dJointFeedback& exerted, dBodyID body) {
  const dReal* center = dBodyGetPosition(body);
  const Vector3 arm = Vector3(center[0], center[1], center[2]) - point;
  const Vector3 force(exerted.f1[0], exerted.f1[1], exerted.f1[2]);
  return {force, Vector3(exerted.t1[0], exerted.t1[1], exerted.t1[2]) + arm.cross(force)};
}

}  // namespace

Physics::Physics(const WorldDescription& world, Drives drives, std::shared_ptr<robotlink::ThreadPool> pool)
    : ode_(buildOdeWorld(world, drives == Drives::kKinematic)) {
  ode_->islands = std::make_unique<IslandThreads>(std::move(pool), ode_->world);
}
Physics::~Physics() = default;

void Physics::step(std::uint64_t seed) {
  prepareOdeForThread();
  seedOdeRandom(seed);
  for (OdeGeom* geom : ode_->touchedGeoms) geom->touched = false;
  ode_->touchedGeoms.clear();
  for (OdeModel& model : ode_->models) model.touchesObstacle = false;
  ode_->touches.clear();
  ode_->obstacleTouches.clear();
  ode_->wheelContactCount = 0;
  ode_->contactCount = 0;
  resist(*ode_);
  moveKinematicModels(*ode_);
  moveFollowers(*ode_);
  prepareFreeBodies(*ode_);
  findContacts(*ode_);
  ode_->islands->step(kStepSeconds, static_cast<int>(ode_->hinges.size()) + ode_->contactCount, seed);
  letFreeBodiesRest(*ode_);
  letModelsSleep(*ode_);
  settleFollowers(*ode_);
  settleWheels(*ode_);
  dJointGroupEmpty(ode_->contacts);
}

std::size_t Physics::bodyCount() const {
  return ode_->bodies.size();
}

Pose3 Physics::linkInWorld(std::size_t body) const {
  return ode_->linkPose(body);
}

Vector3 Physics::velocityAt(std::size_t body, const Vector3& point) const {
  dVector3 velocity;
  dBodyGetPointVel(ode_->bodies[body].id, point.x(), point.y(), point.z(), velocity);
  return {velocity[0], velocity[1], velocity[2]};
}

Vector3 Physics::angularVelocityOf(std::size_t body) const {
  const dReal* velocity = dBodyGetAngularVel(ode_->bodies[body].id);
  return {velocity[0], velocity[1], velocity[2]};
}

double Physics::angle(std::size_t hinge) const {
  return jointPosition(*ode_, hinge);
}

double Physics::rate(std::size_t hinge) const {
  return jointRate(ode_->hinges[hinge]);
}

Physics::Wrench Physics::reaction(std::size_t hinge) const {
  const dJointID id = ode_->hinges[hinge];
  return wrenchAbout(jointAnchor(id), ode_->hingeForces[hinge], dJointGetBody(id, 0));
}

Physics::Wrench Physics::fixedReaction(std::size_t joint) const {
  const OdeMeasuredJoint& measured = ode_->measuredJoints[joint];
  if (measured.id == nullptr) return {};
  const dBodyID child = dJointGetBody(measured.id, 0);
  const Vector3 anchor = poseOf(dBodyGetPosition(child), dBodyGetRotation(child)) * measured.anchorInBody;
  return wrenchAbout(anchor, measured.force, child);
}

double Physics::torque(std::size_t hinge) const {
  const dJointID id = ode_->hinges[hinge];
  const Wrench exerted = reaction(hinge);
  return jointAxis(id).dot(dJointGetType(id) == dJointTypeSlider ? exerted.force : exerted.torque);
}

double Physics::motorPower(int model) const {
  const OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  double power = 0;
  for (std::size_t i = entry.firstHinge; i < entry.firstHinge + entry.hingeCount; ++i) {
    if (ode_->hingeHasMotor[i]) power += std::abs(torque(i) * rate(i));
  }
  for (std::size_t i = 0; i < ode_->drives.size(); ++i) {
    if (ode_->drives[i].model == model)
      power += ode_->driveSide(2 * i).power + ode_->driveSide(2 * i + 1).power;
  }
  for (const std::size_t side : ode_->vehicleSides) {
    if (ode_->wheelSides[side].model == model) power += ode_->wheelSides[side].power;
  }
  return power;
}

double Physics::anchorGap(std::size_t hinge) const {
  if (dJointGetType(ode_->hinges[hinge]) != dJointTypeHinge) return 0;
  dVector3 a, b;
  dJointGetHingeAnchor(ode_->hinges[hinge], a);
  dJointGetHingeAnchor2(ode_->hinges[hinge], b);
  return Vector3(a[0] - b[0], a[1] - b[1], a[2] - b[2]).norm();
}

void Physics::setMotor(std::size_t hinge, double velocity, double maximumTorque) {
  wakeIfDrivenOtherwise(*ode_, hinge, velocity, maximumTorque);
  // A sleeping model keeps the values that commands are compared with.
  if (!ode_->models[static_cast<std::size_t>(ode_->hingeModels[hinge])].isAsleep())
    driveJoint(ode_->hinges[hinge], velocity, maximumTorque);
}

void Physics::setGuide(int model, const Vector3& velocity, const Vector3& angularVelocity, double force,
                       double torque) {
  const OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  if (entry.push == nullptr) return;
  constexpr int kVelocities[] = {dParamVel1, dParamVel2, dParamVel3};
  constexpr int kLimits[] = {dParamFMax1, dParamFMax2, dParamFMax3};
  const int axes = dJointGetLMotorNumAxes(entry.push), turns = dJointGetAMotorNumAxes(entry.turn);
  for (int i = 0; i < axes; ++i) {
    dJointSetLMotorParam(entry.push, kVelocities[i], velocity[i]);
    dJointSetLMotorParam(entry.push, kLimits[i], force);
  }
  for (int i = 0; i < turns; ++i) {
    dJointSetAMotorParam(entry.turn, kVelocities[i], angularVelocity[turns == 1 ? 2 : i]);
    dJointSetAMotorParam(entry.turn, kLimits[i], torque);
  }
}

double Physics::massOf(int model) const {
  const OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  double sum = 0;
  for (std::size_t i = entry.firstBody; i < entry.firstBody + entry.bodyCount; ++i) {
    if (!ode_->hasBody(i)) continue;
    dMass mass;
    dBodyGetMass(ode_->bodies[i].id, &mass);
    sum += mass.mass;
  }
  return sum;
}

double Physics::inertiaOf(int model) const {
  const OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  const Vector3 center = firstCenter(model);
  double sum = 0;
  for (std::size_t i = entry.firstBody; i < entry.firstBody + entry.bodyCount; ++i) {
    if (!ode_->hasBody(i)) continue;
    dMass mass;
    dBodyGetMass(ode_->bodies[i].id, &mass);
    const dReal* at = dBodyGetPosition(ode_->bodies[i].id);
    sum += mass.I[0] + mass.I[5] + mass.I[10] +
           mass.mass * (Vector3(at[0], at[1], at[2]) - center).squaredNorm();
  }
  return sum;
}

Vector3 Physics::firstCenter(int model) const {
  const OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  const dReal* at = dBodyGetPosition(ode_->bodies[entry.firstBody].id);
  return {at[0], at[1], at[2]};
}

Vector3 Physics::velocityOfModel(int model) const {
  const OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  return velocityAt(entry.firstBody, modelInWorld(model).translation());
}

Vector3 Physics::turningRateOfModel(int model) const {
  return angularVelocityOf(ode_->models[static_cast<std::size_t>(model)].firstBody);
}

double Physics::rimTarget(std::size_t side) const {
  return ode_->driveSide(side).target;
}

void Physics::setRimSpeed(std::size_t side, double speed) {
  ode_->driveSide(side).target = speed;
}

void Physics::setSideOn(std::size_t side, bool on) {
  ode_->driveSide(side).on = on;
}

Physics::SideState Physics::sideState(std::size_t side) const {
  const OdeWheelSide& one = ode_->driveSide(side);
  return {one.travel, one.speed, one.blockedSteps >= kBlockedSteps};
}

void Physics::copySide(std::size_t side, const Physics& from, std::size_t fromSide) {
  OdeWheelSide& to = ode_->driveSide(side);
  const OdeWheelSide& other = from.ode_->driveSide(fromSide);
  to.target = other.target;
  to.on = other.on;
  to.speed = other.speed;
  to.travel = other.travel;
  to.blockedSteps = other.blockedSteps;
}

void Physics::setWheel(std::size_t wheel, double speed, double force, bool on) {
  OdeWheelSide& side = ode_->wheelSides[ode_->vehicleSides[wheel]];
  side.target = speed;
  side.maximumForce = force;
  side.on = on;
}

Physics::SideState Physics::wheelState(std::size_t wheel) const {
  const OdeWheelSide& one = ode_->wheelSides[ode_->vehicleSides[wheel]];
  return {one.travel, one.speed, one.blockedSteps >= kBlockedSteps};
}

void Physics::follow(int model, double ahead, double sideways, double turning) {
  const int follower = ode_->models[static_cast<std::size_t>(model)].follower;
  if (follower < 0) return;
  OdeFollower& one = ode_->followers[static_cast<std::size_t>(follower)];
  one.ahead = ahead;
  one.sideways = sideways;
  one.turning = turning;
}

std::span<const ObstacleTouch> Physics::obstacleTouches() const {
  return ode_->obstacleTouches;
}

bool Physics::touchesAnything(int model) const {
  return std::ranges::any_of(ode_->touchedGeoms,
                             [&](const OdeGeom* geom) { return geom->touched && geom->model == model; });
}

double Physics::gapBelow(int model) const {
  prepareOdeForThread();
  return std::max(0.0, simcore::gapBelow(*ode_, model));
}

bool Physics::touched(std::size_t body, int collision) const {
  return ode_->geoms[ode_->bodies[body].firstGeom + static_cast<std::size_t>(collision)].touched;
}

bool Physics::touched(int modelA, int modelB) const {
  const std::pair<int, int> pair = std::minmax(modelA, modelB);
  return std::ranges::find(ode_->touches, pair) != ode_->touches.end();
}

bool Physics::touchedObstacle(int model) const {
  return ode_->models[static_cast<std::size_t>(model)].touchesObstacle;
}

double Physics::castRay(const Vector3& origin, const Vector3& direction, double length, int ownModel) const {
  prepareOdeForThread();
  return simcore::castRay(*ode_, origin, direction, length, ownModel);
}

Pose3 Physics::modelInWorld(int model) const {
  const ModelInstance& instance = ode_->description.models[static_cast<std::size_t>(model)];
  const OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  if (entry.bodyCount == 0) return instance.poseInWorld;
  return linkInWorld(entry.firstBody) * instance.type->links.front().poseInModel.inverse();
}

void Physics::moveModel(int model, const Pose3& transform) {
  OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  wake(*ode_, entry);
  ode_->forgetGround(entry);
  for (std::size_t i = entry.firstBody; i < entry.firstBody + entry.bodyCount; ++i) {
    if (!ode_->hasBody(i)) continue;
    const dBodyID body = ode_->bodies[i].id;
    const Pose3 pose = transform * poseOf(dBodyGetPosition(body), dBodyGetRotation(body));
    const Eigen::Quaterniond q(pose.linear());
    const dQuaternion rotation = {q.w(), q.x(), q.y(), q.z()};
    dBodySetPosition(body, pose.translation().x(), pose.translation().y(), pose.translation().z());
    dBodySetQuaternion(body, rotation);
    dBodySetLinearVel(body, 0, 0, 0);
    dBodySetAngularVel(body, 0, 0, 0);
  }
}

std::vector<Physics::BodyMotion> Physics::motionOf(int model) const {
  const OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  std::vector<BodyMotion> motion;
  for (std::size_t i = entry.firstBody; i < entry.firstBody + entry.bodyCount; ++i) {
    if (!ode_->hasBody(i)) continue;
    const dBodyID body = ode_->bodies[i].id;
    const dReal* q = dBodyGetQuaternion(body);
    const auto vector = [](const dReal* values) { return Vector3(values[0], values[1], values[2]); };
    motion.push_back({vector(dBodyGetPosition(body)), vector(dBodyGetLinearVel(body)),
                      vector(dBodyGetAngularVel(body)), Eigen::Quaterniond(q[0], q[1], q[2], q[3]),
                      ode_->bodies[i].centerInLink, i - entry.firstBody});
  }
  return motion;
}

void Physics::setMotion(int model, const std::vector<BodyMotion>& motion) {
  OdeModel& entry = ode_->models[static_cast<std::size_t>(model)];
  wake(*ode_, entry);
  ode_->forgetGround(entry);
  for (BodyMotion was : motion) {
    const std::size_t i = entry.firstBody + was.link;
    if (was.link >= entry.bodyCount || !ode_->hasBody(i)) continue;
    const dBodyID body = ode_->bodies[i].id;
    // The center of mass may have been elsewhere before the parts of the body were changed.
    if (ode_->bodies[i].centerInLink != was.centerInLink) {
      const Vector3 shift = was.rotation * (ode_->bodies[i].centerInLink - was.centerInLink);
      was.position += shift;
      was.velocity += was.angularVelocity.cross(shift);
    }
    const dQuaternion rotation = {was.rotation.w(), was.rotation.x(), was.rotation.y(), was.rotation.z()};
    dBodySetPosition(body, was.position.x(), was.position.y(), was.position.z());
    dBodySetQuaternion(body, rotation);
    dBodySetLinearVel(body, was.velocity.x(), was.velocity.y(), was.velocity.z());
    dBodySetAngularVel(body, was.angularVelocity.x(), was.angularVelocity.y(), was.angularVelocity.z());
  }
}

int Physics::overlappedModel(int model, double tolerance, std::size_t* pairs) const {
  prepareOdeForThread();
  const Overlap overlap = deepestOverlap(*ode_, model, NoteTouches::kNo, tolerance);
  if (pairs != nullptr) *pairs += overlap.pairs;
  return overlap.depth > tolerance ? overlap.model : -1;
}

std::vector<int> Physics::modelsTouching(int model) const {
  prepareOdeForThread();
  return touchingModels(*ode_, model);
}

std::uint64_t Physics::digest() const {
  std::uint64_t hash = 0;
  const auto add = [&](const dReal* values, int count) {
    for (int i = 0; i < count; ++i) hash = robotlink::mixBits(hash ^ std::bit_cast<std::uint64_t>(values[i]));
  };
  for (std::size_t i = 0; i < ode_->bodies.size(); ++i) {
    if (!ode_->hasBody(i)) continue;
    const OdeBody& body = ode_->bodies[i];
    add(dBodyGetPosition(body.id), 3);
    add(dBodyGetQuaternion(body.id), 4);
    add(dBodyGetLinearVel(body.id), 3);
    add(dBodyGetAngularVel(body.id), 3);
  }
  for (const OdeWheelSide& side : ode_->wheelSides) {
    const dReal turned[] = {side.speed, side.travel};
    add(turned, 2);
  }
  return hash;
}

}  // namespace simcore
