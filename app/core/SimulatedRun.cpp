// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/SimulatedRun.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/core/Outlet.h"
#include "app/core/ProgramSetups.h"
#include "app/core/RecordingTap.h"
#include "app/core/SceneMessages.h"
#include "app/core/SolutionChoices.h"
#include "foxglove/Geometry.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/RobotProgram.h"
#include "robotlink/debugging/Streams.h"
#include "simcore/Scene.h"

namespace app {

using robotlink::Errors;

namespace {

// Robots know a field even where there is none.
const std::string kField = "2002";

/// Every so many steps it is recorded where all bodies are: about 30 times a second.
constexpr int kTransformsEvery = 4;

}  // namespace

std::vector<std::string> teamsNamed(const std::string& name) {
  if (name == "red" || name == "blue") return {name};
  return {"red", "blue"};
}

SimulatedRun::SimulatedRun(RunOptions options, Listeners listeners, logplayer::Recorder* recorder)
    : options_(std::move(options)),
      listeners_(std::move(listeners)),
      tap_(recorder != nullptr ? std::make_unique<RecordingTap>(*recorder) : nullptr) {}

SimulatedRun::~SimulatedRun() {
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

Errors SimulatedRun::load() {
  simcore::RobotsToAdd added = options_.robots.value_or(simcore::RobotsToAdd{});
  if (!options_.robots && options_.scene.extension() == ".map") added.count = 1;
  auto scene = simcore::Scene::load(options_.scene, added, std::exchange(options_.progress, {}));
  if (!scene) return scene.error();
  auto world = SimulatedWorld::create(std::move(*scene), options_.world);
  if (!world) return {world.error()};
  world_ = std::move(*world);
  auto field = robotlink::FieldDescription::load(fieldFile());
  if (!field) return field.error();
  field_ = std::make_shared<const robotlink::FieldDescription>(std::move(*field));
  if (options_.kickOffs) kickOff_ = KickOff::create(field_, world_->simulation());
  if (auto opened = openPorts(); !opened) return {opened.error()};
  if (Errors errors = describeRobots(); !errors.empty()) return errors;
  if (!options_.layout.empty()) {
    for (const Robot& robot : robots_) options_.layouts[robot.description->name] = options_.layout;
    options_.layout.clear();
  }
  if (Errors errors = checkChosenSolutions(); !errors.empty()) return errors;
  auto programs = makePrograms(options_.layouts);
  if (!programs) return programs.error();
  if (tap_) tap_->restart();
  startPrograms(std::move(*programs));
  return {};
}

std::filesystem::path SimulatedRun::fieldFile() const {
  // A name, not a path to somewhere else.
  const std::filesystem::path name = world_->simulation().scene().field();
  return robotlink::resource("fields/" + (name.empty() ? kField : name.filename().string()) + ".yaml");
}

/// A layout that cannot be read says so when its program is made.
Errors SimulatedRun::checkChosenSolutions() const {
  if (options_.solutions.empty()) return {};
  std::vector<robotlink::Layout> layouts;
  for (const Robot& robot : robots_) {
    auto layout = robotlink::readLayout(layoutOf(robot, options_.layouts));
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
  std::map<std::string, std::shared_ptr<const robotlink::RobotDescription>> known;
  for (const auto& robot : world_->simulation().scene().robots()) {
    auto& description = known[robot.description];
    if (!description) {
      auto read = robotlink::readRobotDescription(descriptionFile(robot.description));
      if (!read) return read.error();
      description = std::make_shared<const robotlink::RobotDescription>(std::move(*read));
    }
    robots_.push_back(
        {robot.name, description, nullptr, nullptr, std::make_shared<ProgramRequests>(robot.name)});
  }
  return {};
}

std::filesystem::path SimulatedRun::layoutOf(const Robot& robot, const Layouts& chosen) const {
  const auto found = chosen.find(robot.description->name);
  return found != chosen.end() ? found->second
                               : robotlink::resource("layouts/" + robot.description->layout + ".yaml");
}

std::filesystem::path SimulatedRun::layout() const {
  return robots_.empty() ? std::filesystem::path() : layoutOf(robots_.front(), options_.layouts);
}

tl::expected<std::vector<SimulatedRun::Robot>, Errors> SimulatedRun::makePrograms(const Layouts& layouts) {
  std::map<std::filesystem::path, robotlink::Layout> read;
  std::vector<Robot> robots;
  for (const Robot& robot : robots_) {
    const std::filesystem::path file = layoutOf(robot, layouts);
    if (!read.contains(file)) {
      auto layout = readLayoutWith(file, options_.solutions);
      if (!layout) return tl::unexpected(layout.error());
      read[file] = std::move(*layout);
    }
    auto made = makeProgram(robot, read[file]);
    if (!made) return tl::unexpected(made.error());
    robots.push_back(std::move(*made));
  }
  return robots;
}

tl::expected<SimulatedRun::Robot, Errors> SimulatedRun::makeProgram(const Robot& robot,
                                                                    const robotlink::Layout& layout) {
  auto platform = SimulatedPlatform::create(*world_, robot.name, *robot.description);
  if (!platform) return tl::unexpected(Errors{platform.error()});
  if (robot.platform) (*platform)->engageStop(robot.platform->stopEngaged());
  if (listeners_.labelled) {
    (*platform)->alwaysSendClasses([this, name = robot.name](const auto& image, const auto& classes) {
      listeners_.labelled(name, image, classes);
    });
  } else if (options_.classImages) {
    (*platform)->alwaysSendClasses({});
  }
  const robotlink::RobotSetup setup{robot.name, teamOf(robot.name), *robot.description, field_, map()};
  auto program = robotlink::RobotProgram::create(
      setup, layout, **platform, {.folder = robotlink::resource("parameters/" + robot.description->name)});
  if (!program) return tl::unexpected(program.error());
  (*program)->debugProcess().setListener([this, name = robot.name, requests = robot.requests](auto queue) {
    requests->answered(*queue);
    if (tap_) tap_->add(name, queue);
    if (listeners_.queue) listeners_.queue(name, std::move(queue));
  });
  return Robot{robot.name, robot.description, std::move(*platform), std::move(*program), robot.requests};
}

void SimulatedRun::startPrograms(std::vector<Robot> robots) {
  stopPrograms();
  robots_ = std::move(robots);
  const auto failed = [this](const robotlink::Process& process) {
    tellTrouble(process, "was stopped because it threw: " + process.failure());
  };
  if (options_.executor == ExecutorKind::kLockstep) {
    lockstep_ = std::make_unique<robotlink::LockstepExecutor>(robotlink::LockstepExecutor::Options{
        .starvation = std::chrono::seconds(2),
        .advance = [this] { world_->advance(); },
        .onStarved = [this](const auto& process,
                            const auto& what) { tellTrouble(process, "waits for " + what); },
        .onFailed = failed});
  } else {
    threads_ = std::make_unique<robotlink::ThreadExecutor>(robotlink::ThreadExecutor::Options{
        .onFailed = failed, .onPriorityRefused = [this](const auto& process, const auto& why) {
          tellTrouble(process, "runs with normal priority: " + why);
        }});
  }
  if (tap_) recordWorld();
  lostChoices_.clear();
  for (Robot& robot : robots_) {
    if (tap_) record(robot);
    for (std::string& lost : robot.requests->begin(*robot.program)) lostChoices_.push_back(std::move(lost));
    if (threads_) handIn(robot);
    if (lockstep_) lockstep_->add(*robot.platform);
    for (robotlink::Process* process : robot.program->processes()) {
      if (lockstep_) lockstep_->add(*process);
      if (threads_) threads_->add(*process);
    }
  }
  if (threads_) threads_->start();
}

void SimulatedRun::stopPrograms() {
  threads_.reset();
  lockstep_.reset();
  if (tap_) tap_->clear();
  for (Robot& robot : robots_) {
    if (robot.program) robot.program->stop();
    robot.program.reset();
  }
}

void SimulatedRun::record(Robot& robot) {
  const ProgramFiles files{layoutOf(robot, options_.layouts), descriptionFile(robot.description->name),
                           fieldFile(),
                           options_.executor == ExecutorKind::kLockstep ? "lockstep" : "threads"};
  tap_->attach(robot.name, *robot.platform, *robot.program,
               programSetup(*robot.program, *robot.platform, files));
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

void SimulatedRun::tellTrouble(const robotlink::Process& process, const std::string& text) {
  if (!listeners_.trouble) return;
  for (const Robot& robot : robots_) {
    const auto& processes = robot.program->processes();
    if (std::find(processes.begin(), processes.end(), &process) == processes.end()) continue;
    listeners_.trouble(robot.name, process, "Process " + process.name() + " " + text);
  }
}

void SimulatedRun::step() {
  for (Robot& robot : robots_) handIn(robot);
  if (tap_) tap_->askForPackages();
  if (ports_) ports_->serve({});
  if (lockstep_) {
    lockstep_->step();
  } else if (threads_) {
    stepThreads();
  }
  if (ports_) ports_->deliver();
  if (kickOff_) watchGame();
  if (tap_) recordStep();
}

void SimulatedRun::watchGame() {
  const auto text = kickOff_->step();
  if (!text) return;
  if (listeners_.game) listeners_.game(world_->clock().now(), *text);
  // The game belongs to no robot; a log keeps texts with one.
  if (tap_ && !robots_.empty()) {
    tap_->world(textMessage(robots_.front().name, "game", world_->clock().now(), foxglove::Log::INFO, *text));
  }
}

void SimulatedRun::stepThreads() {
  for (Robot& robot : robots_) {
    robot.platform->tryBeginFrame();
    robot.platform->guard([&] { robot.platform->actuate(); });
  }
  world_->advance();
  for (Robot& robot : robots_) robot.platform->runFrame();
  threads_->clockAdvanced();
}

Errors SimulatedRun::reset(std::uint64_t seed) {
  // Whether the programs can be made anew is tried before anything is given up: a file may have been broken
  // meanwhile.
  if (auto tried = makePrograms(options_.layouts); !tried) return tried.error();
  stopPrograms();  // Their processes must not read a clock that jumps.
  world_->reset(seed);
  if (kickOff_) kickOff_->restart();
  options_.world.seed = seed;
  auto programs = makePrograms(options_.layouts);
  if (!programs) return programs.error();
  if (tap_) tap_->restart();
  startPrograms(std::move(*programs));
  return {};
}

/// Why robots of this kind cannot be run in a layout; nothing if they can.
Errors SimulatedRun::whyNot(const std::string& kind, const std::filesystem::path& layout) {
  auto read = readLayoutWith(layout, options_.solutions);
  if (!read) return read.error();
  for (const Robot& robot : robots_) {
    if (robot.description->name != kind) continue;
    auto made = makeProgram(robot, *read);
    if (!made) return made.error();
    made->program->stop();
    return {};
  }
  return {};
}

Errors SimulatedRun::setLayout(const std::filesystem::path& file) {
  Errors errors;
  std::set<std::string> kinds, changed;
  for (const Robot& robot : robots_) kinds.insert(robot.description->name);
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
  for (const Robot& robot : robots_) names.push_back(robot.name);
  return names;
}

std::shared_ptr<const robotlink::RobotDescription> SimulatedRun::description(const std::string& name) const {
  for (const Robot& robot : robots_) {
    if (robot.name == name) return robot.description;
  }
  return nullptr;
}

std::shared_ptr<const robotlink::GroundMap> SimulatedRun::map() const {
  return world_->simulation().scene().groundMap();
}

bool SimulatedRun::isOfPlatform(const robotcontrol::Request& request) {
  return request.has_stop() || request.has_control_drive();
}

robotlink::Result<void> SimulatedRun::request(const robotcontrol::Request& request) {
  for (Robot& robot : robots_) {
    if (robot.name != request.robot()) continue;
    if (request.has_stop()) {
      robot.platform->engageStop(request.stop().engaged());
      return {};
    }
    if (request.has_control_drive()) return robot.platform->control(request.control_drive());
    if (robot.requests->ask(request)) return {};
    return robotlink::failure("request.queue-full",
                              "robot " + robot.name + " does not take requests now: too many wait already",
                              {}, {robot.name});
  }
  return robotlink::failure("request.no-robot", "there is no robot " + request.robot(), {},
                            {request.robot()});
}

void SimulatedRun::handIn(Robot& robot) {
  robot.requests->ran();
  for (const auto& request : robot.requests->take()) {
    if (robot.program->debugProcess().request(request) && tap_) tap_->handedIn(request);
  }
}

void SimulatedRun::tellAnswersToCome() {
  if (!lockstep_ || !listeners_.queue) return;
  for (Robot& robot : robots_) {
    if (auto queue = robot.requests->answersToCome(*robot.program, world_->clock().now())) {
      listeners_.queue(robot.name, std::move(queue));
    }
  }
}

std::vector<std::string> SimulatedRun::stoppedRobots() const {
  std::vector<std::string> names;
  for (const Robot& robot : robots_) {
    if (robot.platform && robot.platform->stopEngaged()) names.push_back(robot.name);
  }
  return names;
}

}  // namespace app
