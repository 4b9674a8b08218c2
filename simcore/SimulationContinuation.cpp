// SPDX-License-Identifier: GPL-3.0-or-later
// How a simulation starts, and goes on in another scene: checkStart() and takeOver() of SimulationState.h,
// continueIn() and continueFrom() of Simulation.h.
#include <algorithm>
#include <utility>

#include "simcore/Simulation.h"
#include "simcore/SimulationState.h"

namespace simcore {
namespace {

/// Whether two descriptions of a model have the same links and joints, at the same places.
bool hasSameParts(const ModelDescription& a, const ModelDescription& b) {
  const auto sameLink = [](const LinkDescription& one, const LinkDescription& other) {
    return one.name == other.name && one.poseInModel.isApprox(other.poseInModel) &&
           (one.centerOfMass - other.centerOfMass).norm() < 1e-9;
  };
  const auto sameJoint = [](const JointDescription& one, const JointDescription& other) {
    return one.name == other.name && one.kind == other.kind && one.parent == other.parent &&
           one.child == other.child && one.wheel == other.wheel &&
           (one.anchorInModel - other.anchorInModel).norm() < 1e-9 &&
           (one.axisInModel - other.axisInModel).norm() < 1e-9;
  };
  return a.isStatic == b.isStatic && a.drive.has_value() == b.drive.has_value() &&
         std::ranges::equal(a.links, b.links, sameLink) && std::ranges::equal(a.joints, b.joints, sameJoint);
}

/// Whether a model of a scene goes on as the one of the same name in another scene: what was changed in it
/// has to do neither with its parts nor with its place.
bool goesOnAs(const ModelInstance& before, const ModelInstance& now) {
  return hasSameParts(*before.type, *now.type) &&
         before.poseInWorld.matrix().isApprox(now.poseInWorld.matrix(), 1e-9);
}

/// Whether two worlds have the same sensors, servos and drives in the same order.
bool samePorts(const Ports& a, const Ports& b) {
  const auto same = [](const auto& one, const auto& other) {
    return one.info.path == other.info.path && one.info.type == other.info.type &&
           one.info.shape == other.info.shape;
  };
  const auto sameRange = [](const RangeSensor& one, const RangeSensor& other) {
    return one.info.path == other.info.path && one.kind == other.kind && one.readings == other.readings &&
           one.period == other.period && one.startAngle == other.startAngle &&
           one.endAngle == other.endAngle && one.maximum == other.maximum;
  };
  const auto sameDrive = [](const WheelDrive& one, const WheelDrive& other) {
    return one.info.path == other.info.path && one.controller == other.controller &&
           one.wheelRadius == other.wheelRadius && one.track == other.track &&
           one.maximumSpeed == other.maximumSpeed;
  };
  return std::ranges::equal(a.sensors, b.sensors, same) && std::ranges::equal(a.cameras, b.cameras, same) &&
         std::ranges::equal(a.servos, b.servos, same) && std::ranges::equal(a.doors, b.doors, same) &&
         std::ranges::equal(a.ranges, b.ranges, sameRange) &&
         std::ranges::equal(a.drives, b.drives, sameDrive);
}

}  // namespace

robotlink::Result<void> SimulationState::checkStart() {
  const auto isOurs = [](const ModelInstance& model) {
    return !model.type->robot.empty() || model.type->isBall;
  };
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const int other = physics->overlappedModel(static_cast<int>(i), kMaxOverlap);
    if (other < 0) continue;
    const ModelInstance& model = world.models[i];
    const ModelInstance& otherModel = world.models[static_cast<std::size_t>(other)];
    const std::string text = "'" + model.name + "' starts inside '" + otherModel.name + "'";
    if (isOurs(model) || isOurs(otherModel)) {
      return robotlink::failure("scene.overlap", text + ": move one of them", model.where,
                                {model.name, otherModel.name});
    }
    leaveOut(overlaps, {model.where, model.name, text, "they push each other apart"});
  }
  return {};
}

