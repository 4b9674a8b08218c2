// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeWorld.h"

#include <algorithm>
#include <cmath>

namespace simcore {
namespace {

// Tuned for robots of this size: with fewer iterations or longer steps they fall; more cost time without
// benefit.
constexpr int kIterations = 20;
constexpr double kErrorReduction = 0.3;
constexpr double kConstraintForceMixing = 1e-7;
/// In m/s; keeps overlapping bodies from being catapulted apart.
constexpr double kMaxCorrectingVelocity = 1;

/// From this number of moving models on, sorting them is faster than comparing each with each.
constexpr std::ptrdiff_t kSortFrom = 100;

dSpaceID newTopSpace(const WorldDescription& description) {
  const auto moving = std::ranges::count_if(description.models,
                                            [](const ModelInstance& model) { return !model.type->isStatic; });
  return moving >= kSortFrom ? dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ)
                             : dSimpleSpaceCreate(nullptr);
}

}  // namespace

OdeWorld::OdeWorld(const WorldDescription& worldDescription) : description(worldDescription) {
  prepareOdeForThread();
  world = dWorldCreate();
  const Vector3& gravity = description.gravity;
  dWorldSetGravity(world, gravity.x(), gravity.y(), gravity.z());
  dWorldSetERP(world, kErrorReduction);
  dWorldSetCFM(world, kConstraintForceMixing);
  dWorldSetQuickStepNumIterations(world, kIterations);
  dWorldSetContactMaxCorrectingVel(world, kMaxCorrectingVelocity);
  dWorldSetContactSurfaceLayer(world, 0.0005);
  // The threading that worlds share by default is not safe when two of them step at the same time.
  threading = dThreadingAllocateSelfThreadedImplementation();
  dWorldSetStepThreadingImplementation(world, dThreadingImplementationGetFunctions(threading), threading);
  top = newTopSpace(description);
  dSpaceSetCleanup(top, 0);
  statics = dSimpleSpaceCreate(top);
  dSpaceSetCleanup(statics, 0);
  contacts = dJointGroupCreate(0);
  ray = dCreateRay(nullptr, 1);
}

OdeWorld::~OdeWorld() {
  prepareOdeForThread();
  dJointGroupDestroy(contacts);
  for (const OdeGeom& geom : geoms) {
    dGeomDestroy(geom.id);
    if (geom.triangles != nullptr) dGeomTriMeshDataDestroy(geom.triangles);
  }
  dGeomDestroy(ray);
  for (const OdeModel& model : models) {
    if (model.space != nullptr) dSpaceDestroy(model.space);
  }
  dSpaceDestroy(statics);
  dSpaceDestroy(top);
  dWorldDestroy(world);
  dThreadingFreeImplementation(threading);
}

Pose3 poseOf(const dReal* position, const dReal* rotation) {
  Pose3 pose = Pose3::Identity();
  pose.translation() = Vector3(position[0], position[1], position[2]);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.linear()(row, column) = rotation[4 * row + column];
  }
  return pose;
}

OdeWheelContact& OdeWorld::nextWheelContact() {
  if (wheelContactCount == wheelContacts.size()) wheelContacts.emplace_back();
  return wheelContacts[wheelContactCount++];
}

Pose3 OdeWorld::wheelLinkPose(const OdeWheel& wheel) const {
  const dBodyID body = bodies[wheel.body].id;
  const double angle = std::remainder(wheelSides[wheel.side].travel / wheel.radius, 2 * robotlink::kPi);
  return poseOf(dBodyGetPosition(body), dBodyGetRotation(body)) * wheel.linkInBody *
         Eigen::Translation3d(wheel.centerInLink) * Eigen::AngleAxisd(angle, wheel.axisInLink) *
         Eigen::Translation3d(-wheel.centerInLink);
}

Pose3 OdeWorld::linkPose(std::size_t body) const {
  const OdeBody& one = bodies[body];
  if (one.wheel >= 0) return wheelLinkPose(wheels[static_cast<std::size_t>(one.wheel)]);
  if (one.carrier != body) return poseOf(dBodyGetPosition(one.id), dBodyGetRotation(one.id)) * one.linkInBody;
  return poseOf(dBodyGetPosition(one.id), dBodyGetRotation(one.id)) * Eigen::Translation3d(-one.centerInLink);
}

}  // namespace simcore
