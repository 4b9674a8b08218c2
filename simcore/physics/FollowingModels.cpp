// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/FollowingModels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simcore/physics/Contacts.h"
#include "simcore/physics/OdeGeoms.h"
#include "simcore/physics/OdeJoints.h"
#include "simcore/physics/OdeRays.h"
#include "simcore/physics/Step.h"
#include "simcore/world/ModelGeometry.h"

namespace simcore {

using robotlink::Pose2;

namespace {

// In m: sinking in less than that is only touching; overlaps that differ less are the same.
constexpr double kTouching = 0.0005, kSameDepth = 1e-9;

using Overlaps = std::vector<OverlappingPair>;

double depthOf(const OverlappingPair& pair, const Overlaps& in) {
  const auto same = std::ranges::find_if(in, [&](const OverlappingPair& other) {
    return (other.first == pair.first && other.second == pair.second) ||
           (other.first == pair.second && other.second == pair.first);
  });
  return same == in.end() ? 0 : same->depth;
}

/// The deepest overlap that is not the same among others.
double deepestChange(const Overlaps& pairs, const Overlaps& others) {
  double deepest = 0;
  for (const OverlappingPair& pair : pairs) {
    if (pair.depth > deepest && std::abs(pair.depth - depthOf(pair, others)) > kSameDepth)
      deepest = pair.depth;
  }
  return deepest;
}

/// A step of a following model.
class FollowerStep {
 public:
  FollowerStep(OdeWorld& ode, OdeFollower& follower)
      : ode_(ode),
        follower_(follower),
        model_(ode.models[static_cast<std::size_t>(follower.model)]),
        type_(*ode.description.models[static_cast<std::size_t>(follower.model)].type) {}

  void move() {
    if (!follower_.known) learn();
    const std::vector<Pose3> before = bodies();
    const std::vector<double> joints = follower_.joints;
    turnJoints();
    const Pose2 from = follower_.place;
    follower_.place = next();
    stand();
    const Overlaps there = pairsInWay(ode_, follower_);
    follower_.stopped = false;
    // A touch would push what can be moved.
    const double harmless = follower_.pushes ? kTouching : 0;
    if (std::ranges::any_of(there, [&](const auto& pair) { return pair.depth > harmless; })) {
      noteTouches(ode_, there);
      stopOr(from, joints, there, harmless);
    }
    turnWheels();
    setVelocities(before);
  }

  /// Puts its bodies in their places.
  void pose() const {
    for (std::size_t i = 0; i < type_.links.size(); ++i) {
      const OdeBody& body = ode_.bodies[model_.firstBody + i];
      if (!ode_.hasBody(model_.firstBody + i)) continue;
      const Pose3& link = follower_.links[i];
      const Vector3 center = link * body.centerInLink;
      withOdePose(link, [&](const dReal*, const dMatrix3 r) {
        dBodySetPosition(body.id, center.x(), center.y(), center.z());
        dBodySetRotation(body.id, r);
      });
    }
  }

 private:
  void learn() {
    if (follower_.travels) comeDown(ode_, follower_.model);
    const Pose3 model = ode_.linkPose(model_.firstBody) * type_.links.front().poseInModel.inverse();
    follower_.place = robotlink::groundPose(model);
    follower_.lean =
        Eigen::AngleAxisd(-follower_.place.heading, Vector3::UnitZ()).toRotationMatrix() * model.linear();
    follower_.height = model.translation().z();
    std::size_t hinge = model_.firstHinge;
    follower_.joints.assign(type_.joints.size(), 0);
    for (std::size_t i = 0; i < type_.joints.size(); ++i) {
      if (type_.joints[i].hasPosition()) follower_.joints[i] = jointPosition(ode_, hinge++);
    }
    follower_.ground = lowest();
    follower_.known = true;
  }

  double lowest() const {
    dReal bounds[6];
    dGeomGetAABB(reinterpret_cast<dGeomID>(model_.space), bounds);
    return bounds[4];
  }

  std::vector<Pose3> bodies() const {
    std::vector<Pose3> poses;
    for (std::size_t i = 0; i < type_.links.size(); ++i) {
      const dBodyID body = ode_.bodies[model_.firstBody + i].id;
      poses.push_back(poseOf(dBodyGetPosition(body), dBodyGetRotation(body)));
    }
    return poses;
  }

