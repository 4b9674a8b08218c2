// SPDX-License-Identifier: GPL-3.0-or-later
// Simulation: acting by hand on models that move, and the forces in the world.
#include <cmath>

#include "robotlink/base/Spelling.h"
#include "simcore/Simulation.h"
#include "simcore/SimulationState.h"

namespace simcore {
namespace {

using robotlink::failure;

constexpr double kMaxPushSeconds = 60;

/// Whether all of a vector can be computed with.
bool isUsable(const Vector3& vector) {
  return vector.allFinite() && vector.norm() < 1e7;
}

auto unusable(const std::string& path) {
  return failure("simulation.hand", "the numbers for '" + path + "' are too large", {}, {path});
}

robotlink::Error fixedModel(const std::string& name) {
  return {"simulation.static-model", "'" + name + "' is fixed to the world", {name}, {}};
}

/// The part of a path before the first slash, and the name of the link behind it; see WorldObject.path.
std::pair<std::string, std::string> splitPath(const std::string& path) {
  const auto slash = path.find('/');
  if (slash == std::string::npos) return {path, {}};
  std::string link = path.substr(slash + 1);
  constexpr std::string_view kPrefix = "link:";
  if (link.starts_with(kPrefix)) link.erase(0, kPrefix.size());
  return {path.substr(0, slash), link};
}

}  // namespace

robotlink::Result<void> SimulationState::checkFree(int model) const {
  const ModelInstance& instance = world.models[static_cast<std::size_t>(model)];
  if (instance.type->isStatic || instance.type->isFixedToWorld())
    return tl::unexpected(fixedModel(instance.name));
  return {};
}

robotlink::Result<int> SimulationState::movableModel(const std::string& name) const {
  const int index = modelIndex(name);
  if (index < 0) {
    std::vector<std::string> all;
    for (const ModelInstance& model : world.models) all.push_back(model.name);
    return failure("simulation.unknown-model",
                   "there is no '" + name + "' here" + robotlink::suggestion(name, all), {}, {name});
  }
  if (world.models[static_cast<std::size_t>(index)].type->isStatic) return tl::unexpected(fixedModel(name));
  if (!physics->isMovedByForces(index)) {
    return failure("simulation.kinematic-model",
                   "'" + name + "' moves kinematically, so forces do not move it; place it instead", {},
                   {name});
  }
  return index;
}

robotlink::Result<std::size_t> SimulationState::movableBody(const std::string& path) const {
  const auto [name, link] = splitPath(path);
  const auto model = movableModel(name);
  if (!model) return tl::unexpected(model.error());
  const std::size_t first = physics->bodiesOf(*model).first;
  if (link.empty()) return physics->carrierOf(first);
  const auto& links = world.models[static_cast<std::size_t>(*model)].type->links;
  const auto found = std::ranges::find(links, link, &LinkDescription::name);
  if (found == links.end()) {
    std::vector<std::string> all;
    for (const LinkDescription& each : links) all.push_back(each.name);
    return failure("simulation.unknown-link",
                   "'" + name + "' has no link '" + link + "'" + robotlink::suggestion(link, all), {},
                   {path});
  }
  return physics->carrierOf(first + static_cast<std::size_t>(found - links.begin()));
}

std::string SimulationState::linkPath(std::size_t body) const {
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const auto [first, count] = physics->bodiesOf(static_cast<int>(i));
    if (body < first || body >= first + count) continue;
    return world.models[i].name + "/link:" + world.models[i].type->links[body - first].name;
  }
  return {};
}

robotlink::Result<void> Simulation::turnModel(const std::string& model, double heading, double roll,
                                              double pitch) {
  Implementation& i = *implementation_;
  const int index = i.modelIndex(model);
  if (index < 0) return tl::unexpected(i.movableModel(model).error());
  if (auto free = i.checkFree(index); !free) return free;
  if (!isUsable({heading, roll, pitch})) return unusable(model);
  i.note(CommandKind::kTurn, 0, {heading, roll, pitch}, model);
  const Eigen::Translation3d origin(i.physics->modelInWorld(index).translation());
  return i.tryMove(index, Pose3(origin * Eigen::AngleAxisd(heading, Vector3::UnitZ()) *
                                Eigen::AngleAxisd(pitch, Vector3::UnitY()) *
                                Eigen::AngleAxisd(roll, Vector3::UnitX()) * origin.inverse()));
}

