// SPDX-License-Identifier: GPL-3.0-or-later
// How a simulation starts, and continues in another scene: checkPlaces() and takeOver() of SimulationState.h,
// continueIn() and continueFrom() of Simulation.h.
#include <algorithm>
#include <utility>

#include "simcore/Simulation.h"
#include "simcore/SimulationState.h"
#include "simcore/world/WorldSize.h"

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

/// Whether a model of a scene continues as the one of the same name in another scene: its changes
/// concern neither its parts nor its place.
bool goesOnAs(const ModelInstance& before, const ModelInstance& now) {
  return hasSameParts(*before.type, *now.type) &&
         before.poseInWorld.matrix().isApprox(now.poseInWorld.matrix(), 1e-9);
}

/// Compares the ports of two worlds: all, or only those of a model.
class PortComparison {
 public:
  /// `model` empty: all.
  PortComparison(const Ports& a, const Ports& b, std::string model = {})
      : a_(a), b_(b), model_(std::move(model)) {}

  /// Whether both have the same sensors, servos and drives in the same order.
  bool areSame() const {
    const auto same = [](const auto& one, const auto& other) {
      return one.info.type == other.info.type && one.info.shape == other.info.shape;
    };
    const auto sameRange = [](const RangeSensor& one, const RangeSensor& other) {
      return one.kind == other.kind && one.readings == other.readings && one.period == other.period &&
             one.startAngle == other.startAngle && one.endAngle == other.endAngle &&
             one.maximum == other.maximum;
    };
    const auto sameDrive = [](const WheelDrive& one, const WheelDrive& other) {
      return one.controller == other.controller && one.wheelRadius == other.wheelRadius &&
             one.track == other.track && one.maximumSpeed == other.maximumSpeed;
    };
    return areSame(a_.sensors, b_.sensors, same) && areSame(a_.cameras, b_.cameras, same) &&
           areSame(a_.servos, b_.servos, same) && areSame(a_.doors, b_.doors, same) &&
           areSame(a_.ranges, b_.ranges, sameRange) && areSame(a_.drives, b_.drives, sameDrive);
  }

 private:
  template <typename List, typename Same>
  bool areSame(const List& a, const List& b, Same same) const {
    const auto next = [this](auto at, auto end) {
      return std::find_if(at, end,
                          [this](const auto& one) { return model_.empty() || one.info.robot == model_; });
    };
    auto one = next(a.begin(), a.end());
    auto other = next(b.begin(), b.end());
    for (; one != a.end() && other != b.end();
         one = next(std::next(one), a.end()), other = next(std::next(other), b.end())) {
      if (one->info.path != other->info.path || !same(*one, *other)) return false;
    }
    return one == a.end() && other == b.end();
  }

  const Ports& a_;
  const Ports& b_;
  const std::string model_;
};

std::vector<std::string> changedPorts(const SimulationState& before, const SimulationState& now) {
  std::vector<std::string> changed;
  for (const ModelInstance& model : now.world.models) {
    if (before.modelIndex(model.name) < 0) continue;
    if (!PortComparison(before.ports, now.ports, model.name).areSame()) changed.push_back(model.name);
  }
  return changed;
}

}  // namespace

bool SimulationState::wasFree(int model, const SimulationState& before) const {
  const int was = before.modelIndex(world.models[static_cast<std::size_t>(model)].name);
  return was < 0 || before.physics->overlappedModel(was, kMaxOverlap) < 0;
}

robotlink::Result<void> SimulationState::checkPlaces(const SimulationState* before) {
  const auto isOurs = [](const ModelInstance& model) {
    return !model.type->robot.empty() || model.type->isBall;
  };
  const std::string verb = before != nullptr ? "' would be inside '" : "' starts inside '";
  std::size_t pairs = 0;  // each is counted by both of its models
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const int index = static_cast<int>(i), other = physics->overlappedModel(index, kMaxOverlap, &pairs);
    if (other < 0 || (before != nullptr && !wasFree(index, *before))) continue;
    const ModelInstance& model = world.models[i];
    const ModelInstance& otherModel = world.models[static_cast<std::size_t>(other)];
    const std::string text = "'" + model.name + verb + otherModel.name + "'";
    if (isOurs(model) || isOurs(otherModel)) {
      return robotlink::failure("scene.overlap", text + ": move one of them", model.where,
                                {model.name, otherModel.name});
    }
    if (pairs >= kMaxOverlaps) {
      return robotlink::failure("scene.overlap",
                                text + ", and so do too many others (more than " +
                                    std::to_string(kMaxOverlaps / 2) + " pairs of solids): move them apart",
                                model.where, {model.name, otherModel.name});
    }
    leaveOut(overlaps, {model.where, model.name, text, "they push each other apart"});
  }
  return {};
}

robotlink::Result<void> SimulationState::checkFits(const SimulationState& before) const {
  const auto goesOn = [&](int index) {
    const ModelInstance& model = world.models[static_cast<std::size_t>(index)];
    const int was = before.modelIndex(model.name);
    return was >= 0 && goesOnAs(before.world.models[static_cast<std::size_t>(was)], model);
  };
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const int model = static_cast<int>(i), other = physics->overlappedModel(model, kMaxOverlap);
    if (other < 0 || !wasFree(model, before)) continue;
    // A model that continues as it was is not the one that does not fit.
    const bool isOther = goesOn(model) && !goesOn(other);
    const std::string& added = world.models[static_cast<std::size_t>(isOther ? other : model)].name;
    const std::string& standing = world.models[static_cast<std::size_t>(isOther ? model : other)].name;
    return robotlink::failure(
        "scene.no-room",
        "there is no room for '" + added + "': it would be inside '" + standing + "'; choose another place",
        {}, {added, standing});
  }
  return {};
}