  /// Servos move exactly as fast as they try to.
  void turnJoints() {
    std::size_t hinge = model_.firstHinge;
    for (std::size_t i = 0; i < type_.joints.size(); ++i) {
      const JointDescription& joint = type_.joints[i];
      if (!joint.hasPosition()) continue;
      const MotorSetting motor = motorOf(ode_.hinges[hinge++]);
      if (motor.limit <= 0) continue;
      const double turned = follower_.joints[i] + motor.speed * kStepSeconds;
      follower_.joints[i] = std::clamp(turned, joint.lower, joint.upper);
    }
  }

  Pose2 next() const {
    const double turn = follower_.turning * kStepSeconds;
    const robotlink::Vector2 way =
        Eigen::Rotation2Dd(turn / 2) *
        robotlink::Vector2(follower_.ahead * kStepSeconds, follower_.sideways * kStepSeconds);
    return follower_.place * Pose2{way.x(), way.y(), turn};
  }

  /// Poses all links for the present place and joints; a traveling model's lowest solid is on the ground.
  void stand() {
    Pose3 model = Pose3::Identity();
    model.translation() = Vector3(follower_.place.x, follower_.place.y, follower_.height);
    model.linear() =
        Eigen::AngleAxisd(follower_.place.heading, Vector3::UnitZ()).toRotationMatrix() * follower_.lean;
    follower_.links = linksAt(type_, follower_.joints);
    for (Pose3& link : follower_.links) link = model * link;
    pose();
    if (!follower_.travels) return;
    const double up = follower_.ground - lowest();
    follower_.height += up;
    for (Pose3& link : follower_.links) link.translation().z() += up;
    pose();
  }

  /// Stays at `from` unless the model is deeper in something there than `there`, where it would go. What
  /// overlaps in the same way at both does not count: it may be at rest in something. Of what does not
  /// travel, the joints stay.
  void stopOr(const Pose2& from, std::vector<double> joints, const Overlaps& there, double harmless) {
    const Pose2 to = std::exchange(follower_.place, from);
    if (!follower_.travels) follower_.joints.swap(joints);
    stand();
    const Overlaps here = pairsInWay(ode_, follower_);
    follower_.stopped = deepestChange(there, here) > std::max(harmless, deepestChange(here, there));
    if (follower_.stopped) return;
    follower_.place = to;
    if (!follower_.travels) follower_.joints.swap(joints);
    stand();
  }

  void turnWheels() {
    for (OdeWheelSide& side : ode_.wheelSides) {
      if (side.model != follower_.model) continue;
      side.speed = follower_.stopped ? 0 : side.target;
      side.travel += side.speed * kStepSeconds;
    }
  }

  void setVelocities(const std::vector<Pose3>& before) const {
    const std::vector<Pose3> after = bodies();
    for (std::size_t i = 0; i < type_.links.size(); ++i) {
      const OdeBody& body = ode_.bodies[model_.firstBody + i];
      if (!ode_.hasBody(model_.firstBody + i)) continue;
      const Vector3 velocity = (after[i].translation() - before[i].translation()) / kStepSeconds;
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(after[i].linear() * before[i].linear().transpose()));
      const Vector3 rate = turn.axis() * (turn.angle() / kStepSeconds);
      dBodySetLinearVel(body.id, velocity.x(), velocity.y(), velocity.z());
      dBodySetAngularVel(body.id, rate.x(), rate.y(), rate.z());
    }
  }

  OdeWorld& ode_;
  OdeFollower& follower_;
  const OdeModel& model_;
  const ModelDescription& type_;
};

}  // namespace

void addFollower(OdeWorld& ode, const ModelInstance& model, int index) {
  OdeModel& added = ode.models[static_cast<std::size_t>(index)];
  added.kinematic = true;
  added.follower = static_cast<int>(ode.followers.size());
  OdeFollower& follower = ode.followers.emplace_back();
  follower.model = index;
  follower.pushes = model.chosenMotion() != MotionMode::kStopping;
  follower.travels = model.type->walk || model.type->guided;
  // Joints between bodies of infinite mass have nothing to do; they still know their angles.
  for (std::size_t i = added.firstBody; i < ode.bodies.size(); ++i) {
    if (!ode.hasBody(i)) continue;
    const dBodyID body = ode.bodies[i].id;
    dBodySetKinematic(body);
    for (int k = 0; k < dBodyGetNumJoints(body); ++k) dJointDisable(dBodyGetJoint(body, k));
  }
}

void moveFollowers(OdeWorld& ode) {
  for (OdeFollower& follower : ode.followers) FollowerStep(ode, follower).move();
}

void settleFollowers(OdeWorld& ode) {
  for (OdeFollower& follower : ode.followers) FollowerStep(ode, follower).pose();
}

}  // namespace simcore
