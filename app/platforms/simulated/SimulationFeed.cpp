// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/SimulationFeed.h"

#include "app/platforms/SceneMessages.h"
#include "app/platforms/simulated/SceneResources.h"
#include "app/platforms/simulated/world/WorldObjects.h"
#include "foxglove/Geometry.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "simcore/Scene.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kTransformsPeriod{15}, kPortsPeriod{33};
constexpr std::chrono::milliseconds kSimulationStatusEvery{100};
/// The memory that the recent past may take.
constexpr std::size_t kRewindBytes = std::size_t{256} << 20U;

}  // namespace

tl::expected<std::unique_ptr<SimulationFeed>, robotlink::Errors> SimulationFeed::create(
    RunOptions options, robotlink::Session& session, logplayer::Recorder& recorder, Choices choices) {
  auto feed = std::unique_ptr<SimulationFeed>(new SimulationFeed(session, recorder));
  feed->choices_ = std::move(choices);
  options.world.rewindBytes = kRewindBytes;
  options.isWatched = true;
  if (options.patience.count() == 0) options.patience = kModulePatience;
  auto run = SimulatedRun::create(std::move(options), feed->listeners(), &recorder);
  if (!run) return tl::unexpected(std::move(run.error()));
  feed->run_ = std::move(*run);
  feed->useWorld();
  return feed;
}

SimulatedRun::Listeners SimulationFeed::listeners() {
  return {[this](const std::string& robot, auto queue) { gate_.publishQueue(robot, std::move(queue)); },
          [this](const std::string& robot, const robotlink::Process& process, const std::string& text) {
            gate_.publishTrouble(robot, process, text);
          },
          {},
          [this](const std::string& text) { publishPortText(text, foxglove::Log::INFO); },
          [this](robotlink::Instant, const std::string& text) { publishGame(text); },
          [this](const std::string& robot, robotlink::Instant time, const std::string& text) {
            gate_.publishPlatform(robot, time, text);
          },
          [this](const std::string& robot, robotlink::Instant time,
                 const robotcontrol::HostingStatus& status) { gate_.publishHosting(robot, time, status); },
          [this](const std::string&, robotlink::Instant time, const std::string& text) {
            controllersChanged_ = true;
            if (run_ && !run_->robots().empty())
              gate_.publishText(run_->robots().front(), "controllers", time, foxglove::Log::ERROR, text);
          }};
}

void SimulationFeed::publishPortText(const std::string& text, int level) {
  if (run_ && !run_->robots().empty()) gate_.publishText(run_->robots().front(), "ports", now(), level, text);
}

void SimulationFeed::publishGame(const std::string& text) {
  if (run_ && !run_->robots().empty())
    gate_.publishText(run_->robots().front(), "game", now(), foxglove::Log::INFO, text);
}

void SimulationFeed::makeWay() {
  run_->closePorts();
}

robotlink::Errors SimulationFeed::restoreAfterMakeWay() {
  const auto opened = run_->openPorts();
  return opened ? robotlink::Errors{} : robotlink::Errors{opened.error()};
}

void SimulationFeed::inheritPlayback(const Going& before) {
  running_ = before.running;
  pace_.setSpeed(before.speed);
}

std::vector<std::string> SimulationFeed::end() {
  gate_.keepReports();
  run_->end();
  ports_.reset();
  if (run_->hasEnded()) run_.reset();
  return gate_.keptReports();
}

void SimulationFeed::begin() {
  gate_.open();
  keepChoices();
  restartPace();
  publishScene();
  if (!run_->options().world.noise && !run_->robots().empty()) {
    gate_.publishText(run_->robots().front(), "simulation", now(), foxglove::Log::INFO,
                      "Sensors and odometry have no noise in this simulation.");
  }
  const std::string leftOut = leftOutText(run_->world().simulation().scene());
  if (!leftOut.empty() && !run_->robots().empty())
    gate_.publishText(run_->robots().front(), "scene", now(), foxglove::Log::WARNING, leftOut);
  if (const auto map = run_->map(); map && !run_->robots().empty()) {
    gate_.publishMapNotes(run_->robots().front(), now(), *map);
  }
  if (const ArcosPorts* ports = run_->ports()) {
    const auto last = static_cast<std::size_t>(std::max<std::size_t>(ports->ports().robots(), 1)) - 1;
    publishPortText(
        "programs find the robots at " + ports->url(0) + (last > 0 ? " to " + ports->url(last) : ""),
        foxglove::Log::INFO);
    if (!ports->warning().empty()) publishPortText(ports->warning(), foxglove::Log::WARNING);
  }
  publishAnswers();
}

