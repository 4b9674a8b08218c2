// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeWorldBuilder.h"

#include <algorithm>
#include <cmath>

#include "simcore/physics/FollowingModels.h"
#include "simcore/physics/FreeBodies.h"
#include "simcore/physics/OdeDriveBuilder.h"
#include "simcore/physics/OdeGeoms.h"
#include "simcore/physics/OdeGuideBuilder.h"
#include "simcore/physics/OdeJoints.h"
#include "simcore/physics/OdeVehicleBuilder.h"
#include "simcore/physics/Step.h"
#include "simcore/physics/shapes/LumpedLink.h"
#include "simcore/world/ModelGeometry.h"

namespace simcore {
namespace {

// From this number of static geoms on, the grid is faster than ODE's comparing them one by one.
constexpr std::size_t kGridFrom = 64;
/// The upward component of a plane's normal.
constexpr double kSteep = 0.7;
/// In m; how much farther than initially a robot's limbs may reach.
constexpr double kReach = 0.3;

/// Fills an OdeWorld from its description.
class WorldBuilder {
 public:
  WorldBuilder(OdeWorld& ode, bool kinematicDrives) : ode_(ode), kinematicDrives_(kinematicDrives) {}

  void build() {
    ode_.sleeps = ode_.description.sleeps;
    // The spaces point to its elements.
    ode_.models.reserve(ode_.description.models.size());
    for (const ModelInstance& model : ode_.description.models) {
      const int index = static_cast<int>(ode_.models.size());
      OdeModel& added = ode_.models.emplace_back();
      added.firstBody = ode_.bodies.size();
      added.firstHinge = ode_.hinges.size();
      if (model.type->isStatic)
        addStatic(model, index);
      else
        addMoving(model, index, added);
      added.bodyCount = ode_.bodies.size() - added.firstBody;
      added.hingeCount = ode_.hinges.size() - added.firstHinge;
      ode_.hingeModels.resize(ode_.hinges.size(), index);
    }
    ode_.grid.build();
    ode_.usesGrid = ode_.grid.size() >= kGridFrom;
    for (const dGeomID geom : statics_) {
      const bool isPlane = dGeomGetClass(geom) == dPlaneClass;
      if (isPlane || !ode_.usesGrid) dSpaceAdd(ode_.statics, geom);
    }
  }

 private:
  void addStatic(const ModelInstance& model, int index) {
    for (const LinkDescription& link : model.type->links) {
      for (const CollisionDescription& collision : link.collisions) {
        const Pose3 pose = model.poseInWorld * link.poseInModel * collision.poseInLink;
        const dGeomID geom = addGeom(ode_, nullptr, collision, index, pose);
        if (collision.shape.kind == Shape::Kind::kPlane) {
          ode_.hasSteepPlanes |= std::abs(pose.linear()(2, 2)) < kSteep;
        } else {
          withOdePose(pose, [&](const dReal* p, const dMatrix3 r) {
            dGeomSetPosition(geom, p[0], p[1], p[2]);
            dGeomSetRotation(geom, r);
          });
        }
        statics_.push_back(geom);
        ode_.grid.add(geom);
      }
    }
  }

  void addMoving(const ModelInstance& model, int index, OdeModel& added) {
    added.space = dSimpleSpaceCreate(ode_.top);
    dSpaceSetCleanup(added.space, 0);
    // A higher level than that of the static space, so that the model's bounds are compared with static geoms
    // first.
    dSpaceSetSublevel(added.space, 1);
    dGeomSetData(reinterpret_cast<dGeomID>(added.space), &added);
    added.kinematic = model.type->drive.has_value() && isKinematic(model.chosenMotion());
    const ModelDescription& type = *model.type;
    const std::size_t firstHinge = ode_.hinges.size();
    addLinks(model, index, added);
    if (type.drive) addDrive(ode_, model, index);
    if (type.vehicle) addVehicle(ode_, model, index);
    for (const JointDescription& joint : type.joints) addJoint(ode_, model, joint, added.firstBody);
    pose(model, added.firstBody);
    if (type.guided && !type.vehicle && !model.follows()) addGuide(ode_, *type.guided, added);
    const bool sleeps = maySleep(model);
    for (std::size_t i = added.firstBody; !added.kinematic && i < ode_.bodies.size(); ++i) {
      if (ode_.hasBody(i)) addFreeBody(ode_, ode_.bodies[i].id, sleeps);
    }
    const OdeBody& first = ode_.bodies[added.firstBody];
    OdePlace place{index};
    place.radius = extentOf(type).radius + (type.links[0].poseInModel * first.centerInLink).head<2>().norm();
    if (ode_.hinges.size() > firstHinge) place.radius += kReach;
    ode_.places.push_back(place);
    (added.kinematic ? ode_.hasKinematic : ode_.hasDynamic) = true;
    if (model.follows()) return addFollower(ode_, model, index);
    for (std::size_t i = added.firstBody; sleeps && !added.kinematic && i < ode_.bodies.size(); ++i) {
      if (ode_.hasBody(i))
        added.sleepers.push_back(static_cast<OdeFreeBody*>(dBodyGetData(ode_.bodies[i].id)));
    }
    for (std::size_t i = 0; added.kinematic && i < type.links.size(); ++i) {
      dBodyDisable(ode_.bodies[added.firstBody + i].id);
    }
  }

