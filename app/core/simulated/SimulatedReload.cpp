// SPDX-License-Identifier: GPL-3.0-or-later
// SimulatedRun: going on in a scene whose file was edited.
#include <algorithm>
#include <utility>

#include "app/core/program/RecordingTap.h"
#include "app/core/simulated/SimulatedRun.h"
#include "robotlink/base/GroundMap.h"
#include "simcore/Scene.h"

namespace app {

using robotlink::Errors;

bool SimulatedRun::hasSameRobots(const simcore::Scene& scene) const {
  const simcore::Scene& before = world_->simulation().scene();
  const auto same = [](const auto& one, const auto& other) {
    return one.name == other.name && one.description == other.description && one.team == other.team;
  };
  // Robots have the map, so one that was read anew is not theirs.
  return std::ranges::equal(before.robots(), scene.robots(), same) && before.field() == scene.field() &&
         before.balls() == scene.balls() && before.groundMap() == nullptr && scene.groundMap() == nullptr;
}

tl::expected<SimulatedRun::Reloaded, Errors> SimulatedRun::reload() {
  auto scene = readScene();
  if (!scene) return tl::unexpected(std::move(scene.error()));
  if (!hasSameRobots(**scene)) return Reloaded{};
  // Controllers are made anew, and may fail again.
  endedControllers_.clear();
  // Threads of programs must not see a world that is exchanged; in lockstep nothing runs now.
  if (options_.executor() != ExecutorKind::kLockstep) return exchangeWorld(std::move(*scene));
  auto change = world_->continueIn(*scene);
  if (!change) return tl::unexpected(Errors{change.error()});
  // Platforms know sensors and motors by their numbers.
  if (!change->hasSamePorts) return exchangeWorld(std::move(*scene));
  if (tap_) recordWorld();
  return Reloaded{.inPlace = true, .startedPrograms = false, .putBack = std::move(change->putBack)};
}

tl::expected<SimulatedRun::Reloaded, Errors> SimulatedRun::exchangeWorld(
    std::shared_ptr<const simcore::Scene> scene) {
  auto other = SimulatedWorld::create(std::move(scene), world_->options());
  if (!other) return tl::unexpected(Errors{other.error()});
  // Made before anything is given up: a file may have been broken meanwhile.
  auto before = makePrograms(options_.layouts);
  if (!before) return tl::unexpected(std::move(before.error()));
  stopPrograms();
  std::vector<std::string> putBack = (*other)->continueFrom(*world_);
  std::swap(world_, *other);
  auto programs = makePrograms(options_.layouts);
  if (!programs) {
    std::swap(world_, *other);
    startPrograms(std::move(*before));
    return tl::unexpected(std::move(programs.error()));
  }
  before->clear();
  ports_.reset();
  kickOff_ = options_.kickOffs ? KickOff::create(field_, world_->simulation()) : nullptr;
  startPrograms(std::move(*programs));
  if (!hasEnded()) leftOverWorlds_.push_back(std::move(*other));
  if (auto opened = openPorts(); !opened && listeners_.ports) listeners_.ports(opened.error().text);
  return Reloaded{.inPlace = true, .startedPrograms = true, .putBack = std::move(putBack)};
}

}  // namespace app