std::optional<robotlink::PacedThread::Clock::time_point> SimulationFeed::due() {
  // Threads take the time that they take.
  if (run_->options().hosting.threads && pace_.speed() == 0) {
    pace_.setSpeed(1);
    restartPace();
  }
  if (run_->ranAgain()) return Clock::now();
  if (!running_ && stepsWanted_ == 0) return std::nullopt;
  const auto paced = running_ ? pace_.due(now()) : Clock::now();
  return std::max(paced, external_.waitsUntil().value_or(paced));
}

void SimulationFeed::step() {
  if (run_->ranAgain()) return runAgain();
  pace_.forgetLag(Clock::now(), now());
  beforeControl(Clock::now());
  if (ports_->holdsAny()) ports_->release(run_->stoppedRobots());
  run_->step();
  if (stepsWanted_ > 0) --stepsWanted_;
  const auto real = Clock::now();
  const bool single = !running_;
  if (single || real - lastTransforms_ >= kTransformsPeriod) {
    lastTransforms_ = real;
    publishTransforms();
  }
  if (!ports_->isEmpty()) stepPorts(real);
  if (readsForces_) stepForces(real);
  afterControl(real);
  stepGame(real);
  const bool isRead = demand_.anything || recorder_.active();
  if (isRead && (single || real - lastStatus_ >= kSimulationStatusEvery)) publishStatus();
  publishAnswers();
}

void SimulationFeed::publishAnswers() {
  if (!running_ && stepsWanted_ == 0) run_->publishComingAnswers();
  if (run_->takeSolutionsChosen()) keepChoices();
}

void SimulationFeed::keepChoices() const {
  if (choices_) choices_(run_->optionsToKeep());
}

LoadedPlatform SimulationFeed::describe() const {
  LoadedPlatform loaded;
  for (const std::string& robot : run_->robots()) loaded.robots[robot] = run_->description(robot);
  loaded.adapter = kAdapter;
  loaded.time = TimeKind::kSimulated;
  loaded.sources = {run_->options().scene.string()};
  loaded.title = run_->options().scene.stem().string();
  if (!run_->field()->name.empty()) loaded.field = run_->field();
  loaded.areBodies = run_->options().instead != nullptr;
  if (!loaded.areBodies) {
    loaded.layout = run_->layout();
    loaded.otherLayouts = run_->otherLayouts();
  }
  loaded.lostChoices = run_->lostChoices();
  if (loaded.robots.empty()) loaded.leftOut = leftOutText(run_->world().simulation().scene());
  return loaded;
}

robotlink::Result<void> SimulationFeed::requestRobot(const robotcontrol::Request& request) {
  if (auto free = whetherFree(request); !free) return free;
  auto done = run_->request(request);
  publishAnswers();
  return done;
}

/// The requests that only a simulation fulfills.
struct SimulationFeed::Handlers {
  using Request = robotcontrol::Request;
  static constexpr robotlink::RequestRow<robotlink::Result<void> (SimulationFeed::*)(const Request&)> kRows[]{
      {Request::kControlSimulation, &SimulationFeed::controlSimulation},
      {Request::kPlaceModel, &SimulationFeed::changeWorld},
      {Request::kTurnModel, &SimulationFeed::changeWorld},
      {Request::kThrowModel, &SimulationFeed::changeWorld},
      {Request::kPinObject, &SimulationFeed::changeWorld},
      {Request::kDragObject, &SimulationFeed::changeWorld},
      {Request::kPushObject, &SimulationFeed::changeWorld},
      {Request::kSetLighting, &SimulationFeed::changeWorld},
      {Request::kSetSensorErrors, &SimulationFeed::changeWorld},
      {Request::kMoveDoor, &SimulationFeed::changeWorld},
      {Request::kSetActuator, &SimulationFeed::changeWorld},
      {Request::kEditScene, &SimulationFeed::editScene},
      {Request::kHostProgram, &SimulationFeed::hostProgram},
      {Request::kReadPorts, &SimulationFeed::readPorts},
      {Request::kReadForces, &SimulationFeed::readForces},
      {Request::kControlSnapshots, &SimulationFeed::controlSnapshots},
      {Request::kSendEvent, &SimulationFeed::sendEvent},
      {Request::kAttachController, &SimulationFeed::attachController},
      {Request::kSetPorts, &SimulationFeed::setPorts},
      {Request::kControlGame, &SimulationFeed::controlGame}};
};

