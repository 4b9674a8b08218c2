// SPDX-License-Identifier: GPL-3.0-or-later
// SimulatedRun: going on in a scene with other models, whether its file was edited or they were added and
// removed by hand.
#include <algorithm>
#include <set>
#include <utility>

#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RecordingTap.h"
#include "app/platforms/simulated/SimulatedPlatform.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "simcore/Scene.h"
#include "simcore/world/WorldDescription.h"

namespace app {

using robotlink::Errors;

namespace {

bool containsName(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

tl::expected<SimulatedRun::Reloaded, Errors> SimulatedRun::reload(simcore::SceneTexts texts, bool mustFit) {
  std::swap(options_.texts, texts);
  auto done = goOn(mustFit);
  // Texts that cannot be run must not affect the next reader of the scene.
  if (!done) std::swap(options_.texts, texts);
  return done;
}

tl::expected<SimulatedRun::Reloaded, Errors> SimulatedRun::goOn(bool mustFit) {
  auto scene = readScene();
  if (!scene) return tl::unexpected(std::move(scene.error()));
  const simcore::Scene& before = world_->simulation().scene();
  // Robots have field and map, so others than before are not theirs.
  const bool isOther = before.field() != (*scene)->field() || before.groundMap() != nullptr ||
                       (*scene)->groundMap() != nullptr;
  if (isOther) return Reloaded{};
  // Controllers are remade, and may fail again.
  endedControllers_.clear();
  const auto next = withEdits(*scene);
  const auto hasModel = [](const simcore::Scene& in, const std::string& name) {
    return std::ranges::count(in.world().models, name, &simcore::ModelInstance::name) > 0;
  };
  const auto isThere = [&](const std::string& name) { return hasModel(*next, name); };
  auto motions = goneMotions_;
  std::erase_if(motions, [&](const auto& one) { return isThere(one.first); });
  std::vector<std::string> gone, come;
  for (const auto& model : before.world().models) {
    if (isThere(model.name)) continue;
    motions[model.name] = world_->simulation().motionOf(model.name);
    gone.push_back(model.name);
  }
  for (const auto& model : next->world().models)
    if (!hasModel(before, model.name)) come.push_back(model.name);
  simcore::Continuation how{.fitsNow = mustFit, .motions = goneMotions_};
  // Under another name the same model goes on where it is.
  if (gone.size() == 1 && come.size() == 1) how.motions[come.front()] = motions[gone.front()];
  auto done = goOnIn(next, std::move(how));
  if (!done) return done;
  read_ = *scene;
  goneMotions_ = std::move(motions);
  return done;
}

tl::expected<SimulatedRun::Reloaded, Errors> SimulatedRun::goOnIn(std::shared_ptr<const simcore::Scene> scene,
                                                                  simcore::Continuation how) {
  auto fresh = newHosts(*scene);
  if (!fresh) return tl::unexpected(std::move(fresh.error()));
  const bool isSame = fresh->empty() && scene->robots().size() == robots_.size();
  if (isSame && options_.executor() == ExecutorKind::kLockstep) {
    // No program runs now, so none has to be notified.
    auto change = world_->continueIn(scene, how);
    if (!change) return tl::unexpected(Errors{change.error()});
    if (change->hasSamePorts) {
      spoilJournal("the scene was edited");
      followModels();
      if (tap_) recordWorld();
      return Reloaded{.inPlace = true, .started = {}, .ended = {}, .putBack = std::move(change->putBack)};
    }
  }
  how.otherPorts = true;
  const std::vector<std::string> stopped = stoppedRobots(), pioneers = pioneerNames();
  std::vector<RobotHost*> all;
  for (const auto& robot : robots_) all.push_back(robot.get());
  leftOver_.end(std::move(executor_), all, LeftOverPrograms::Platforms::kReplaced);
  auto change = world_->continueIn(scene, how);
  if (!change) {
    resumePrograms();
    return tl::unexpected(Errors{change.error()});
  }
  auto next = makeSuccessors(*fresh, change->changedPorts);
  if (!next) {
    world_->goBack();
    resumePrograms();
    return tl::unexpected(std::move(next.error()));
  }
  spoilJournal("the scene was edited");
  Reloaded done{.inPlace = true, .started = {}, .ended = {}, .putBack = std::move(change->putBack)};
  done.ended = exchangeHosts(std::move(*fresh));
  for (std::size_t i = 0; i < next->robots.size(); ++i) {
    RobotHost& robot = *next->robots[i];
    done.started.push_back(robot.name());
    robot.stop();
    if (tap_) tap_->detach(robot.name());
    robot.adopt(std::move(next->candidates[i]));
    if (containsName(stopped, robot.name())) robot.platform()->engageStop(true);
  }
  followRobots(pioneers);
  if (tap_) recordWorld();
  beginPrograms(next->robots);
  return done;
}

bool SimulatedRun::stays(const RobotHost& robot, const Hosts& fresh) const {
  const auto& placed = world_->simulation().scene().robots();
  return std::ranges::find(placed, robot.name(), &simcore::SceneRobot::name) != placed.end() &&
         std::ranges::none_of(fresh, [&](const auto& host) { return host->name() == robot.name(); });
}

tl::expected<SimulatedRun::Successors, Errors> SimulatedRun::makeSuccessors(
    const Hosts& fresh, const std::vector<std::string>& changed) {
  Successors next;
  for (const auto& robot : robots_) {
    if (!stays(*robot, fresh)) continue;
    // All platforms of a simulation are such ones. A program that does not return is started again.
    auto* platform = static_cast<SimulatedPlatform*>(robot->platform());
    const bool goesOn = robot->program() != nullptr && platform != nullptr && !robot->isStuck() &&
                        !containsName(changed, robot->name()) && platform->rebind();
    if (!goesOn) next.robots.push_back(robot.get());
  }
  for (const auto& robot : fresh) next.robots.push_back(robot.get());
  for (RobotHost* robot : next.robots) {
    const std::filesystem::path file = layoutOf(*robot, options_.layouts);
    auto layout = readLayoutOf(*robot, file);
    if (!layout) return tl::unexpected(std::move(layout.error()));
    auto made = makeProgram(*robot, file, *layout);
    if (!made) return tl::unexpected(std::move(made.error()));
    next.candidates.push_back(std::move(*made));
  }
  return next;
}

std::vector<std::string> SimulatedRun::exchangeHosts(Hosts fresh) {
  Hosts next;
  const auto take = [&](Hosts& from, const std::string& name) {
    const auto found =
        std::ranges::find_if(from, [&](const auto& host) { return host && host->name() == name; });
    if (found == from.end()) return false;
    next.push_back(std::move(*found));
    return true;
  };
  for (const auto& robot : world_->simulation().scene().robots()) {
    if (!take(fresh, robot.name)) take(robots_, robot.name);
  }
  std::vector<std::string> gone;
  for (auto& host : robots_) {
    if (!host) continue;
    host->stop();
    if (tap_) tap_->detach(host->name());
    if (host->platform() != nullptr) host->endPlatform();
    const bool isReplaced =
        std::ranges::any_of(next, [&](const auto& other) { return other->name() == host->name(); });
    if (!isReplaced) gone.push_back(host->name());
  }
  robots_ = std::move(next);
  return gone;
}

void SimulatedRun::resumePrograms() {
  std::vector<RobotHost*> starting;
  for (const auto& robot : robots_) {
    auto* platform = static_cast<SimulatedPlatform*>(robot->platform());
    if (platform != nullptr) platform->rebind();
    if (robot->program() != nullptr && platform != nullptr) continue;
    const std::filesystem::path file = layoutOf(*robot, options_.layouts);
    auto layout = readLayoutOf(*robot, file);
    auto made = layout ? makeProgram(*robot, file, *layout) : tl::unexpected(layout.error());
    if (!made) continue;
    if (tap_) tap_->detach(robot->name());
    robot->adopt(std::move(*made));
    starting.push_back(robot.get());
  }
  // A program that did not return and whose files are broken now cannot continue.
  std::erase_if(robots_, [this](const auto& robot) {
    const bool isLost = robot->program() == nullptr || robot->platform() == nullptr;
    if (isLost && tap_) tap_->detach(robot->name());
    return isLost;
  });
  beginPrograms(starting);
}

std::vector<std::string> SimulatedRun::pioneerNames() const {
  std::vector<std::string> names;
  for (const auto& pioneer : world_->pioneers()) names.push_back(pioneer->robot());
  return names;
}

void SimulatedRun::followRobots(const std::vector<std::string>& pioneersBefore) {
  const std::vector<std::string> names = robots();
  stopSwitch_->setRobots({names.begin(), names.end()});
  // The ports count the Pioneers.
  const bool hasOtherPioneers = pioneerNames() != pioneersBefore;
  if (hasOtherPioneers) ports_.reset();
  world_->forgetGone();
  if (hasOtherPioneers && !world_->pioneers().empty()) {
    if (auto opened = openPorts(); !opened && listeners_.ports) listeners_.ports(opened.error().text);
  }
  followModels();
  if (!umpire_) makeUmpire();
}

}  // namespace app
