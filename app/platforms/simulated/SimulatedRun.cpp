// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/SimulatedRun.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/core/platform/PublishGate.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RecordingTap.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/SolutionChoices.h"
#include "app/platforms/SceneMessages.h"
#include "app/platforms/simulated/SimulatedPlatform.h"
#include "app/platforms/simulated/world/WorldObjects.h"
#include "foxglove/Geometry.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/base/threads/ThreadPool.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotUse.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/packages/GamePackages.h"
#include "simcore/Scene.h"
#include "simcore/SceneFileKind.h"

namespace app {

using robotlink::Errors;

namespace {

/// Number of steps between recorded transforms, and forces: about 30 per second.
constexpr int kTransformsEvery = 4;

}  // namespace

RunOptions defaultSimulation() {
  RunOptions options;
  options.scene = robotlink::resource("scenes/field2002.sdf");
  options.world.threads = robotlink::ThreadPool::cores();
  return options;
}

SimulatedRun::SimulatedRun(RunOptions options, Listeners listeners, logplayer::Recorder* recorder)
    : options_(std::move(options)),
      listeners_(std::move(listeners)),
      tap_(recorder != nullptr ? std::make_unique<RecordingTap>(*recorder) : nullptr),
      patience_(std::make_shared<ModulePatience>(options_.patience)),
      ownPatience_(std::make_shared<ModulePatience>(options_.own.patience)) {}

SimulatedRun::~SimulatedRun() {
  if (stopSwitch_) stopSwitch_->forget();
  stopPrograms();
}

tl::expected<std::unique_ptr<SimulatedRun>, Errors> SimulatedRun::create(RunOptions options,
                                                                         Listeners listeners,
                                                                         logplayer::Recorder* recorder) {
  auto run =
      std::unique_ptr<SimulatedRun>(new SimulatedRun(std::move(options), std::move(listeners), recorder));
  if (Errors errors = run->load(); !errors.empty()) return tl::unexpected(std::move(errors));
  return run;
}

tl::expected<std::shared_ptr<const simcore::Scene>, Errors> SimulatedRun::readScene() {
  simcore::RobotsToAdd added = options_.robots.value_or(simcore::RobotsToAdd{});
  if (!options_.robots && simcore::isMapFile(options_.scene)) added.count = 1;
  return simcore::Scene::load(options_.scene, added, std::exchange(options_.progress, {}), options_.models,
                              options_.texts);
}

Errors SimulatedRun::load() {
  auto scene = readScene();
  if (!scene) return scene.error();
  read_ = *scene;
  auto world = SimulatedWorld::create(std::move(*scene), options_.world);
  if (!world) return {world.error()};
  world_ = std::move(*world);
  if (auto opened = openPorts(); !opened) return {opened.error()};
  if (Errors errors = describeRobots(); !errors.empty()) return errors;
  const std::vector<std::string> names = robots();
  stopSwitch_ = std::make_shared<StopSwitch>(
      std::set<std::string>(names.begin(), names.end()),
      [inside = patience_, own = ownPatience_](bool engaged) {
        if (!engaged) return;
        inside->cut();
        own->cut();
      },
      [inside = patience_, own = ownPatience_] {
        inside->end();
        own->end();
      });
  // Robots of this list may belong to another scene.
  std::erase_if(options_.hosting.otherwise,
                [this](const std::string& name) { return find(name) == nullptr; });
  if (Errors errors = makeGame(); !errors.empty()) return errors;
  if (Errors errors = distributeLayout(); !errors.empty()) return errors;
  if (Errors errors = checkChosenSolutions(); !errors.empty()) return errors;
  auto programs = makePrograms(options_.layouts);
  if (!programs) return programs.error();
  if (tap_) tap_->restart();
  startPrograms(std::move(*programs));
  beginJournal();
  return {};
}

robotlink::Result<void> SimulatedRun::openPorts() {
  if (!options_.ports || ports_) return {};
  auto ports = ArcosPorts::open(*world_, *options_.ports, listeners_.ports);
  if (!ports) return tl::unexpected(ports.error());
  ports_ = std::move(*ports);
  return {};
}

tl::expected<SimulatedRun::Candidates, Errors> SimulatedRun::makePrograms(const Layouts& layouts) {
  std::map<std::pair<std::filesystem::path, std::map<std::string, std::string>>, robotlink::Layout> read;
  Candidates candidates;
  for (const auto& robot : robots_) {
    const std::filesystem::path file = layoutOf(*robot, layouts);
    const std::pair key(file, solutionsOf(*robot));
    if (!read.contains(key)) {
      auto layout = readLayoutWith(file, key.second);
      if (!layout) return tl::unexpected(layout.error());
      read[key] = std::move(*layout);
    }
    auto made = makeProgram(*robot, file, read[key]);
    if (!made) return tl::unexpected(made.error());
    candidates.push_back(std::move(*made));
  }
  return candidates;
}

tl::expected<RobotHost::Candidate, Errors> SimulatedRun::makeProgram(RobotHost& robot,
                                                                     const std::filesystem::path& file,
                                                                     const robotlink::Layout& layout) {
  auto platform = SimulatedPlatform::create(*world_, robot.name(), robot.description());
  if (!platform) return tl::unexpected(Errors{platform.error()});
  if (robot.platform() != nullptr) (*platform)->engageStop(robot.platform()->stopEngaged());
  const auto& offers = robot.description().offers;
  if (std::ranges::find(offers, robotlink::kGameState.name) != offers.end())
    (*platform)->joinGame(mailOf(robot.name()));
  if (listeners_.labeled) {
    (*platform)->alwaysSendClasses([this, name = robot.name()](const auto& image, const auto& classes) {
      listeners_.labeled(name, image, classes);
    });
  } else if (options_.classImages) {
    (*platform)->alwaysSendClasses({});
  }
  return robot.make(
      {.platform = std::move(*platform), .file = file, .layout = layout, .maker = makerFor(robot.name())});
}

HostedProgram::Maker SimulatedRun::makerFor(const std::string& robot) const {
  if (options_.instead) return options_.instead;
  if (!options_.hosting.isOwn(robot)) return nullptr;
  OwnProgram::Options own = options_.own;
  own.threads = options_.hosting.threads;
  own.cut = ownPatience_;
  return OwnProgram::maker(own);
}

void SimulatedRun::startPrograms(Candidates candidates) {
  stopPrograms();
  for (std::size_t i = 0; i < robots_.size(); ++i) robots_[i]->adopt(std::move(candidates[i]));
  if (tap_) recordWorld();
  std::vector<RobotHost*> all;
  for (const auto& robot : robots_) all.push_back(robot.get());
  beginPrograms(all);
}

void SimulatedRun::beginPrograms(const std::vector<RobotHost*>& robots) {
  executor_ = std::make_unique<ProgramExecutor>(ProgramExecutor::Options{
      .kind = options_.executor(),
      .advance = [this] { world_->advance(); },
      .ran =
          [this](robotlink::Duration took) {
            programTime_ += took;
            for (const auto& robot : robots_) robot->deliver();
          },
      .pool = world_->pool(),
      .waiting = options_.isWatched ? TurnCrew::Waiting::kAsleep : TurnCrew::Waiting::kAlert,
      .trouble = [this](const auto& process, const auto& text) { reportTrouble(process, text); },
      .patience = options_.patience,
      .cut = patience_,
      .stuck =
          [this](const auto& platform, const std::string& what) {
            for (const auto& robot : robots_)
              if (robot->platform() == &platform) robot->noteStuck(what);
          }});
  lostChoices_.clear();
  for (const auto& robot : robots_) {
    robot->keepReports(options_.executor() == ExecutorKind::kLockstep);
    if (std::ranges::find(robots, robot.get()) == robots.end()) {
      robot->continueIn(*executor_);
      continue;
    }
    for (std::string& lost : robot->begin(*executor_)) lostChoices_.push_back(std::move(lost));
  }
  executor_->start();
}

Errors SimulatedRun::checkHosting(const std::string& name) const {
  if (!name.empty() && find(name) == nullptr)
    return {{"request.no-robot", "there is no robot " + name, {name}, {}}};
  if (options_.instead)
    return {{"program.elsewhere",
             "the programs of these robots run elsewhere; only their bodies are here",
             {},
             {}}};
  return {};
}

std::vector<RobotHost*> SimulatedRun::applyHosting(const std::string& name,
                                                   const robotcontrol::HostProgram& choice) {
  using robotcontrol::HostProgram;
  const HostingChoices before = options_.hosting;
  HostingChoices& now = options_.hosting;
  if (choice.executor() != HostProgram::SAME) now.threads = choice.executor() == HostProgram::THREADS;
  const bool isPlaced = choice.where() != HostProgram::UNCHANGED;
  if (isPlaced) now.choose(name, choice.where() == HostProgram::OWN_PROCESS);
  // Threads are ended together.
  const bool all = before.threads != now.threads || (before.threads && (choice.start_again() || isPlaced));
  std::vector<RobotHost*> changed;
  for (const auto& robot : robots_) {
    const bool isMeant = name.empty() || robot->name() == name;
    const bool isMoved = before.isOwn(robot->name()) != now.isOwn(robot->name());
    if (all || isMoved || (isMeant && choice.start_again()) || robot->isStuck())
      changed.push_back(robot.get());
  }
  return changed;
}

Errors SimulatedRun::hostProgram(const std::string& name, const robotcontrol::HostProgram& choice) {
  if (Errors errors = checkHosting(name); !errors.empty()) return errors;
  const RunOptions before = options_;
  const std::vector<RobotHost*> changed = applyHosting(name, choice);
  if (changed.empty()) return {};
  Errors errors = exchangePrograms(changed);
  if (!errors.empty()) options_ = before;
  return errors;
}

Errors SimulatedRun::exchangePrograms(const std::vector<RobotHost*>& robots) {
  spoilJournal("programs were restarted");
  Candidates candidates;
  for (RobotHost* robot : robots) {
    auto made = makeProgramOnPlatform(*robot);
    if (!made) return made.error();
    candidates.push_back(std::move(*made));
  }
  stopExecutor();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    robots[i]->stop();
    robots[i]->adopt(std::move(candidates[i]));
  }
  beginPrograms(robots);
  return {};
}

