// SPDX-License-Identifier: GPL-3.0-or-later
// readWalk(), readMotion() of SdfDevices.h: whether a model moves by forces, and the odometry model of a
// gait.
#include <sstream>

#include "simcore/sdf/SdfDevices.h"
#include "simcore/sdf/SdfReader.h"

namespace simcore {
namespace {

/// Reads the three numbers of one of our elements, each from `minimum` to `maximum`.
void readThree(const sdf::ElementPtr& parent, const char* name, double minimum, double maximum,
               std::array<double, 3>& values, const SdfContext& context) {
  const std::string key = std::string("robotcontrol:") + name;
  if (!parent->HasElement(key)) return;
  const sdf::ElementPtr element = parent->GetElement(key);
  std::istringstream stream(element->Get<std::string>());
  std::array<double, 3> read{};
  const bool isSound = context.orLeaveOut(element, "<" + key + ">", [&](const SdfContext& own) {
    for (double& value : read) {
      stream >> value;
      own.within(value, minimum, maximum, name, element);
    }
  });
  if (isSound) values = read;
}

}  // namespace

void readWalk(const sdf::ElementPtr& element, ModelDescription& model, const SdfContext& context) {
  if (!element->HasElement("robotcontrol:walk")) return;
  const sdf::ElementPtr source = element->GetElement("robotcontrol:walk");
  if (model.isStatic || model.drive || model.guided || model.links.empty()) {
    return context.fail(source, "scene.walk",
                        "a model that walks is not static, and has neither a drive, nor is it guided");
  }
  WalkDescription walk;
  if (source->HasAttribute("name")) walk.name = source->Get<std::string>("name");
  readThree(source, "slip", 0, 10, walk.slip, context);
  readThree(source, "noise", 0, 10, walk.noise, context);
  walk.maximumSpeed = ownNumber(source, "maximum_speed", walk.maximumSpeed, 1e-3, 100, context);
  walk.maximumRate = ownNumber(source, "maximum_rate", walk.maximumRate, 1e-3, 100, context);
  model.walk = walk;
}

std::optional<MotionMode> motionModeOf(const std::string& text, const std::string& atObjects) {
  const bool stops = atObjects == "stop";
  if (!stops && !atObjects.empty() && atObjects != "push") return std::nullopt;
  if (text == "physics") return MotionMode::kPhysics;
  if (text == "kinematic") return stops ? MotionMode::kStopping : MotionMode::kKinematic;
  return std::nullopt;
}

void readMotion(const sdf::ElementPtr& element, ModelDescription& model, const SdfContext& context) {
  if (!element->HasElement("robotcontrol:motion")) return;
  const sdf::ElementPtr source = element->GetElement("robotcontrol:motion");
  const auto mode = motionModeOf(source->Get<std::string>(),
                                 source->HasAttribute("objects") ? source->Get<std::string>("objects") : "");
  if (!mode) return context.fail(source, "scene.motion", kMotionRule);
  model.motion = *mode;
  if (*mode != MotionMode::kPhysics && !model.drive && !model.canFollow())
    context.fail(source, "scene.motion", kMotionNeeds);
  if (*mode != MotionMode::kPhysics && model.drive && source->HasAttribute("objects") &&
      source->Get<std::string>("objects") == "push")
    context.fail(source, "scene.motion", kDrivesStop);
}

}  // namespace simcore
