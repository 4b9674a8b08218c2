// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeVehicleBuilder.h"

#include "simcore/physics/OdeDriveBuilder.h"

namespace simcore {
namespace {

/// The weight that each wheel carries if all carry equally, N.
double restLoadOf(const OdeWorld& ode, const ModelDescription& type) {
  double mass = 0;
  for (const LinkDescription& link : type.links) mass += link.mass;
  return mass * ode.description.gravity.norm() / static_cast<double>(type.vehicle->wheels.size());
}

}  // namespace

void addVehicle(OdeWorld& ode, const ModelInstance& model, int index) {
  const ModelDescription& type = *model.type;
  const OdeModel& added = ode.models[static_cast<std::size_t>(index)];
  const double restLoad = restLoadOf(ode, type);
  for (const VehicleWheel& one : type.vehicle->wheels) {
    ode.vehicleSides.push_back(ode.wheelSides.size());
    OdeWheelSide& side = ode.wheelSides.emplace_back();
    side.firstWheel = ode.wheels.size();
    side.wheelCount = 1;
    side.model = index;
    side.maximumForce = one.maximumForce;
    side.idleForce = one.idleForce;
    side.on = one.driven;
    const JointDescription& joint = type.joints[static_cast<std::size_t>(one.joint)];
    addWheel(ode, type, joint, index, added);
    OdeWheel& wheel = ode.wheels.back();
    wheel.restLoad = wheel.load = restLoad;
    wheel.hasRollers = one.rollers.has_value();
    wheel.pushAngle = one.rollers.value_or(0);
    if (joint.axisInModel.cross(Vector3::UnitZ()).dot(one.forward) > 0) continue;
    wheel.axisInBody = -wheel.axisInBody;
    wheel.axisInLink = -wheel.axisInLink;
  }
}

}  // namespace simcore
