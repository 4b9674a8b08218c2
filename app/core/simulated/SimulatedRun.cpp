// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/simulated/SimulatedRun.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/core/platform/PublishGate.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RecordingTap.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/SceneMessages.h"
#include "app/core/program/SolutionChoices.h"
#include "app/core/simulated/SimulatedPlatform.h"
#include "foxglove/Geometry.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotUse.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "simcore/Scene.h"
#include "simcore/SceneFileKind.h"

namespace app {

using robotlink::Errors;

namespace {

/// Number of steps between recorded transforms: about 30 per second.
constexpr int kTransformsEvery = 4;

}  // namespace

RunOptions defaultSimulation() {
  RunOptions options;
  options.scene = robotlink::resource("scenes/field2002.sdf");
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
  return simcore::Scene::load(options_.scene, added, std::exchange(options_.progress, {}));
}

Errors SimulatedRun::load() {
  auto scene = readScene();
  if (!scene) return scene.error();
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
  // They may have been chosen in another scene.
  std::erase_if(options_.hosting.otherwise,
                [this](const std::string& name) { return find(name) == nullptr; });
  if (options_.kickOffs) kickOff_ = KickOff::create(field_, world_->simulation());
  if (!options_.layout.empty()) {
    for (const auto& robot : robots_) options_.layouts[robot->description().name] = options_.layout;
    options_.layout.clear();
  }
  if (Errors errors = checkChosenSolutions(); !errors.empty()) return errors;
  auto programs = makePrograms(options_.layouts);
  if (!programs) return programs.error();
  if (tap_) tap_->restart();
  startPrograms(std::move(*programs));
  return {};
}

Errors SimulatedRun::checkChosenSolutions() const {
  if (options_.solutions.empty()) return {};
  std::vector<robotlink::Layout> layouts;
  for (const auto& robot : robots_) {
    auto layout = robotlink::readLayout(layoutOf(*robot, options_.layouts));
    // The error is reported when its program is made.
    if (!layout) return {};
    layouts.push_back(std::move(*layout));
  }
  std::vector<const robotlink::Layout*> known;
  for (const auto& layout : layouts) known.push_back(&layout);
  return checkSolutions(options_.solutions, robotlink::registeredTasks(), known);
}

robotlink::Result<void> SimulatedRun::openPorts() {
  if (!options_.ports || ports_) return {};
  auto ports = ArcosPorts::open(*world_, *options_.ports, listeners_.ports);
  if (!ports) return tl::unexpected(ports.error());
  ports_ = std::move(*ports);
  return {};
}

Errors SimulatedRun::describeRobots() {
  const simcore::Scene& scene = world_->simulation().scene();
  struct Kind {
    std::shared_ptr<const robotlink::RobotDescription> description;
    robotlink::RobotUse use;
  };
  std::map<std::string, Kind> kinds;
  // Without a field in the scene, the first one that a robot's description names.
  std::string field = scene.field();
  for (const auto& robot : scene.robots()) {
    if (kinds.contains(robot.description)) continue;
    auto description = readRobot(robot.description);
    if (!description) return description.error();
    auto use = readUse(robot.description);
    if (!use) return use.error();
    if (field.empty()) field = use->field;
    kinds[robot.description] = {std::move(*description), std::move(*use)};
  }
  auto read = readField(fieldFile(field));
  if (!read) return read.error();
  field_ = std::move(*read);
  for (const auto& robot : scene.robots()) {
    const Kind& kind = kinds[robot.description];
    const std::string team = robot.team.empty() ? kind.use.teamOf(robot.name) : robot.team;
    robots_.push_back(std::make_unique<RobotHost>(
        HostedRobot{robot.name, team, kind.description, field_, map(), fieldFile(field),
                    map() ? scene.file() : std::filesystem::path(), options_.preset},
        RobotHost::Listeners{
            listeners_.queue, listeners_.trouble, listeners_.platform, {}, listeners_.hosting},
        tap_.get()));
  }
  return {};
}

std::filesystem::path SimulatedRun::layoutOf(const RobotHost& robot, const Layouts& chosen) const {
  const auto found = chosen.find(robot.description().name);
  return found != chosen.end() ? found->second : layoutFile(robot.description());
}

std::filesystem::path SimulatedRun::layout() const {
  return robots_.empty() ? std::filesystem::path() : layoutOf(*robots_.front(), options_.layouts);
}

std::map<std::string, std::filesystem::path> SimulatedRun::otherLayouts() const {
  std::map<std::string, std::filesystem::path> others;
  for (const auto& robot : robots_) {
    const auto file = layoutOf(*robot, options_.layouts);
    if (file != layout()) others[robot->name()] = file;
  }
  return others;
}

tl::expected<SimulatedRun::Candidates, Errors> SimulatedRun::makePrograms(const Layouts& layouts) {
  std::map<std::filesystem::path, robotlink::Layout> read;
  Candidates candidates;
  for (const auto& robot : robots_) {
    const std::filesystem::path file = layoutOf(*robot, layouts);
    if (!read.contains(file)) {
      auto layout = readLayoutWith(file, options_.solutions);
      if (!layout) return tl::unexpected(layout.error());
      read[file] = std::move(*layout);
    }
    auto made = makeProgram(*robot, file, read[file]);
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
  Candidates candidates;
  for (RobotHost* robot : changed) {
    auto made = makeProgramOnPlatform(*robot);
    if (!made) {
      options_ = before;
      return made.error();
    }
    candidates.push_back(std::move(*made));
  }
  stopExecutor();
  for (std::size_t i = 0; i < changed.size(); ++i) {
    changed[i]->stop();
    changed[i]->adopt(std::move(candidates[i]));
  }
  beginPrograms(changed);
  return {};
}

tl::expected<RobotHost::Candidate, Errors> SimulatedRun::makeProgramOnPlatform(RobotHost& robot) {
  const std::filesystem::path file = layoutOf(robot, options_.layouts);
  auto layout = readLayoutWith(file, options_.solutions);
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
  tap_->world({robotlink::streams::kScene, world_->clock().now(), sceneMessage(world_->simulation())});
  stepsToTransforms_ = 0;
}

void SimulatedRun::recordStep() {
  tap_->endStep();
  if (--stepsToTransforms_ > 0 || !tap_->wants(robotlink::streams::kTransforms)) return;
  stepsToTransforms_ = kTransformsEvery;
  tap_->world(
      {robotlink::streams::kTransforms, world_->clock().now(), transformsMessage(world_->simulation())});
}

void SimulatedRun::reportTrouble(const robotlink::Process& process, const std::string& text) {
  for (const auto& robot : robots_) {
    if (robot->owns(process)) robot->reportTrouble(process, text);
  }
}

void SimulatedRun::step() {
  leftOver_.forgetEnded();
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
  if (kickOff_) watchGame();
  watchControllers();
  if (tap_) recordStep();
}

void SimulatedRun::watchGame() {
  const auto text = kickOff_->step();
  if (!text) return;
  if (listeners_.game) listeners_.game(world_->clock().now(), *text);
  // The game belongs to no robot, but texts in a log must; the first one stands for it.
  if (tap_ && !robots_.empty()) {
    tap_->world(
        textMessage(robots_.front()->name(), "game", world_->clock().now(), foxglove::Log::INFO, *text));
  }
}

Errors SimulatedRun::reset(std::uint64_t seed) {
  // Made before anything is given up: a file may have been broken meanwhile.
  auto before = makePrograms(options_.layouts);
  if (!before) return before.error();
  // Their processes must not read a clock that jumps.
  stopPrograms();
  world_->reset(seed);
  for (const auto& robot : robots_) robot->beginAnew();
  if (kickOff_) kickOff_->restart();
  endedControllers_.clear();
  options_.world.seed = seed;
  // Made again, so that what they have is that of the new world. If a file was broken just now, those of
  // before are as good.
  auto programs = makePrograms(options_.layouts);
  if (tap_) tap_->restart();
  if (programs) before->clear();
  startPrograms(std::move(programs ? *programs : *before));
  return {};
}

Errors SimulatedRun::whyNot(const std::string& kind, const std::filesystem::path& layout) {
  auto read = readLayoutWith(layout, options_.solutions);
  if (!read) return read.error();
  for (const auto& robot : robots_) {
    if (robot->description().name != kind) continue;
    auto made = makeProgram(*robot, layout, *read);
    if (!made) return made.error();
    made->program->stop();
    return {};
  }
  return {};
}

Errors SimulatedRun::setLayout(const std::filesystem::path& file) {
  Errors errors;
  std::set<std::string> kinds, changed;
  for (const auto& robot : robots_) kinds.insert(robot->description().name);
  for (const std::string& kind : kinds) {
    if (Errors reasons = whyNot(kind, file); reasons.empty()) {
      changed.insert(kind);
    } else if (errors.empty()) {
      errors = std::move(reasons);
    }
  }
  if (changed.empty()) return errors;
  Layouts layouts = options_.layouts;
  for (const std::string& kind : changed) layouts[kind] = file;
  auto programs = makePrograms(layouts);
  if (!programs) return programs.error();
  options_.layouts = std::move(layouts);
  startPrograms(std::move(*programs));
  return {};
}

std::vector<std::string> SimulatedRun::robots() const {
  std::vector<std::string> names;
  for (const auto& robot : robots_) names.push_back(robot->name());
  return names;
}

RobotHost* SimulatedRun::find(const std::string& name) const {
  const auto found = std::ranges::find_if(robots_, [&](const auto& robot) { return robot->name() == name; });
  return found == robots_.end() ? nullptr : found->get();
}

std::shared_ptr<const robotlink::RobotDescription> SimulatedRun::description(const std::string& name) const {
  const RobotHost* robot = find(name);
  return robot != nullptr ? robot->robot().description : nullptr;
}

std::shared_ptr<const robotlink::GroundMap> SimulatedRun::map() const {
  return world_->simulation().scene().groundMap();
}

robotlink::Result<void> SimulatedRun::request(const robotcontrol::Request& request) {
  if (request.has_stop()) {
    patience_->restore();
    ownPatience_->restore();
  }
  if (RobotHost* robot = find(request.robot())) return robot->request(request);
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