robotlink::Result<void> Simulation::throwModel(const std::string& model, const Vector3& velocity,
                                               const Vector3& spin) {
  Implementation& i = *implementation_;
  const auto index = i.movableModel(model);
  if (!index) return tl::unexpected(index.error());
  if (auto free = i.checkFree(*index); !free) return free;
  if (!isUsable(velocity) || !isUsable(spin)) return unusable(model);
  i.note(CommandKind::kThrow, 0, {velocity.x(), velocity.y(), velocity.z(), spin.x(), spin.y(), spin.z()},
         model);
  i.physics->throwModel(*index, velocity, spin);
  i.sensing->adoptVelocitiesOf(*index);
  i.invalidate();
  return {};
}

robotlink::Result<void> Simulation::pin(const std::string& path, bool on) {
  Implementation& i = *implementation_;
  const auto body = i.movableBody(path);
  if (!body) return tl::unexpected(body.error());
  i.note(CommandKind::kPin, 0, {on ? 1.0 : 0.0}, path);
  i.physics->setPinned(*body, on);
  i.invalidate();
  return {};
}

std::vector<std::string> Simulation::pinned() const {
  const Implementation& i = *implementation_;
  std::vector<std::string> paths;
  for (std::size_t body = 0; body < i.physics->bodyCount(); ++body) {
    if (i.physics->carrierOf(body) == body && i.physics->isPinned(body)) paths.push_back(i.linkPath(body));
  }
  return paths;
}

robotlink::Result<void> Simulation::drag(const std::string& path, const Vector3& grip, const Vector3& target,
                                         double strength) {
  Implementation& i = *implementation_;
  const auto body = i.movableBody(path);
  if (!body) return tl::unexpected(body.error());
  if (!isUsable(grip) || !isUsable(target) || !(strength > 0 && strength <= 100)) return unusable(path);
  i.note(CommandKind::kDrag, 0, {grip.x(), grip.y(), grip.z(), target.x(), target.y(), target.z(), strength},
         path);
  i.hands->drag(*body, grip, target, strength);
  return {};
}

void Simulation::release(const std::string& path) {
  Implementation& i = *implementation_;
  i.note(CommandKind::kRelease, 0, {}, path);
  if (path.empty()) return i.hands->releaseAll();
  if (const auto body = i.movableBody(path)) i.hands->release(*body);
}

std::vector<std::string> Simulation::dragged() const {
  std::vector<std::string> paths;
  for (const std::size_t body : implementation_->hands->dragged())
    paths.push_back(implementation_->linkPath(body));
  return paths;
}

robotlink::Result<void> Simulation::push(const std::string& path, const Vector3& force, const Vector3& point,
                                         double seconds) {
  Implementation& i = *implementation_;
  const auto body = i.movableBody(path);
  if (!body) return tl::unexpected(body.error());
  if (!isUsable(force) || !isUsable(point) || !(seconds >= 0 && seconds <= kMaxPushSeconds))
    return unusable(path);
  i.note(CommandKind::kPush, 0, {force.x(), force.y(), force.z(), point.x(), point.y(), point.z(), seconds},
         path);
  i.hands->push(*body, force, point,
                std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(seconds / kStepSeconds))));
  return {};
}

void Simulation::readForces(bool on) {
  if (implementation_->readsForces == on) return;
  implementation_->readsForces = on;
  implementation_->physics->readContacts(on);
}

Forces Simulation::forces() const {
  const Implementation& i = *implementation_;
  Forces forces;
  const auto nameOf = [&](const std::optional<std::size_t>& body, int model) {
    return body ? i.linkPath(*body) : i.world.models[static_cast<std::size_t>(model)].name;
  };
  for (const Physics::Contact& contact : i.physics->contacts()) {
    forces.contacts.push_back({nameOf(contact.firstBody, contact.firstModel),
                               nameOf(contact.secondBody, contact.secondModel), contact.point, contact.normal,
                               contact.depth, contact.force});
  }
  std::size_t hinge = 0;
  for (const ModelInstance& model : i.world.models) {
    if (model.type->isStatic) continue;
    for (const JointDescription& joint : model.type->joints) {
      if (!joint.hasPosition()) continue;
      const Physics::Wrench exerted = i.physics->reaction(hinge);
      forces.joints.push_back(
          {model.name + "/joint:" + joint.name, i.physics->anchorOf(hinge), exerted.force, exerted.torque});
      ++hinge;
    }
  }
  for (const Hands::Force& force : i.hands->forces()) {
    forces.hands.push_back({force.isDrag ? HandForce::Kind::kDrag : HandForce::Kind::kPush,
                            i.linkPath(force.body), force.point, force.target, force.force});
  }
  return forces;
}

}  // namespace simcore