  void addLinks(const ModelInstance& model, int index, const OdeModel& added) {
    const ModelDescription& type = *model.type;
    const std::vector<int> parts = rigidParts(type);
    ode_.bodies.resize(added.firstBody + type.links.size());
    for (std::size_t i = 0; i < type.links.size(); ++i) {
      const int link = static_cast<int>(i);
      if (isWheel(type, link)) continue;
      OdeBody& made = ode_.bodies[added.firstBody + i];
      const auto carrier = static_cast<std::size_t>(parts[i]);
      made = carrier == i ? addBody(model, lumpedLink(type, parts, link), index, added.space)
                          : addPart(type, i, carrier, index, added);
      made.carrier = added.firstBody + carrier;
      for (std::size_t k = made.firstGeom; k < ode_.geoms.size(); ++k)
        ode_.geoms[k].body = added.firstBody + i;
    }
  }

  /// Adds a link to the body of another one, which exists.
  OdeBody addPart(const ModelDescription& type, std::size_t link, std::size_t carrier, int index,
                  const OdeModel& added) {
    const OdeBody& body = ode_.bodies[added.firstBody + carrier];
    const Pose3 linkInCarrier = type.links[carrier].poseInModel.inverse() * type.links[link].poseInModel;
    OdeBody part;
    part.id = body.id;
    part.linkInBody = Eigen::Translation3d(-body.centerInLink) * linkInCarrier;
    part.centerInLink = linkInCarrier.inverse() * body.centerInLink;
    part.firstGeom = ode_.geoms.size();
    for (CollisionDescription collision : type.links[link].collisions) {
      collision.poseInLink = linkInCarrier * collision.poseInLink;
      addBodyGeom(ode_, body, collision, index, added.space);
    }
    return part;
  }

  /// Whether a model may rest on others: it has no wheels and is not guided, no joint ties it to the world,
  /// and none of its joints has measured forces, which would not be computed then.
  bool maySleep(const ModelInstance& model) const {
    const ModelDescription& type = *model.type;
    if (!ode_.sleeps || type.drive || type.vehicle || type.guided || model.follows()) return false;
    return std::ranges::none_of(
        type.joints, [](const JointDescription& joint) { return joint.parent < 0 || joint.isMeasured; });
  }

  bool isKinematic(MotionMode mode) const {
    return mode == MotionMode::kUnset ? kinematicDrives_ : mode >= MotionMode::kKinematic;
  }

  OdeBody addBody(const ModelInstance& model, const LinkDescription& link, int index, dSpaceID space) {
    OdeBody body;
    body.id = dBodyCreate(ode_.world);
    body.centerInLink = link.centerOfMass;
    body.firstGeom = ode_.geoms.size();
    dMass mass;
    const Eigen::Matrix3d& i = link.inertia;
    dMassSetParameters(&mass, link.mass, 0, 0, 0, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
    dBodySetMass(body.id, &mass);
    dBodySetAutoDisableFlag(body.id, 0);
    if (link.weightless) dBodySetGravityMode(body.id, 0);
    setDamping(body.id, link);
    place(body, model.poseInWorld * link.poseInModel);
    for (const CollisionDescription& collision : link.collisions)
      addBodyGeom(ode_, body, collision, index, space);
    return body;
  }

  static void setDamping(dBodyID body, const LinkDescription& link) {
    if (link.linearDamping <= 0 && link.angularDamping <= 0) return;
    dBodySetLinearDamping(body, link.linearDamping * kStepSeconds);
    dBodySetAngularDamping(body, link.angularDamping * kStepSeconds);
    // By default ODE does not damp slow motion, and a ball would roll forever.
    dBodySetLinearDampingThreshold(body, 0);
    dBodySetAngularDampingThreshold(body, 0);
  }

  /// Turns the joints, which were created at angle 0, to their initial angles.
  void pose(const ModelInstance& model, std::size_t firstBody) {
    const ModelDescription& type = *model.type;
    // Keyed by the joints above, in the model's frame.
    std::vector<Pose3> moved(type.links.size(), Pose3::Identity());
    for (const JointDescription& joint : type.joints) {
      if (joint.closesCycle) continue;
      const Pose3 above =
          joint.parent < 0 ? Pose3::Identity() : moved[static_cast<std::size_t>(joint.parent)];
      moved[static_cast<std::size_t>(joint.child)] = above * displacementAtStart(joint);
    }
    for (std::size_t i = 0; i < type.links.size(); ++i) {
      if (!ode_.hasBody(firstBody + i)) continue;
      place(ode_.bodies[firstBody + i], model.poseInWorld * moved[i] * type.links[i].poseInModel);
    }
  }

  static void place(const OdeBody& body, const Pose3& link) {
    const Vector3 center = link * body.centerInLink;
    withOdePose(link, [&](const dReal*, const dMatrix3 r) {
      dBodySetPosition(body.id, center.x(), center.y(), center.z());
      dBodySetRotation(body.id, r);
    });
  }

  OdeWorld& ode_;
  const bool kinematicDrives_;
  std::vector<dGeomID> statics_;
};

}  // namespace

std::unique_ptr<OdeWorld> buildOdeWorld(const WorldDescription& description, bool kinematicDrives) {
  auto world = std::make_unique<OdeWorld>(description);
  WorldBuilder(*world, kinematicDrives).build();
  return world;
}

}  // namespace simcore
