// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeDriveBuilder.h"

#include <span>

#include "simcore/physics/OdeGeoms.h"
#include "simcore/physics/shapes/DriveGeometry.h"

namespace simcore {

void addWheel(OdeWorld& ode, const ModelDescription& type, const JointDescription& joint, int index,
              const OdeModel& added) {
  const LinkDescription& link = type.links[static_cast<std::size_t>(joint.child)];
  OdeBody& body = ode.bodies[added.firstBody + static_cast<std::size_t>(joint.child)];
  OdeWheel wheel;
  wheel.body = ode.bodies[added.firstBody + static_cast<std::size_t>(joint.parent)].carrier;
  wheel.side = ode.wheelSides.size() - 1;
  const OdeBody& carrier = ode.bodies[wheel.body];
  const Pose3& carrierInModel = type.links[wheel.body - added.firstBody].poseInModel;
  const Pose3 bodyInModel = carrierInModel * Eigen::Translation3d(carrier.centerInLink);
  wheel.linkInBody = bodyInModel.inverse() * link.poseInModel;
  wheel.axisInBody = bodyInModel.linear().transpose() * joint.axisInModel;
  wheel.axisInLink = link.poseInModel.linear().transpose() * joint.axisInModel;
  CollisionDescription tread = link.collisions.front();
  wheel.radius = tread.shape.radius;
  wheel.centerInLink = tread.poseInLink.translation();
  tread.shape.kind = Shape::Kind::kSphere;
  tread.poseInLink = carrierInModel.inverse() * link.poseInModel * tread.poseInLink;
  body.id = carrier.id;
  body.carrier = wheel.body;
  body.wheel = static_cast<int>(ode.wheels.size());
  body.firstGeom = ode.geoms.size();
  addBodyGeom(ode, carrier, tread, index, added.space);
  ode.geoms.back().wheel = body.wheel;
  ode.geoms.back().body = added.firstBody + static_cast<std::size_t>(joint.child);
  ode.wheels.push_back(wheel);
}

namespace {

/// Computes what depends on all wheels of a drive, which begin at `first`.
void settleDrive(OdeWorld& ode, const ModelInstance& model, int index, std::size_t first) {
  const OdeModel& added = ode.models[static_cast<std::size_t>(index)];
  const DriveGeometry geometry = driveGeometry(*model.type);
  const std::span<OdeWheel> wheels = std::span(ode.wheels).subspan(first);
  const OdeBody& carrier = ode.bodies[wheels[0].body];
  const auto link = static_cast<std::size_t>(wheels[0].body - added.firstBody);
  const Pose3 bodyInModel = model.type->links[link].poseInModel * Eigen::Translation3d(carrier.centerInLink);
  dMass mass;
  dBodyGetMass(carrier.id, &mass);
  for (OdeWheel& wheel : wheels) {
    wheel.slipRatio = geometry.slipRatio;
    wheel.restLoad = mass.mass * ode.description.gravity.norm() / static_cast<double>(wheels.size());
    wheel.load = wheel.restLoad;
    // All wheels drive forwards in the same direction, whatever the direction of their joints' axes.
    if ((bodyInModel.linear() * wheel.axisInBody).dot(geometry.toLeft) > 0) continue;
    wheel.axisInBody = -wheel.axisInBody;
    wheel.axisInLink = -wheel.axisInLink;
  }
  OdeDrive& made = ode.drives.emplace_back();
  made.model = index;
  made.firstSide = ode.wheelSides.size() - 2;
  made.body = wheels[0].body;
  made.track = model.type->drive->track;
  made.centerInBody = bodyInModel.inverse() * geometry.center;
  made.axisInBody = bodyInModel.linear().transpose() * geometry.toLeft;
  made.radius = geometry.radius;
  made.footprint = geometry.footprint;
  made.place = ode.places.size();
}

}  // namespace

void addDrive(OdeWorld& ode, const ModelInstance& model, int index) {
  const DriveDescription& drive = *model.type->drive;
  const OdeModel& added = ode.models[static_cast<std::size_t>(index)];
  const std::size_t first = ode.wheels.size();
  for (const std::vector<int>* joints : {&drive.left, &drive.right}) {
    const auto count = static_cast<double>(joints->size());
    OdeWheelSide side;
    side.firstWheel = ode.wheels.size();
    side.model = index;
    side.wheelCount = joints->size();
    side.maximumForce = drive.maximumForce * count;
    side.idleForce = drive.idleForce * count;
    ode.wheelSides.push_back(side);
    for (const int joint : *joints) {
      addWheel(ode, *model.type, model.type->joints[static_cast<std::size_t>(joint)], index, added);
    }
  }
  settleDrive(ode, model, index, first);
}

}  // namespace simcore
