// SPDX-License-Identifier: GPL-3.0-or-later
// readDoors() of SdfDevices.h: joints that open when a sensor notices something.
#include <algorithm>

#include "simcore/sdf/SdfDevices.h"

namespace simcore {
namespace {

using DoorSensorKind = SensorDescription::Kind;

constexpr double kLongestOpen = 3600;  // s
constexpr double kUsualOpen = 3;       // s

bool measuresDistance(DoorSensorKind kind) {
  return kind == DoorSensorKind::kDistance || kind == DoorSensorKind::kSonar ||
         kind == DoorSensorKind::kLaser;
}

bool feels(DoorSensorKind kind) {
  return kind == DoorSensorKind::kContact || kind == DoorSensorKind::kSwitch ||
         kind == DoorSensorKind::kWhisker;
}

/// Reads which sensor opens the door, if one does.
void readDoorSensor(const sdf::ElementPtr& element, const std::string& prefix, const ModelDescription& model,
                    DoorDescription& door, const SdfContext& context) {
  if (!element->HasAttribute("sensor")) return;
  const auto name = element->Get<std::string>("sensor");
  const auto found = std::ranges::find_if(model.sensors, [&](const SensorDescription& each) {
    return each.name == prefix + name && (measuresDistance(each.kind) || feels(each.kind));
  });
  if (found == model.sensors.end()) {
    return context.fail(element, "scene.door",
                        "the model has no sensor '" + name +
                            "' that measures a distance (lidar, sonar) or feels (contact, switch, whisker)");
  }
  door.sensor = found->name;
  if (feels(found->kind)) return;
  if (!element->HasElement("robotcontrol:below")) {
    return context.fail(
        element, "scene.door",
        "a door with a sensor of distance needs <robotcontrol:below>, m: it opens for what is "
        "nearer");
  }
  door.below = ownNumber(element, "below", 0, 0, 1000, context);
}

void readDoor(const sdf::ElementPtr& element, const std::string& prefix, const ModelDescription& model,
              JointDescription& joint, const SdfContext& context) {
  if (!joint.servo || joint.control.kind != MotorControl::Kind::kPosition) {
    return context.fail(element, "scene.door",
                        "the joint of a door needs a <robotcontrol:servo>, controlled by position");
  }
  if (!element->HasElement("robotcontrol:open")) {
    return context.fail(element, "scene.door",
                        "a door needs <robotcontrol:open>: the position of its joint when it is open");
  }
  DoorDescription door;
  door.open = ownNumber(element, "open", 0, joint.lower, joint.upper, context);
  door.closed = ownNumber(element, "closed", joint.initialAngle, joint.lower, joint.upper, context);
  door.seconds = ownNumber(element, "seconds", kUsualOpen, 0, kLongestOpen, context);
  readDoorSensor(element, prefix, model, door, context);
  joint.door = door;
}

}  // namespace

void readDoors(const sdf::Model& source, ModelDescription& model, const SdfContext& context) {
  for (JointDescription& joint : model.joints) {
    const sdf::Joint* described = source.JointByName(joint.name);
    // Parts of models in models have names like "arm::hand".
    const std::size_t nested = joint.name.rfind("::");
    const std::string prefix = nested == std::string::npos ? "" : joint.name.substr(0, nested + 2);
    if (described == nullptr || !described->Element()->HasElement("robotcontrol:door")) continue;
    readDoor(described->Element()->GetElement("robotcontrol:door"), prefix, model, joint, context);
  }
}

}  // namespace simcore