std::vector<std::string> SimulationState::takeOverModels(const SimulationState& before,
                                                         std::vector<int>& kept) {
  std::vector<std::string> putBack;
  std::vector<std::pair<int, std::vector<Physics::BodyMotion>>> starts;
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const ModelInstance& model = world.models[i];
    const int was = before.modelIndex(model.name), now = static_cast<int>(i);
    if (was < 0 || model.type->isStatic) continue;
    if (!goesOnAs(before.world.models[static_cast<std::size_t>(was)], model)) {
      putBack.push_back(model.name);
      continue;
    }
    starts.emplace_back(now, physics->motionOf(now));
    physics->setMotion(now, before.physics->motionOf(was));
  }
  // A model that overlapped before, such as in a hard collision, may go on so.
  const auto isInside = [&](int model) {
    const int was = before.modelIndex(world.models[static_cast<std::size_t>(model)].name);
    return physics->overlappedModel(model, kMaxOverlap) >= 0 &&
           before.physics->overlappedModel(was, kMaxOverlap) < 0;
  };
  // Each turn puts one back; with all of them back it is the start, which is known to fit.
  while (true) {
    const auto inside = std::ranges::find_if(starts, [&](const auto& one) { return isInside(one.first); });
    if (inside == starts.end()) break;
    physics->setMotion(inside->first, inside->second);
    putBack.push_back(world.models[static_cast<std::size_t>(inside->first)].name);
    starts.erase(inside);
  }
  for (const auto& [model, motion] : starts) kept.push_back(model);
  return putBack;
}

void SimulationState::takeOverPorts(const SimulationState& before, const std::vector<int>& kept) {
  const auto isKept = [&](const PortInfo& info) {
    return std::ranges::find(kept, modelIndex(info.robot)) != kept.end();
  };
  for (std::size_t i = 0; i < ports.servos.size(); ++i) {
    const PortInfo& info = ports.servos[i].info;
    const auto was = std::ranges::find(
        before.ports.servos, info.path, [](const Servo& servo) -> const auto& { return servo.info.path; });
    if (!isKept(info) || was == before.ports.servos.end()) continue;
    actuation->takeOver(i, *before.actuation, static_cast<std::size_t>(was - before.ports.servos.begin()));
  }
  for (std::size_t i = 0; i < ports.doors.size(); ++i) {
    const PortInfo& info = ports.doors[i].info;
    const auto was = std::ranges::find(
        before.ports.doors, info.path, [](const Door& door) -> const auto& { return door.info.path; });
    if (!isKept(info) || was == before.ports.doors.end()) continue;
    doors->takeOver(i, *before.doors, static_cast<std::size_t>(was - before.ports.doors.begin()));
  }
  for (std::size_t i = 0; i < ports.drives.size(); ++i) {
    const PortInfo& info = ports.drives[i].info;
    const auto was = std::ranges::find(
        before.ports.drives, info.path,
        [](const WheelDrive& drive) -> const auto& { return drive.info.path; });
    if (!isKept(info) || was == before.ports.drives.end()) continue;
    const auto index = static_cast<std::size_t>(was - before.ports.drives.begin());
    physics->copySide(2 * i, *before.physics, 2 * index);
    physics->copySide(2 * i + 1, *before.physics, 2 * index + 1);
  }
}

std::vector<std::string> SimulationState::takeOver(const SimulationState& before) {
  std::vector<int> kept;
  std::vector<std::string> putBack = takeOverModels(before, kept);
  takeOverPorts(before, kept);
  for (const int model : kept) sensing->adoptVelocitiesOf(model);
  steps = before.steps;
  ballContacts = before.ballContacts;
  for (std::size_t r = 0; r < robots.size(); ++r) {
    const auto* touches = before.obstaclesOf(world.models[static_cast<std::size_t>(robots[r])].name);
    if (touches != nullptr) obstacles[r] = *touches;
  }
  readWheels();
  invalidate();
  return putBack;
}

robotlink::Result<SceneChange> Simulation::continueIn(std::shared_ptr<const Scene> scene) {
  auto next = std::make_unique<Implementation>(std::move(scene), implementation_->options);
  if (auto fits = next->checkStart(); !fits) return tl::unexpected(fits.error());
  if (!samePorts(implementation_->ports, next->ports)) return SceneChange{};
  std::vector<std::string> putBack = next->takeOver(*implementation_);
  next->chosenErrors = implementation_->chosenErrors;
  for (const auto& [sensor, errors] : next->chosenErrors)
    next->sensing->setErrors(sensor, errors, next->noise());
  const auto before = std::exchange(implementation_, std::move(next));
  startControllers();
  implementation_->takeOverControl(*before);
  return SceneChange{true, std::move(putBack)};
}

std::vector<std::string> Simulation::continueFrom(const Simulation& before) {
  std::vector<std::string> putBack = implementation_->takeOver(*before.implementation_);
  implementation_->takeOverControl(*before.implementation_);
  return putBack;
}

}  // namespace simcore
