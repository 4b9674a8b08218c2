// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/Workbench.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "app/core/LogCommands.h"
#include "app/core/RecordingCommands.h"
#include "app/core/RobotCommands.h"
#include "app/core/pioneer/PioneerFeed.h"
#include "app/core/program/CommandValues.h"
#include "app/core/replay/ReplayFeed.h"
#include "app/core/simulated/SimulationFeed.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotUse.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/process/Layout.h"
#include "robotlink/session/KeyPresets.h"

namespace app {

using robotlink::CommandTable;
using Control = robotcontrol::ControlSimulation;

namespace {

/// The files with an extension in a folder of the resources, sorted.
std::vector<std::filesystem::path> filesIn(const char* folder, const char* extension) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(robotlink::resource(folder), error)) {
    if (robotlink::fileSuffix(entry.path()) == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Returns a shipped file by its name without extension ("compact"), or else the name as a path.
std::filesystem::path shippedOr(const std::vector<std::filesystem::path>& shipped, const std::string& name) {
  for (const auto& file : shipped) {
    if (file.stem() == name) return file;
  }
  return name;
}

}  // namespace

struct Workbench::LastSimulation {
  // Protects options.
  mutable std::mutex mutex;
  RunOptions options;
};

Workbench::Workbench(std::filesystem::path userFolder)
    : userFolder_(std::move(userFolder)),
      recording_(userFolder_),
      lastSimulation_(std::make_shared<LastSimulation>()),
      platform_(session_, recording_.recorder()) {
  lastSimulation_->options = defaultOptions();
  session_.setRequestSink([this](const robotcontrol::Request& request) { take(request); });
  addSimulationCommands();
  addLayoutCommand();
  addRobotCommands(*this);
  addLogCommands(*this);
  addRecordingCommands(*this);
}

Workbench::~Workbench() {
  session_.setRequestSink({});
}

std::vector<std::filesystem::path> Workbench::scenes() {
  std::vector<std::filesystem::path> files = filesIn("scenes", ".sdf");
  const auto maps = filesIn("scenes", ".map");
  files.insert(files.end(), maps.begin(), maps.end());
  return files;
}
std::vector<std::filesystem::path> Workbench::layouts() {
  return filesIn("layouts", ".yaml");
}

std::vector<Workbench::RobotKind> Workbench::simulatedRobots() {
  std::vector<RobotKind> kinds;
  for (const auto& file : filesIn("robots", ".yaml")) {
    const std::string name = file.stem().string();
    std::error_code error;
    if (!std::filesystem::exists(robotlink::resource("scenes/models/" + name + "/model.sdf"), error))
      continue;
    const auto description = robotlink::readRobotDescription(file);
    const auto use = robotlink::readRobotUse(file);
    if (description && use) kinds.push_back({name, description->title, !use->teams.empty()});
  }
  return kinds;
}

std::vector<std::filesystem::path> Workbench::layoutsFor(const robotlink::RobotDescription& robot) {
  const robotlink::TaskCatalog catalog = robotlink::registeredTasks();
  const robotlink::PlatformPackages platform{robot.offers, robot.takes, robotlink::debugPackages()};
  std::vector<std::filesystem::path> fitting = layouts();
  std::erase_if(fitting, [&](const std::filesystem::path& file) {
    const auto layout = robotlink::readLayout(file);
    return !layout || !robotlink::checkLayout(*layout, catalog, platform).empty();
  });
  return fitting;
}

std::filesystem::path Workbench::sceneNamed(const std::string& name) {
  return shippedOr(scenes(), name);
}

std::filesystem::path Workbench::layoutNamed(const std::string& name) {
  return shippedOr(layouts(), name);
}

RunOptions Workbench::defaultOptions() {
  RunOptions options;
  options.scene = robotlink::resource("scenes/field2002.sdf");
  return options;
}

PlatformThread::LoadHandler Workbench::outcomeOf(Change change) {
  ++loading_;
  // Debug keys that are on stay on in the next platform.
  if (change == Change::kPlatform) {
    if (const auto kept = keepKeys(); !kept) report({kept.error()});
  }
  return [this, change](const auto& loaded) { outcomes_.push({change, loaded}); };
}

void Workbench::load(RunOptions options) {
  options.progress = newOpening(options.scene);
  platform_.open(SimulationFeed::opening(std::move(options),
                                         [last = lastSimulation_](const RunOptions& running) {
                                           const std::lock_guard lock(last->mutex);
                                           last->options = running;
                                         }),
                 outcomeOf(Change::kPlatform));
}

RunOptions Workbench::lastSimulation() const {
  const std::lock_guard lock(lastSimulation_->mutex);
  return lastSimulation_->options;
}

logplayer::LogFile::Progress Workbench::newOpening(const std::filesystem::path& file) {
  opening_ = std::make_shared<Opening>();
  opening_->name = file.filename().string();
  return [opening = opening_](double share) {
    opening->share = share;
    return !opening->canceled;
  };
}

std::optional<double> Workbench::progress() const {
  return loading() && opening_ ? std::optional(opening_->share.load()) : std::nullopt;
}

std::string Workbench::openingName() const {
  return opening_ ? opening_->name : std::string();
}

void Workbench::cancelOpening() {
  if (opening_) opening_->canceled = true;
}

void Workbench::openLogs(std::vector<ReplayLog> logs, const std::filesystem::path& layout) {
  ReplayOptions options;
  options.layout = layout;
  options.progress = newOpening(logs.empty() ? std::filesystem::path() : logs.front().file);
  options.logs = std::move(logs);
  platform_.open(ReplayFeed::opening(std::move(options)), outcomeOf(Change::kPlatform));
}

void Workbench::addLog(ReplayLog log) {
  auto progress = newOpening(log.file);
  platform_.addLog(log.file, log.offset, std::move(progress), outcomeOf(Change::kPlatform));
}
void Workbench::connectRobot(PioneerOptions options) {
  platform_.open(PioneerFeed::opening(std::move(options)), outcomeOf(Change::kPlatform));
}
robotlink::Result<void> Workbench::connectNow() {
  if (!loaded_ || !loaded_->isReal())
    return robotlink::failure("robot.not-real",
                              "no robot is connected over a line; choose Robot > Connect first");
  platform_.connectNow();
  return {};
}
void Workbench::close() {
  platform_.close(outcomeOf(Change::kPlatform));
}
void Workbench::setLayout(const std::filesystem::path& file) {
  platform_.setLayout(file, outcomeOf(Change::kLayout));
}

void Workbench::ask(robotcontrol::Request request) {
  session_.request(std::move(request), [this](const robotcontrol::RequestResult& result) {
    if (!result.accepted()) report({{"request.refused", result.reason(), {}, {}}});
  });
}

void Workbench::take(const robotcontrol::Request& request) {
  if (robotlink::kindOf(request).doer != robotlink::RequestDoer::kRecording)
    return platform_.request(request);
  const auto done = recording_.control(request.control_recording());
  robotcontrol::RequestResult result;
  result.set_id(request.id());
  result.set_accepted(done.has_value());
  if (!done) result.set_reason(done.error().text);
  session_.pushResult(result);
}

void Workbench::tick() {
  for (Outcome& outcome : outcomes_.drain()) apply(std::move(outcome));
  if (const robotlink::Errors warnings = recording_.takeWarnings(); !warnings.empty()) report(warnings);
  session_.tick();
}

void Workbench::report(const robotlink::Errors& errors) {
  if (onErrors_) onErrors_(errors);
}

void Workbench::apply(Outcome outcome) {
  if (--loading_ == 0) opening_.reset();
  if (!outcome.loaded) {
    const robotlink::Errors& errors = outcome.loaded.error();
    const bool wanted =
        errors.size() == 1 && (errors.front().id == "log.given-up" || errors.front().id == "scene.given-up");
    if (!wanted) report(errors);
    return;
  }
  loaded_ = std::move(*outcome.loaded);
  std::vector<std::string> robots;
  for (const auto& [name, description] : loaded_->robots) robots.push_back(name);
  session_.setRobots(robots);
  if (outcome.change == Change::kPlatform) {
    keysToSwitchOn_.clear();
    for (const std::string& robot : robots) switchKeysOn(robot);
  }
  if (onLoaded_) onLoaded_(*loaded_);
  robotlink::Errors lost;
  for (const std::string& text : loaded_->lostChoices) lost.push_back({"choices.lost", text, {}, {}});
  if (!lost.empty()) report(lost);
}

void Workbench::switchKeysOn(const std::string& robot) {
  auto keys = robotlink::KeyPresets(userFolder_ / "session").load(robot);
  if (!keys) keys = robotlink::KeyPresets(robotlink::resource("presets")).load("start");
  if (!keys) return;
  const auto unanswered = std::make_shared<int>(keys->keys_size());
  keysToSwitchOn_[robot] = unanswered;
  for (const auto& key : keys->keys()) {
    robotcontrol::Request request;
    request.set_robot(robot);
    request.mutable_set_key()->set_name(key.name());
    *request.mutable_set_key()->mutable_mode() = key.mode();
    // Another program may lack some of the keys that were on; that is no error to report.
    session_.request(std::move(request), [unanswered](const robotcontrol::RequestResult&) { --*unanswered; });
  }
}

robotlink::Result<void> Workbench::keepKeys() {
  for (const std::string& robot : session_.robots()) {
    // Its table may still be the one from before the saved keys were switched on.
    const auto unanswered = keysToSwitchOn_.find(robot);
    if (unanswered != keysToSwitchOn_.end() && *unanswered->second > 0) continue;
    const auto* table = session_.store().latestAs<robotcontrol::KeyTable>(robot + "/tables/keys",
                                                                          session_.timeline().newest());
    if (table == nullptr) continue;
    if (auto saved = robotlink::KeyPresets(userFolder_ / "session").save(robot, *table); !saved) return saved;
  }
  return {};
}

robotlink::Result<void> Workbench::control(int action, double speed) {
  robotcontrol::Request request;
  request.mutable_control_simulation()->set_action(static_cast<Control::Action>(action));
  request.mutable_control_simulation()->set_speed(speed);
  ask(std::move(request));
  return {};
}

void Workbench::addSimulationCommands() {
  const auto action = [this](const char* name, const char* help, Control::Action what) {
    commands_.add({name, help, {}, [this, what](const Values&) { return control(what); }});
  };
  action("simulation.start", "Runs the simulation", Control::START);
  action("simulation.pause", "Pauses the simulation", Control::PAUSE);
  action("simulation.step", "Steps the simulation by 8 ms", Control::STEP);
  action("simulation.reset", "Resets everything to the start", Control::RESET);
  commands_.add({"simulation.speed",
                 "Sets how many times real time the simulation runs; 0 is as fast as possible",
                 {{"speed", CommandTable::Type::kNumber, "times real time, 0 to 100"}},
                 [this](const Values& values) -> robotlink::Result<void> {
                   const double speed = std::get<double>(values[0]);
                   if (!(speed >= 0 && speed <= 100)) {
                     return robotlink::failure("simulation.speed",
                                               "the speed must be between 0 and 100 times real time");
                   }
                   return control(Control::UNCHANGED, speed);
                 }});
  commands_.add({"simulation.light",
                 "Changes the light that cameras see; 1 0 is the scene's own",
                 {{"brightness", CommandTable::Type::kNumber, "times the scene's, 0 to 10"},
                  {"warmth", CommandTable::Type::kNumber, "-1 (bluish) to 1 (reddish)"}},
                 [this](const Values& values) -> robotlink::Result<void> {
                   robotcontrol::Request request;
                   request.mutable_set_lighting()->set_brightness(std::get<double>(values[0]));
                   request.mutable_set_lighting()->set_warmth(std::get<double>(values[1]));
                   ask(std::move(request));
                   return {};
                 }});
  commands_.add({"simulation.open",
                 "Opens a scene, by its path or the name of a shipped one",
                 {{"scene", CommandTable::Type::kText, "an SDFormat file"}},
                 [this](const Values& values) -> robotlink::Result<void> {
                   RunOptions options = lastSimulation();
                   options.scene = sceneNamed(std::get<std::string>(values[0]));
                   options.robots.reset();
                   options.ports.reset();
                   load(std::move(options));
                   return {};
                 }});
  commands_.add(
      {"simulation.setup",
       "Opens a scene or a map and adds robots to it",
       {{"scene", CommandTable::Type::kText,
         "an SDFormat file, a map (.map), or the name of a shipped scene"},
        {"kind", CommandTable::Type::kText,
         "of the robots to add: p3at, ers210, or another one that has a model"},
        {"robots", CommandTable::Type::kNumber, "how many, 0 to 100"},
        {"kinematic", CommandTable::Type::kBool, "true: they are moved by their odometry, without forces"},
        {"port", CommandTable::Type::kNumber, "at which external programs reach the first one; 0: none"},
        {"network", CommandTable::Type::kBool, "true: the ports can be reached from other computers"},
        {"teams", CommandTable::Type::kText, "that robots of the kind ers210 play in: both, red or blue"}},
       [this](const Values& values) { return setUp(values); }});
}

robotlink::Result<void> Workbench::setUp(const Values& values) {
  const double robots = std::get<double>(values[2]), port = std::get<double>(values[4]);
  if (!(robots >= 0 && robots <= 100 && robots == std::floor(robots)))
    return robotlink::failure("simulation.setup", "the number of robots must be a whole one, 0 to 100");
  if (!(port >= 0 && port + robots <= 65536 && port == std::floor(port))) {
    return robotlink::failure("simulation.setup",
                              "the ports must be whole numbers, 1 to 65535; 0 opens none");
  }
  const auto& teams = std::get<std::string>(values[6]);
  if (teams != "both" && teams != "red" && teams != "blue") {
    return robotlink::failure("simulation.setup", "the teams must be both, red or blue, not '" + teams + "'");
  }
  RunOptions options = lastSimulation();
  options.scene = sceneNamed(std::get<std::string>(values[0]));
  options.robots = simcore::RobotsToAdd{.model = std::get<std::string>(values[1]),
                                        .count = static_cast<int>(robots),
                                        .seed = options.world.seed,
                                        .teams = teamsNamed(teams)};
  options.world.kinematic = std::get<bool>(values[3]);
  options.ports.reset();
  if (port > 0) {
    options.ports.emplace();
    options.ports->firstPort = static_cast<std::uint16_t>(port);
    if (std::get<bool>(values[5])) options.ports->address = "0.0.0.0";
  }
  load(std::move(options));
  return {};
}

void Workbench::addLayoutCommand() {
  commands_.add({"layout.open",
                 "Restarts the robots' programs in another process layout, given by its path or the name of "
                 "a shipped one",
                 {{"layout", CommandTable::Type::kText, "a layout file"}},
                 [this](const Values& values) -> robotlink::Result<void> {
                   setLayout(layoutNamed(std::get<std::string>(values[0])));
                   return {};
                 }});
}

}  // namespace app
