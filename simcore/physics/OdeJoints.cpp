// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeJoints.h"

#include <cmath>

namespace simcore {
namespace {

using JointKind = JointDescription::Kind;

/// The joint's bodies in the world: the child, and the parent or null.
struct Ends {
  dBodyID child, parent;
};

dJointID attached(dJointID id, const Ends& ends) {
  dJointAttach(id, ends.child, ends.parent);
  return id;
}

/// Whether a servo turns a joint to a position as fast as it can, rather than by gains.
bool isStiffServo(const JointDescription& joint) {
  return joint.servo && joint.control.kind == MotorControl::Kind::kPosition && !joint.control.usesGains();
}

/// How far the stops of a joint are beyond the range in which its servo turns it, rad and m. ODE lets a motor
/// at a stop exert all of its torque, however little it needs, so that the joint would leap off the stop and
/// fall back forever; within the stops it is a motor that keeps its speed.
double beyondServo(const JointDescription& joint) {
  constexpr double kTurn = 0.01, kWay = 0.001;
  if (!isStiffServo(joint)) return 0;
  return joint.kind == JointKind::kSlider ? kWay : kTurn;
}

template <typename Set>
void setStops(dJointID id, Set set, int low, int high, double lower, double upper) {
  // Set twice, because ODE ignores a lower stop above the upper one.
  set(id, low, lower);
  set(id, high, upper);
  set(id, low, lower);
}

/// Null: the world, which does not turn.
Eigen::Matrix3d rotationOf(dBodyID body) {
  if (body == nullptr) return Eigen::Matrix3d::Identity();
  const dReal* r = dBodyGetRotation(body);
  Eigen::Matrix3d rotation;
  rotation << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  return rotation;
}

OdeHingeZero zeroOf(dJointID hinge, const Vector3& axis) {
  const Vector3 along = axis.normalized(), across = along.unitOrthogonal();
  const Eigen::Matrix3d parent = rotationOf(dJointGetBody(hinge, 1)).transpose();
  return {parent * along, parent * across, rotationOf(dJointGetBody(hinge, 0)).transpose() * across};
}

/// Gives a joint the next number.
void number(OdeWorld& ode, const JointDescription& joint, dJointID id, const Vector3& axis) {
  ode.hinges.push_back(id);
  ode.hingeZeros.push_back(zeroOf(id, axis));
  ode.hingeHasMotor.push_back(joint.servo);
  ode.hingeIsStiff.push_back(isStiffServo(joint));
  dJointSetFeedback(id, &ode.hingeForces.emplace_back());
  ode.restForces.emplace_back();
}

bool isSlider(dJointID joint) {
  return dJointGetType(joint) == dJointTypeSlider;
}

dJointID addHinge(OdeWorld& ode, const JointDescription& joint, const Ends& ends, const Vector3& anchor,
                  const Vector3& axis) {
  const dJointID id = attached(dJointCreateHinge(ode.world, nullptr), ends);
  dJointSetHingeAnchor(id, anchor.x(), anchor.y(), anchor.z());
  dJointSetHingeAxis(id, axis.x(), axis.y(), axis.z());
  const double beyond = beyondServo(joint);
  setStops(id, dJointSetHingeParam, dParamLoStop, dParamHiStop, joint.lower - beyond, joint.upper + beyond);
  number(ode, joint, id, axis);
  return id;
}

dJointID addSlider(OdeWorld& ode, const JointDescription& joint, const Ends& ends, const Vector3& axis) {
  const dJointID id = attached(dJointCreateSlider(ode.world, nullptr), ends);
  dJointSetSliderAxis(id, axis.x(), axis.y(), axis.z());
  const double beyond = beyondServo(joint);
  setStops(id, dJointSetSliderParam, dParamLoStop, dParamHiStop, joint.lower - beyond, joint.upper + beyond);
  number(ode, joint, id, axis);
  return id;
}

dJointID addUniversal(OdeWorld& ode, const JointDescription& joint, const Ends& ends, const Vector3& anchor,
                      const Eigen::Matrix3d& modelInWorld) {
  // ODE's first axis is fixed to the first body, which is the child here; SDFormat's first one to the parent.
  const Vector3 ofChild = modelInWorld * joint.secondAxisInModel, ofParent = modelInWorld * joint.axisInModel;
  const dJointID id = attached(dJointCreateUniversal(ode.world, nullptr), ends);
  dJointSetUniversalAnchor(id, anchor.x(), anchor.y(), anchor.z());
  // ODE complains if the axes are parallel while they are set one after the other; at first, they are x and
  // y.
  const Vector3 between = std::abs(ofParent.z()) < 0.9 ? Vector3::UnitZ() : Vector3::UnitX();
  dJointSetUniversalAxis1(id, between.x(), between.y(), between.z());
  dJointSetUniversalAxis2(id, ofParent.x(), ofParent.y(), ofParent.z());
  dJointSetUniversalAxis1(id, ofChild.x(), ofChild.y(), ofChild.z());
  setStops(id, dJointSetUniversalParam, dParamLoStop1, dParamHiStop1, joint.secondLower, joint.secondUpper);
  setStops(id, dJointSetUniversalParam, dParamLoStop2, dParamHiStop2, joint.lower, joint.upper);
  return id;
}

void addFixed(OdeWorld& ode, const JointDescription& joint, const Ends& ends, const Vector3& anchor) {
  OdeMeasuredJoint* measured = joint.isMeasured ? &ode.measuredJoints.emplace_back() : nullptr;
  // Links that are one body need no joint.
  if (ends.child == ends.parent) return;
  const dJointID id = attached(dJointCreateFixed(ode.world, nullptr), ends);
  dJointSetFixed(id);
  if (measured == nullptr) return;
  measured->id = id;
  measured->anchorInBody =
      poseOf(dBodyGetPosition(ends.child), dBodyGetRotation(ends.child)).inverse() * anchor;
  dJointSetFeedback(id, &measured->force);
}

/// Brakes one axis; `speed` is the present one.
double brake(const OdeResistance& one, double speed) {
  return one.friction + one.damping * std::abs(speed);
}

}  // namespace

void addJoint(OdeWorld& ode, const ModelInstance& model, const JointDescription& joint,
              std::size_t firstBody) {
  if (joint.wheel) return;
  const auto bodyOf = [&](int link) {
    return link < 0 ? nullptr : ode.bodies[firstBody + static_cast<std::size_t>(link)].id;
  };
  const Ends ends{bodyOf(joint.child), bodyOf(joint.parent)};
  const Vector3 anchor = model.poseInWorld * joint.anchorInModel;
  if (joint.kind == JointKind::kFixed) return addFixed(ode, joint, ends, anchor);
  const Vector3 axis = model.poseInWorld.linear() * joint.axisInModel;
  dJointID id = nullptr;
  switch (joint.kind) {
    case JointKind::kFixed:
      return;
    case JointKind::kHinge:
      id = addHinge(ode, joint, ends, anchor, axis);
      break;
    case JointKind::kSlider:
      id = addSlider(ode, joint, ends, axis);
      break;
    case JointKind::kBall:
      id = attached(dJointCreateBall(ode.world, nullptr), ends);
      dJointSetBallAnchor(id, anchor.x(), anchor.y(), anchor.z());
      return;
    case JointKind::kUniversal:
      id = addUniversal(ode, joint, ends, anchor, model.poseInWorld.linear());
      break;
  }
  if (!joint.servo && (joint.damping > 0 || joint.friction > 0))
    ode.resistances.push_back({id, joint.damping, joint.friction});
}

double jointPosition(const OdeWorld& ode, std::size_t hinge) {
  const dJointID joint = ode.hinges[hinge];
  if (isSlider(joint)) return dJointGetSliderPosition(joint);
  const OdeHingeZero& zero = ode.hingeZeros[hinge];
  const Vector3 now =
      rotationOf(dJointGetBody(joint, 1)).transpose() * (rotationOf(dJointGetBody(joint, 0)) * zero.inChild);
  return std::atan2(zero.axisInParent.dot(zero.inParent.cross(now)), zero.inParent.dot(now));
}

double jointRate(dJointID joint) {
  return isSlider(joint) ? dJointGetSliderPositionRate(joint) : dJointGetHingeAngleRate(joint);
}

Vector3 jointAxis(dJointID joint) {
  dVector3 axis;
  isSlider(joint) ? dJointGetSliderAxis(joint, axis) : dJointGetHingeAxis(joint, axis);
  return {axis[0], axis[1], axis[2]};
}

Vector3 jointAnchor(dJointID joint) {
  if (isSlider(joint)) {
    const dReal* center = dBodyGetPosition(dJointGetBody(joint, 0));
    return {center[0], center[1], center[2]};
  }
  dVector3 anchor;
  dJointGetHingeAnchor(joint, anchor);
  return {anchor[0], anchor[1], anchor[2]};
}

void driveJoint(dJointID joint, double speed, double limit) {
  const auto set = isSlider(joint) ? dJointSetSliderParam : dJointSetHingeParam;
  set(joint, dParamVel, speed);
  set(joint, dParamFMax, limit);
}

MotorSetting motorOf(dJointID joint) {
  const auto get = isSlider(joint) ? dJointGetSliderParam : dJointGetHingeParam;
  return {get(joint, dParamVel), get(joint, dParamFMax)};
}

void resist(OdeWorld& ode) {
  for (const OdeResistance& one : ode.resistances) {
    switch (dJointGetType(one.joint)) {
      case dJointTypeHinge:
        dJointSetHingeParam(one.joint, dParamFMax, brake(one, dJointGetHingeAngleRate(one.joint)));
        break;
      case dJointTypeSlider:
        dJointSetSliderParam(one.joint, dParamFMax, brake(one, dJointGetSliderPositionRate(one.joint)));
        break;
      case dJointTypeUniversal:
        dJointSetUniversalParam(one.joint, dParamFMax1, brake(one, dJointGetUniversalAngle1Rate(one.joint)));
        dJointSetUniversalParam(one.joint, dParamFMax2, brake(one, dJointGetUniversalAngle2Rate(one.joint)));
        break;
      default:
        break;
    }
  }
}

}  // namespace simcore
