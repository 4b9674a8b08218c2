// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/KinematicDrives.h"

#include <algorithm>
#include <cmath>

#include "simcore/physics/Contacts.h"
#include "simcore/physics/Physics.h"

namespace simcore {
namespace {

constexpr double kTolerance = 0.0005;  // m; sinking in less than that is only touching
constexpr int kHalvings = 6;
constexpr double kClearance = 1;  // m; farther away nobody looks for obstacles

struct BodyPose {
  Vector3 position;
  Eigen::Quaterniond rotation;
};

BodyPose poseOfBody(dBodyID body) {
  const dReal *p = dBodyGetPosition(body), *q = dBodyGetQuaternion(body);
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

void setPose(dBodyID body, const BodyPose& pose) {
  const Eigen::Quaterniond q = pose.rotation.normalized();
  const dQuaternion rotation = {q.w(), q.x(), q.y(), q.z()};
  dBodySetPosition(body, pose.position.x(), pose.position.y(), pose.position.z());
  dBodySetQuaternion(body, rotation);
}

void placeCircle(const OdeWorld& ode, OdeCircle& circle) {
  const OdeModel& model = ode.models[static_cast<std::size_t>(circle.model)];
  const dReal* position = dBodyGetPosition(ode.bodies[model.firstBody].id);
  circle.x = position[0];
  circle.y = position[1];
}

/// One drive in one step.
class Mover {
 public:
  Mover(OdeWorld& ode, std::size_t index)
      : ode_(ode),
        drive_(ode.drives[index]),
        left_(ode.wheelSides[2 * index]),
        right_(ode.wheelSides[2 * index + 1]),
        body_(ode.bodies[drive_.body].id) {}

  void move() {
    const double left = left_.on ? left_.target : 0, right = right_.on ? right_.target : 0;
    const bool moves = left != 0 || right != 0;
    const bool possible = !moves || tryMove((left + right) / 2, (right - left) / drive_.track);
    if (!moves || !possible) setVelocity(Vector3::Zero(), 0);
    settle(left_, possible ? left : 0, !possible && left != 0);
    settle(right_, possible ? right : 0, !possible && right != 0);
    // What it leans on stays touched while it stands.
    if (!moves && drive_.touches) depthNow(NoteTouches::kYes);
  }

 private:
  static void settle(OdeWheelSide& side, double speed, bool blocked) {
    side.speed = speed;
    side.travel += speed * Physics::kStepSeconds;
    side.blockedSteps = blocked ? side.blockedSteps + 1 : 0;
  }

  bool tryMove(double speed, double rate) {
    const BodyPose before = poseOfBody(body_);
    const double turn = rate * Physics::kStepSeconds;
    const Vector3 axle = before.rotation * drive_.axisInBody;
    const Vector3 center = before.position + before.rotation * drive_.centerInBody;
    const Eigen::AngleAxisd half(turn / 2, Vector3::UnitZ()), whole(turn, Vector3::UnitZ());
    const Vector3 forward = half * axle.cross(Vector3::UnitZ()).normalized();
    const Vector3 newCenter = center + speed * Physics::kStepSeconds * forward;
    const BodyPose after{newCenter + whole * (before.position - center),
                         Eigen::Quaterniond(whole) * before.rotation};
    setPose(body_, after);
    if (isAlone(newCenter)) {
      drive_.touches = false;
    } else if (!fits(before, after)) {
      return false;
    }
    setVelocity((after.position - before.position) / Physics::kStepSeconds, rate);
    return true;
  }

  void setVelocity(const Vector3& velocity, double rate) {
    dBodySetLinearVel(body_, velocity.x(), velocity.y(), velocity.z());
    dBodySetAngularVel(body_, 0, 0, rate);
  }

  /// Whether it may stay where it was put, so as not to sink in deeper than it does. If not, it goes as far
  /// as it can. What it touches in the end is noted.
  bool fits(const BodyPose& before, const BodyPose& after) {
    const double depth = depthNow();
    drive_.touches = depth > 0;
    if (depth > kTolerance) {
      setPose(body_, before);
      const double depthBefore = depthNow(NoteTouches::kYes);
      if (depth > depthBefore) {
        if (depthBefore == 0) approach(before, after);
        return false;
      }
      setPose(body_, after);
    }
    if (drive_.touches) depthNow(NoteTouches::kYes);
    return true;
  }

  /// Goes the greatest part of a way that lets it touch but not sink in.
  void approach(const BodyPose& before, const BodyPose& after) {
    double free = 0, blocked = 1;
    const auto partly = [&](double share) {
      return BodyPose{before.position + share * (after.position - before.position),
                      before.rotation.slerp(share, after.rotation)};
    };
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (free + blocked) / 2;
      setPose(body_, partly(middle));
      (depthNow() <= kTolerance ? free : blocked) = middle;
    }
    setPose(body_, partly(free));
    depthNow(NoteTouches::kYes);
  }

  double depthNow(NoteTouches note = NoteTouches::kNo) {
    return deepestOverlap(ode_, drive_.model, note).depth;
  }

  /// Whether nothing can be within reach; looked up anew only when it has come as far as was free.
  bool isAlone(const Vector3& center) {
    if (ode_.hasSteepPlanes) return false;
    const double moved = (center - drive_.freeAt).head<2>().norm();
    if (moved >= drive_.freeWay) {
      drive_.freeAt = center;
      drive_.freeWay =
          ode_.grid.clearance(center.x(), center.y(), drive_.radius + kClearance) - drive_.radius;
      if (drive_.freeWay <= 0) return false;
    }
    return std::ranges::none_of(ode_.circles, [&](const OdeCircle& other) {
      const double reach = drive_.radius + other.radius, dx = other.x - center.x(), dy = other.y - center.y();
      return dx * dx + dy * dy < reach * reach && other.model != drive_.model;
    });
  }

  OdeWorld& ode_;
  OdeDrive& drive_;
  OdeWheelSide &left_, &right_;
  dBodyID body_;
};

}  // namespace

void moveKinematicModels(OdeWorld& ode) {
  if (!ode.hasKinematic) return;
  for (OdeCircle& circle : ode.circles) placeCircle(ode, circle);
  for (std::size_t i = 0; i < ode.drives.size(); ++i) {
    if (!ode.models[static_cast<std::size_t>(ode.drives[i].model)].kinematic) continue;
    Mover(ode, i).move();
    placeCircle(ode, ode.circles[ode.drives[i].circle]);
  }
}

}  // namespace simcore
