// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/KinematicDrives.h"

#include <algorithm>
#include <utility>

#include "simcore/physics/Contacts.h"
#include "simcore/physics/OdeRays.h"
#include "simcore/physics/Step.h"

namespace simcore {

using robotlink::Vector2;

namespace {

constexpr double kPositionTolerance = 0.0005;  // m; sinking in less than that is only touching
constexpr int kHalvings = 6;
/// In m; obstacles farther away are not searched.
constexpr double kClearance = 1;

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

/// The position and direction of a drive in the plane.
struct PlanePose {
  Vector2 center, forward;
};

PlanePose planePose(const OdeDrive& drive, const BodyPose& body) {
  const Vector3 axle = body.rotation * drive.axisInBody;
  const Vector3 center = body.position + body.rotation * drive.centerInBody;
  return {center.head<2>(), Vector2(axle.y(), -axle.x()).normalized()};
}

Footprint footprintAt(const OdeDrive& drive, const PlanePose& pose) {
  Footprint result = drive.footprint;
  const Vector2 left(-pose.forward.y(), pose.forward.x());
  result.center = pose.center + drive.footprint.center.x() * pose.forward + drive.footprint.center.y() * left;
  result.along = pose.forward;
  return result;
}

void updatePlace(const OdeWorld& ode, OdePlace& place) {
  const OdeModel& model = ode.models[static_cast<std::size_t>(place.model)];
  const dReal* position = dBodyGetPosition(ode.bodies[model.firstBody].id);
  place.x = position[0];
  place.y = position[1];
}

void updateFootprint(OdeWorld& ode, const OdeDrive& drive) {
  OdePlace& place = ode.places[drive.place];
  place.footprint = footprintAt(drive, planePose(drive, poseOfBody(ode.bodies[drive.body].id)));
  place.hasFootprint = true;
}

/// Moves one drive by one step.
class Mover {
 public:
  Mover(OdeWorld& ode, std::size_t index)
      : ode_(ode),
        drive_(ode.drives[index]),
        left_(ode.driveSide(2 * index)),
        right_(ode.driveSide(2 * index + 1)),
        body_(ode.bodies[drive_.body].id) {}

  /// Returns false if the drive was requested to stand.
  bool move() {
    const double left = left_.on ? left_.target : 0, right = right_.on ? right_.target : 0;
    const bool moves = left != 0 || right != 0;
    const bool isPinned = ode_.bodies[drive_.body].pinned;
    const bool possible = !moves || (!isPinned && tryMove((left + right) / 2, (right - left) / drive_.track));
    if (!moves || !possible) setVelocity(Vector3::Zero(), 0);
    settle(left_, possible ? left : 0, !possible && left != 0);
    settle(right_, possible ? right : 0, !possible && right != 0);
    // A model that leans on something keeps touching it while it stands.
    if (!moves && drive_.touches) depthNow(NoteTouches::kYes);
    return moves;
  }

 private:
  static void settle(OdeWheelSide& side, double speed, bool blocked) {
    side.speed = speed;
    side.travel += speed * kStepSeconds;
    side.blockedSteps = blocked ? side.blockedSteps + 1 : 0;
  }

  bool tryMove(double speed, double rate) {
    const BodyPose before = poseOfBody(body_);
    const double turn = rate * kStepSeconds;
    const PlanePose pose = planePose(drive_, before);
    const Vector2 way = speed * kStepSeconds * (Eigen::Rotation2Dd(turn / 2) * pose.forward);
    const Eigen::AngleAxisd whole(turn, Vector3::UnitZ());
    const Vector3 center(pose.center.x(), pose.center.y(), before.position.z());
    const BodyPose after{center + whole * (before.position - center) + Vector3(way.x(), way.y(), 0),
                         Eigen::Quaterniond(whole) * before.rotation};
    setPose(body_, after);
    if (isAlone(planePose(drive_, after))) {
      drive_.touches = false;
    } else if (!fits(before, after)) {
      return false;
    }
    setVelocity((after.position - before.position) / kStepSeconds, rate);
    return true;
  }

  void setVelocity(const Vector3& velocity, double rate) {
    dBodySetLinearVel(body_, velocity.x(), velocity.y(), velocity.z());
    dBodySetAngularVel(body_, 0, 0, rate);
  }

  /// Whether the model may stay at its new pose because it does not overlap anything deeper than before. If
  /// not, it moves as far as it can. Final contacts are recorded.
  bool fits(const BodyPose& before, const BodyPose& after) {
    const double depth = depthNow();
    drive_.touches = depth > 0;
    if (depth > kPositionTolerance) {
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

  /// Moves by the largest fraction of a step at which the model touches but does not overlap.
  void approach(const BodyPose& before, const BodyPose& after) {
    double free = 0, blocked = 1;
    const auto partly = [&](double share) {
      return BodyPose{before.position + share * (after.position - before.position),
                      before.rotation.slerp(share, after.rotation)};
    };
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (free + blocked) / 2;
      setPose(body_, partly(middle));
      (depthNow() <= kPositionTolerance ? free : blocked) = middle;
    }
    setPose(body_, partly(free));
    depthNow(NoteTouches::kYes);
  }

  double depthNow(NoteTouches note = NoteTouches::kNo) {
    return deepestOverlap(ode_, drive_.model, note).depth;
  }

  /// Whether nothing touches the model, judged from above. Static geoms are searched only when the model has
  /// moved as far as was known to be free of them.
  bool isAlone(const PlanePose& pose) {
    if (ode_.hasSteepPlanes) return false;
    const Footprint own = footprintAt(drive_, pose);
    if ((pose.center - drive_.freeAt).norm() >= drive_.freeWay) {
      drive_.freeAt = pose.center;
      drive_.freeWay =
          ode_.grid.clearance(pose.center.x(), pose.center.y(), drive_.radius + kClearance) - drive_.radius;
      if (drive_.freeWay <= 0 && ode_.grid.meetsAny(own)) return false;
    }
    return std::ranges::none_of(ode_.places, [&](const OdePlace& other) {
      const double reach = drive_.radius + other.radius;
      const double dx = other.x - pose.center.x(), dy = other.y - pose.center.y();
      if (dx * dx + dy * dy >= reach * reach || other.model == drive_.model) return false;
      return !other.hasFootprint || meet(own, other.footprint);
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
  for (const OdeDrive& drive : ode.drives) {
    OdeModel& model = ode.models[static_cast<std::size_t>(drive.model)];
    if (!model.kinematic || std::exchange(model.hasGround, true)) continue;
    comeDown(ode, drive.model);
  }
  for (OdePlace& place : ode.places) updatePlace(ode, place);
  for (const OdeDrive& drive : ode.drives) updateFootprint(ode, drive);
  for (std::size_t i = 0; i < ode.drives.size(); ++i) {
    const OdeDrive& drive = ode.drives[i];
    if (!ode.models[static_cast<std::size_t>(drive.model)].kinematic || !Mover(ode, i).move()) continue;
    updatePlace(ode, ode.places[drive.place]);
    updateFootprint(ode, drive);
  }
}

}  // namespace simcore