void SimulationState::beginNewModels(const SimulationState& before, const Continuation& how) {
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const ModelInstance& model = world.models[i];
    const auto motion = how.motions.find(model.name);
    if (before.modelIndex(model.name) >= 0 || motion == how.motions.end() || !motion->second) continue;
    if (goesOnAs(motion->second->model, model))
      physics->setMotion(static_cast<int>(i), motion->second->bodies);
  }
}

robotlink::Result<std::vector<std::string>> SimulationState::takeOverModels(const SimulationState& before,
                                                                            const Continuation& how,
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
  beginNewModels(before, how);
  if (how.fitsNow) {
    if (auto fits = checkFits(before); !fits) return tl::unexpected(fits.error());
  }
  // A model that overlapped before, such as in a hard collision, may continue to do so.
  const auto isInside = [&](int model) {
    return physics->overlappedModel(model, kMaxOverlap) >= 0 && wasFree(model, before);
  };
  // Each turn puts one back; with all of them back it is the start.
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
    actuation->takeOver(i, *before.actuation, static_cast<std::size_t>(was - before.ports.servos.begin()),
                        steps - before.steps);
  }
  for (std::size_t i = 0; i < ports.doors.size(); ++i) {
    const PortInfo& info = ports.doors[i].info;
    const auto was = std::ranges::find(
        before.ports.doors, info.path, [](const Door& door) -> const auto& { return door.info.path; });
    if (!isKept(info) || was == before.ports.doors.end()) continue;
    doors->takeOver(i, *before.doors, static_cast<std::size_t>(was - before.ports.doors.begin()),
                    before.steps, steps);
  }
  for (std::size_t i = 0; i < ports.guides.size(); ++i) {
    const PortInfo& info = ports.guides[i].info;
    const auto was = std::ranges::find(
        before.ports.guides, info.path, [](const Guide& guide) -> const auto& { return guide.info.path; });
    const bool fits = was != before.ports.guides.end() && was->info.shape == info.shape;
    if (!isKept(info) || !fits) continue;
    actuation->takeOverGuide(i, *before.actuation,
                             static_cast<std::size_t>(was - before.ports.guides.begin()));
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

robotlink::Result<std::vector<std::string>> SimulationState::takeOver(const SimulationState& before,
                                                                      const Continuation& how) {
  std::vector<int> kept;
  auto putBack = takeOverModels(before, how, kept);
  if (!putBack) return putBack;
  steps = before.steps;
  takeOverPorts(before, kept);
  for (const int model : kept) sensing->adoptVelocitiesOf(model);
  ballContacts = before.ballContacts;
  for (std::size_t r = 0; r < robots.size(); ++r) {
    const auto* touches = before.obstaclesOf(world.models[static_cast<std::size_t>(robots[r])].name);
    if (touches != nullptr) obstacles[r] = *touches;
  }
  readWheels();
  invalidate();
  return putBack;
}

std::map<std::string, SensorErrors> SimulationState::errorsByPath() const {
  std::map<std::string, SensorErrors> errors;
  for (const auto& [sensor, chosen] : chosenErrors) errors[ports.sensors[sensor].info.path] = chosen;
  const auto add = [&](const auto& sensors, const std::vector<TimedSensor>& timing) {
    for (std::size_t i = 0; i < timing.size(); ++i) {
      if (timing[i].chosen) errors[sensors[i].info.path] = timing[i].errors;
    }
  };
  add(ports.ranges, rangeTiming);
  add(ports.images, imageTiming);
  add(ports.cameras, cameraTiming);
  return errors;
}

robotlink::Result<SceneChange> Simulation::continueIn(std::shared_ptr<const Scene> scene,
                                                      const Continuation& how) {
  auto next = std::make_unique<Implementation>(std::move(scene), implementation_->options);
  const bool same = PortComparison(implementation_->ports, next->ports).areSame();
  if (!same && !how.otherPorts) return SceneChange{};
  auto putBack = next->takeOver(*implementation_, how);
  if (!putBack) return tl::unexpected(putBack.error());
  if (auto fits = next->checkPlaces(implementation_.get()); !fits) return tl::unexpected(fits.error());
  std::vector<std::string> changed;
  if (!same) changed = changedPorts(*implementation_, *next);
  next->readsForces = implementation_->readsForces;
  next->physics->readContacts(next->readsForces);
  next->rewind = std::move(implementation_->rewind);
  before_ = std::exchange(implementation_, std::move(next));
  startControllers();
  implementation_->takeOverControl(*before_);
  implementation_->clearRewind();
  for (const auto& [path, errors] : before_->errorsByPath()) {
    // A sensor that is gone has none.
    if (port(path) != nullptr) static_cast<void>(setSensorErrors(path, errors));
  }
  return SceneChange{same, std::move(changed), std::move(*putBack)};
}

void Simulation::goBack() {
  if (!before_) return;
  before_->rewind = std::move(implementation_->rewind);
  implementation_ = std::move(before_);
  implementation_->clearRewind();
}

std::shared_ptr<const ModelMotion> Simulation::motionOf(const std::string& model) const {
  const int index = implementation_->modelIndex(model);
  if (index < 0) return nullptr;
  const ModelInstance& instance = implementation_->world.models[static_cast<std::size_t>(index)];
  if (instance.type->isStatic) return nullptr;
  return std::make_shared<const ModelMotion>(
      ModelMotion{instance, implementation_->physics->motionOf(index)});
}

std::vector<std::string> Simulation::continueFrom(const Simulation& before) {
  std::vector<std::string> putBack = *implementation_->takeOver(*before.implementation_, {});
  implementation_->takeOverControl(*before.implementation_);
  implementation_->clearRewind();
  return putBack;
}

}  // namespace simcore