tl::expected<RobotHost::Candidate, Errors> SimulatedRun::makeProgramOnPlatform(RobotHost& robot) {
  const std::filesystem::path file = layoutOf(robot, options_.layouts);
  auto layout = readLayoutOf(robot, file);
  if (!layout) return tl::unexpected(layout.error());
  return robot.make(
      {.platform = nullptr, .file = file, .layout = std::move(*layout), .maker = makerFor(robot.name())});
}

void SimulatedRun::stopExecutor() {
  std::vector<RobotHost*> all;
  for (const auto& robot : robots_) all.push_back(robot.get());
  leftOver_.end(std::move(executor_), all);
}

void SimulatedRun::end() {
  stopPrograms();
  ports_.reset();
  for (const auto& robot : robots_) robot->endPlatform();
}

bool SimulatedRun::hasEnded() const {
  return leftOver_.haveEnded();
}

void SimulatedRun::stopPrograms() {
  stopExecutor();
  if (tap_) tap_->clear();
  for (const auto& robot : robots_) robot->stop();
}

void SimulatedRun::recordWorld() {
  if (const auto known = map())
    tap_->world({robotlink::streams::kMap, world_->clock().now(), mapMessage(*known, world_->clock().now())});
  const auto now = world_->clock().now();
  const simcore::Simulation& simulation = world_->simulation();
  tap_->world({robotlink::streams::kScene, now, sceneMessage(simulation, now)});
  tap_->world({robotlink::streams::kSolids, now, solidsMessage(simulation, now)});
  tap_->world({robotlink::streams::kObjects, now, worldObjects(simulation, nullptr, now)});
  stepsToTransforms_ = 0;
}