bool SimulationFeed::fulfills(const robotcontrol::Request& request) {
  return robotlink::rowOf(Handlers::kRows, request.what_case()) != nullptr;
}

robotlink::Result<void> SimulationFeed::requestSimulation(const robotcontrol::Request& request) {
  const auto* row = robotlink::rowOf(Handlers::kRows, request.what_case());
  if (row == nullptr)
    return robotlink::failure("simulation.request", "a simulation cannot " + robotlink::inWords(request));
  if (auto free = whetherFree(request); !free) return free;
  const robotlink::Result<void> done = (this->*row->handler)(request);
  publishAnswers();
  return done;
}

robotlink::Result<void> SimulationFeed::changeWorld(const robotcontrol::Request& request) {
  const auto done = run_->changeWorld(request);
  if (request.has_set_actuator()) publishPorts();
  if (!request.has_set_actuator() && !request.has_set_lighting() && !request.has_set_sensor_errors()) {
    publishTransforms();
    publishForces();
    publishStatus();
  }
  return done;
}

robotlink::Result<void> SimulationFeed::editScene(const robotcontrol::Request& request) {
  using Edit = robotcontrol::EditScene;
  const Edit& edit = request.edit_scene();
  tl::expected<std::string, robotlink::Errors> done;
  switch (edit.what_case()) {
    case Edit::kAdd: {
      const auto& add = edit.add();
      simcore::ModelToAdd model{
          .model = add.model(), .name = add.name(), .place = robotlink::pose2(add.pose_in_field())};
      if (add.has_height()) model.height = add.height();
      model.team = add.team();
      done = run_->addModel(model);
      break;
    }
    case Edit::kRemove:
      done = run_->removeModel(edit.remove().model());
      break;
    case Edit::kDuplicate:
      done = run_->duplicateModel(edit.duplicate().model(), edit.duplicate().name());
      break;
    default:
      done = run_->undoEdit();
  }
  if (!done) {
    robotlink::Error error = done.error().front();
    // A request is answered by one text.
    if (done.error().size() > 1) error.text = robotlink::describe(done.error());
    return tl::unexpected(std::move(error));
  }
  descriptionChanged_ = true;
  restartPace();
  publishScene();
  say(*done);
  publishLostOverrides();
  return {};
}

robotlink::Result<void> SimulationFeed::hostProgram(const robotcontrol::Request& request) {
  const robotlink::Errors errors = run_->hostProgram(request.robot(), request.host_program());
  if (!errors.empty()) return tl::unexpected(errors.front());
  keepChoices();
  publishLostOverrides();
  return {};
}

robotlink::Result<void> SimulationFeed::readPorts(const robotcontrol::Request& request) {
  const auto done = ports_->read(request.read_ports());
  if (!done || request.read_ports().ended()) return done;
  publishPorts();
  for (auto& image : ports_->images(true)) gate_.publish(std::move(image));
  return done;
}

robotlink::Result<void> SimulationFeed::controlSimulation(const robotcontrol::Request& request) {
  using Control = robotcontrol::ControlSimulation;
  const Control& control = request.control_simulation();
  if (control.has_speed() && control.speed() >= 0) pace_.setSpeed(control.speed());
  restartPace();
  switch (control.action()) {
    case Control::START:
      running_ = true;
      break;
    case Control::PAUSE:
      running_ = false;
      break;
    case Control::STEP:
      running_ = false;
      ++stepsWanted_;
      break;
    case Control::RESET:
      return reset();
    default:
      break;
  }
  return {};
}

tl::expected<bool, robotlink::Errors> SimulationFeed::reload(FileTexts texts, bool mustFit) {
  auto done = run_->reload(std::move(texts), mustFit);
  if (!done) return tl::unexpected(std::move(done.error()));
  if (!done->inPlace) return false;
  useWorld();
  restartPace();
  publishScene();
  say("The scene was reloaded; the simulation continues in it.");
  for (const std::string& model : done->putBack) say(model + " is where the scene's file puts it.");
  for (const std::string& robot : done->started) say("The program of " + robot + " was started.");
  for (const std::string& robot : done->ended) say("The program of " + robot + " has ended.");
  publishAnswers();
  return true;
}

PlatformOpening SimulationFeed::reopening(FileTexts texts) const {
  return opening(describe().sources.front(),
                 [texts = std::move(texts)](RunOptions& options) { options.texts = texts; });
}

