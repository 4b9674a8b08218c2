// SPDX-License-Identifier: GPL-3.0-or-later
// readMotor(), readGuided(), readDoors(), readControllers() and the radiation of SdfDevices.h.
#include <algorithm>
#include <sstream>

#include "simcore/control/ControllerCheck.h"
#include "simcore/sdf/SdfDevices.h"

namespace simcore {
namespace {

constexpr double kMost = 1e6;

struct GuidedKind {
  const char* name;
  GuidedMotion::Kind kind;
};
constexpr GuidedKind kGuidedKinds[] = {{"free", GuidedMotion::Kind::kFree},
                                       {"omni", GuidedMotion::Kind::kOmni},
                                       {"differential", GuidedMotion::Kind::kDifferential},
                                       {"skid", GuidedMotion::Kind::kSkid},
                                       {"ackermann", GuidedMotion::Kind::kAckermann},
                                       {"walk", GuidedMotion::Kind::kWalk}};

std::optional<SensorErrors> readJointSensor(const sdf::ElementPtr& joint, const char* name,
                                            const SdfContext& context) {
  const std::string key = std::string("robotcontrol:") + name;
  if (!joint->HasElement(key)) return std::nullopt;
  SensorErrors errors;
  readOwnErrors(joint->GetElement(key), errors, context);
  return errors;
}

/// The name of a class; an error if the attribute is missing.
std::string className(const sdf::ElementPtr& element, const char* attribute, const SdfContext& context) {
  std::string name;
  if (element->HasAttribute(attribute)) name = element->Get<std::string>(attribute);
  if (name.empty()) {
    context.fail(element, "scene.radiation",
                 "<" + element->GetName() + "> needs the attribute '" + attribute + "', a radiation class");
  }
  return name;
}

template <typename Read>
void forEachOwn(const sdf::ElementPtr& parent, const char* name, Read read) {
  for (sdf::ElementPtr child = parent->GetFirstElement(); child; child = child->GetNextElement()) {
    if (child->GetName() == name) read(child);
  }
}

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
                            "' that measures distance (lidar, sonar) or touch (contact, switch, whisker)");
  }
  door.sensor = found->name;
  if (feels(found->kind)) return;
  if (!element->HasElement("robotcontrol:below")) {
    return context.fail(element, "scene.door",
                        "a door with a distance sensor needs <robotcontrol:below>, m: it opens for anything "
                        "nearer");
  }
  door.below =
      context.within(element->Get<double>("robotcontrol:below"), 0, 1000, "<robotcontrol:below>", element);
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
  const std::size_t before = context.errors.size();
  door.open = context.within(element->Get<double>("robotcontrol:open"), joint.lower, joint.upper,
                             "<robotcontrol:open>", element);
  door.closed = ownNumber(element, "closed", joint.initialAngle, joint.lower, joint.upper, context);
  if (context.errors.size() == before && door.open == door.closed) {
    context.fail(element, "scene.door",
                 "<robotcontrol:open> is the position where the door is closed: it would never open");
  }
  door.seconds = ownNumber(element, "seconds", kUsualOpen, 0, kLongestOpen, context);
  readDoorSensor(element, prefix, model, door, context);
  joint.door = door;
}

}  // namespace

void readMotor(const sdf::ElementPtr& joint, JointDescription& result, const SdfContext& context) {
  result.speedSensor = readJointSensor(joint, "speed_sensor", context);
  result.loadSensor = readJointSensor(joint, "load_sensor", context);
  if (const auto errors = readJointSensor(joint, "position_sensor", context)) result.positionErrors = *errors;
  if (!joint->HasElement("robotcontrol:servo")) return;
  const sdf::ElementPtr servo = joint->GetElement("robotcontrol:servo");
  MotorControl& control = result.control;
  const std::string kind = servo->HasElement("robotcontrol:control")
                               ? servo->Get<std::string>("robotcontrol:control")
                               : "position";
  if (kind == "velocity") control.kind = MotorControl::Kind::kVelocity;
  if (kind == "torque") control.kind = MotorControl::Kind::kTorque;
  if (kind != "position" && kind != "velocity" && kind != "torque") {
    context.fail(servo, "scene.servo",
                 "the <robotcontrol:control> of a servo is position, velocity or torque, not '" + kind + "'");
  }
  control.p = ownNumber(servo, "p", 0, 0, kMost, context);
  control.i = ownNumber(servo, "i", 0, 0, kMost, context);
  control.d = ownNumber(servo, "d", 0, 0, kMost, context);
  control.delay = ownNumber(servo, "delay", 0, 0, 1, context);
}