void SimulatedRun::recordStep() {
  tap_->endStep();
  if (--stepsToTransforms_ > 0) return;
  stepsToTransforms_ = kTransformsEvery;
  const auto now = world_->clock().now();
  if (tap_->wants(robotlink::streams::kTransforms))
    tap_->world({robotlink::streams::kTransforms, now, transformsMessage(world_->simulation(), now)});
  // Forces are measured only after they were requested.
  if (recordsForces_)
    tap_->world({robotlink::streams::kForces, now, forcesMessage(world_->simulation(), now)});
  recordsForces_ = tap_->wants(robotlink::streams::kForces);
  readForces(showsForces_);
}

void SimulatedRun::readForces(bool shown) {
  showsForces_ = shown;
  world_->simulation().readForces(showsForces_ || recordsForces_);
}

void SimulatedRun::reportTrouble(const robotlink::Process& process, const std::string& text) {
  for (const auto& robot : robots_) {
    if (robot->owns(process)) robot->reportTrouble(process, text);
  }
}

void SimulatedRun::step() {
  leftOver_.forgetEnded();
  if (again_) repeatRequests();
  for (const auto& robot : robots_) robot->enqueueRequests();
  if (tap_) tap_->askForPackages();
  if (options_.executor() == ExecutorKind::kLockstep) {
    for (const auto& robot : robots_)
      if (!robot->isStuck()) robot->startStep();
  }
  if (ports_) ports_->serve({});
  executor_->step();
  if (options_.executor() == ExecutorKind::kThreads) {
    for (const auto& robot : robots_) robot->startStep();
  }
  if (ports_) ports_->deliver();
  for (const auto& robot : robots_) robot->endStep();
  watchGame();
  watchControllers();
  if (tap_) recordStep();
  ++stepsMade_;
  if (again_ && world_->simulation().steps() >= again_->snapshot.step) endRunningAgain();
}