void SimulationFeed::say(const std::string& text) {
  if (run_->robots().empty()) return;
  gate_.publishText(run_->robots().front(), "simulation", now(), foxglove::Log::INFO, text);
}

void SimulationFeed::publishLostOverrides() {
  if (run_->robots().empty()) return;
  for (const std::string& lost : run_->lostChoices()) {
    gate_.publishText(run_->robots().front(), "layout", now(), foxglove::Log::WARNING, lost);
  }
}

robotlink::Result<void> SimulationFeed::reset() {
  stepsWanted_ = 0;
  run_->stopRunningAgain();
  if (const robotlink::Errors errors = run_->reset(run_->options().world.seed); !errors.empty()) {
    return tl::unexpected(errors.front());
  }
  restartPace();
  external_.restart();
  publishScene();
  publishInputs(true);
  return {};
}

void SimulationFeed::publishScene() {
  lastStatusTime_ = now();
  lastStatus_ = Clock::now();
  if (const auto map = run_->map()) gate_.publish({robotlink::streams::kMap, now(), mapMessage(*map, now())});
  gate_.publish({robotlink::streams::kScene, now(), sceneMessage(run_->world().simulation(), now())});
  gate_.publish({robotlink::streams::kSolids, now(), solidsMessage(run_->world().simulation(), now())});
  // Users who want to read forces find their stream.
  gate_.publish({robotlink::streams::kForces, now(), std::make_shared<robotcontrol::WorldForces>()});
  publishControllers();
  // After a reset, nothing is held.
  if (lastPorts_ != Clock::time_point()) publishPorts();
  publishTransforms();
  publishDrawings();
  publishGameStatus();
  publishStatus();
}

void SimulationFeed::setDemand(const Demand& demand) {
  gate_.setRead(demand.anything);
  const Demand before = std::exchange(demand_, demand);
  if (demand.anything && !before.anything) publishStatus();
  if (demand.transforms && !before.transforms) publishTransforms();
  chooseForces();
}

void SimulationFeed::publishTransforms() {
  if (!demand_.transforms) return;
  gate_.publish(
      {robotlink::streams::kTransforms, now(), transformsMessage(run_->world().simulation(), now())});
}

void SimulationFeed::publishPorts() {
  lastPorts_ = Clock::now();
  const robotlink::StreamMessage message{robotlink::streams::kPorts, now(), ports_->readings()};
  if (recorder_.active() && !ports_->isEmpty()) recorder_.add({message});
  gate_.publish(message);
}

void SimulationFeed::stepPorts(Clock::time_point real) {
  for (auto& image : ports_->images(false)) gate_.publish(std::move(image));
  if (running_ && real - lastPorts_ < kPortsPeriod) return;
  publishPorts();
}

void SimulationFeed::publishStatus() {
  SimulatedWorld& world = run_->world();
  const double elapsed = std::chrono::duration<double>(Clock::now() - lastStatus_).count();
  if (elapsed >= 0.5 * std::chrono::duration<double>(kSimulationStatusEvery).count()) {
    measuredSpeed_ = running_ ? robotlink::seconds(now() - lastStatusTime_) / elapsed : 0;
    lastStatus_ = Clock::now();
    lastStatusTime_ = now();
  }
  auto status = std::make_shared<robotcontrol::SimulationStatus>();
  status->set_time(robotlink::seconds(now()));
  status->set_speed(running_ ? measuredSpeed_ : 0);
  status->set_requested_speed(pace_.speed());
  status->set_running(running_);
  status->set_steps(world.costs().steps);
  status->set_ball_contacts(world.simulation().ballContacts());
  status->set_brightness(world.options().lighting.brightness);
  status->set_warmth(world.options().lighting.warmth);
  status->set_scene(run_->options().scene.string());
  status->set_scene_undo(run_->undoable());
  for (const auto& robot : run_->robots()) status->add_robots(robot);
  for (const auto& robot : run_->stoppedRobots()) status->add_stopped_robots(robot);
  for (const auto& model : movableModels(world.simulation())) status->add_models(model);
  addSnapshots(*status);
  const robotlink::StreamMessage message{robotlink::streams::kSimulation, now(), std::move(status)};
  if (recorder_.active()) recorder_.add({message});
  gate_.publish(message);
  gate_.publish({robotlink::streams::kRecording, now(),
                 std::make_shared<robotcontrol::RecordingStatus>(recorder_.status())});
}

}  // namespace app