void readGuided(const sdf::ElementPtr& element, ModelDescription& model, const SdfContext& context) {
  if (!element->HasElement("robotcontrol:guided")) return;
  const sdf::ElementPtr guided = element->GetElement("robotcontrol:guided");
  GuidedMotion motion;
  const std::string kind = guided->HasAttribute("kind") ? guided->Get<std::string>("kind") : "";
  const auto* found =
      std::ranges::find_if(kGuidedKinds, [&](const GuidedKind& each) { return kind == each.name; });
  if (found == std::end(kGuidedKinds)) {
    return context.fail(guided, "scene.guided",
                        "the kind of <robotcontrol:guided> is free, omni, differential, skid, ackermann or "
                        "walk, not '" +
                            kind + "'");
  }
  if (model.isStatic || model.drive || model.links.empty()) {
    return context.fail(
        guided, "scene.guided",
        model.drive ? "a model can have a drive or be guided, not both" : "a static model cannot be guided");
  }
  const auto number = [&](const char* name, double otherwise, double minimum, double maximum) {
    return ownNumber(guided, name, otherwise, minimum, maximum, context);
  };
  motion.kind = found->kind;
  if (guided->HasAttribute("name")) motion.name = guided->Get<std::string>("name");
  motion.maximumSpeed = number("maximum_speed", motion.maximumSpeed, 1e-3, 100);
  motion.maximumRate = number("maximum_rate", motion.maximumRate, 1e-3, 100);
  motion.acceleration = number("acceleration", motion.acceleration, 1e-3, 1000);
  motion.angularAcceleration = number("angular_acceleration", motion.angularAcceleration, 1e-3, 1e4);
  motion.track = number("track", motion.track, 0.01, 100);
  motion.wheelbase = number("wheelbase", motion.wheelbase, 0.01, 100);
  motion.skid = number("skid", motion.skid, 0.01, 1);
  motion.maximumSteering = number("maximum_steering", motion.maximumSteering, 0.01, 1.5);
  model.guided = motion;
}

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

void readControllers(const sdf::ElementPtr& element, const std::string& prefix,
                     std::vector<ControllerDescription>& to, const SdfContext& context) {
  const auto textOf = [](const sdf::ElementPtr& of, const char* attribute) {
    return of->HasAttribute(attribute) ? of->Get<std::string>(attribute) : std::string();
  };
  forEachOwn(element, "robotcontrol:controller", [&](const sdf::ElementPtr& child) {
    ControllerDescription described;
    described.kind = textOf(child, "name");
    const std::string name = textOf(child, "as");
    described.name = prefix + (name.empty() ? described.kind : name);
    described.prefix = prefix;
    described.where = context.placeOf(child);
    forEachOwn(child, "robotcontrol:parameter", [&](const sdf::ElementPtr& parameter) {
      described.arguments.push_back(
          {textOf(parameter, "name"), parameter->Get<std::string>(), context.placeOf(parameter)});
    });
    const std::size_t before = context.errors.size();
    if (described.name.find('/') != std::string::npos)
      context.fail(child, "scene.controller", "the name of a controller must not contain '/'");
    checkController(described, SdfContext::pathOf(element), context.errors);
    if (context.errors.size() == before) to.push_back(std::move(described));
  });
}

std::vector<SurfaceRadiation> readSurface(const sdf::ElementPtr& visual, const SdfContext& context) {
  std::vector<SurfaceRadiation> result;
  forEachOwn(visual, "robotcontrol:surface", [&](const sdf::ElementPtr& element) {
    result.push_back({className(element, "class", context),
                      ownNumber(element, "reflects", 0, 0, kMost, context),
                      ownNumber(element, "emits", 0, 0, kMost, context)});
  });
  return result;
}

std::vector<ClassIntensity> readIntensities(const sdf::ElementPtr& element, const SdfContext& context) {
  std::vector<ClassIntensity> result;
  forEachOwn(element, "robotcontrol:intensity", [&](const sdf::ElementPtr& child) {
    result.push_back({className(child, "class", context),
                      context.within(child->Get<double>(), 0, kMost, "intensity", child)});
  });
  return result;
}

std::vector<Emitter> readEmitters(const sdf::ElementPtr& link, const SdfContext& context) {
  std::vector<Emitter> result;
  forEachOwn(link, "robotcontrol:emitter", [&](const sdf::ElementPtr& element) {
    Emitter emitter;
    if (element->HasElement("robotcontrol:position")) {
      std::istringstream stream(element->Get<std::string>("robotcontrol:position"));
      for (int k = 0; k < 3; ++k) {
        stream >> emitter.positionInLink[k];
        emitter.positionInLink[k] =
            context.within(emitter.positionInLink[k], -1000, 1000, "position", element);
      }
    }
    emitter.attenuation = ownNumber(element, "attenuation", 0, 0, kMost, context);
    emitter.classes = readIntensities(element, context);
    if (emitter.classes.empty()) {
      context.fail(element, "scene.radiation",
                   "an emitter needs a <robotcontrol:intensity class=\"...\">: what it emits");
    }
    result.push_back(std::move(emitter));
  });
  return result;
}

std::vector<RadiationClass> readClasses(const sdf::ElementPtr& world, const SdfContext& context) {
  std::vector<RadiationClass> result;
  forEachOwn(world, "robotcontrol:radiation", [&](const sdf::ElementPtr& element) {
    result.push_back(
        {className(element, "name", context), ownNumber(element, "ambient", 0, 0, kMost, context)});
    const bool twice = std::ranges::count(result, result.back().name, &RadiationClass::name) > 1;
    if (twice)
      context.fail(element, "scene.radiation", "the class '" + result.back().name + "' is declared twice");
  });
  return result;
}

}  // namespace simcore