Errors SimulatedRun::reset(std::uint64_t seed) {
  again_.reset();
  return restart(seed, nullptr);
}

Errors SimulatedRun::restart(std::uint64_t seed, const std::map<std::string, ProgramOverrides>* overrides) {
  // Made before anything is given up: a file may have been broken meanwhile.
  auto before = makePrograms(options_.layouts);
  if (!before) return before.error();
  // Their processes must not read a clock that jumps.
  stopPrograms();
  world_->reset(seed);
  goneMotions_.clear();
  programTime_ = {};
  for (const auto& robot : robots_) {
    if (overrides != nullptr && overrides->contains(robot->name())) {
      robot->startOverWith(overrides->at(robot->name()));
    } else {
      robot->startOver();
    }
  }
  endedControllers_.clear();
  options_.world.seed = seed;
  restartGame();
  // The programs are made again for the new world. If a file was broken just now, the previous programs
  // are as good.
  auto programs = makePrograms(options_.layouts);
  if (tap_) tap_->restart();
  if (programs) before->clear();
  startPrograms(std::move(programs ? *programs : *before));
  beginJournal();
  return {};
}

std::shared_ptr<const robotlink::GroundMap> SimulatedRun::map() const {
  return world_->simulation().scene().groundMap();
}

robotlink::Result<void> SimulatedRun::request(const robotcontrol::Request& request) {
  if (request.has_stop()) {
    patience_->restore();
    ownPatience_->restore();
  }
  if (RobotHost* robot = find(request.robot())) {
    auto done = robot->request(request);
    if (done) journal_.add(stepsMade_, request);
    return done;
  }
  return robotlink::failure("request.no-robot", "there is no robot " + request.robot(), {},
                            {request.robot()});
}

void SimulatedRun::publishComingAnswers() {
  if (options_.executor() != ExecutorKind::kLockstep || !listeners_.queue) return;
  for (const auto& robot : robots_) {
    if (auto queue = robot->answersToCome()) listeners_.queue(robot->name(), std::move(queue));
  }
}

std::vector<std::string> SimulatedRun::stoppedRobots() const {
  std::vector<std::string> names;
  for (const auto& robot : robots_) {
    if (robot->platform() != nullptr && robot->platform()->stopEngaged()) names.push_back(robot->name());
  }
  return names;
}

}  // namespace app
