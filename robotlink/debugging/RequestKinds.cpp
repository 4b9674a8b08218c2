// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/RequestKinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/DebugKey.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/debugging/requests/GameRequests.h"
#include "robotlink/debugging/requests/SceneEditRequests.h"
#include "robotlink/debugging/requests/WorldRequests.h"
#include "robotlink/motions/MotionLibrary.h"
#include "robotlink/packages/PackageTypes.h"
#include "robotlink/packages/ParsedMessage.h"

namespace robotlink {

using robotcontrol::Request;

namespace {

constexpr int kMaxJointTargets = 100;

// ---- Problems with a request itself

std::string wrongKey(const Request& request) {
  using robotcontrol::KeyMode;
  const auto& key = request.set_key();
  const KeyMode& mode = key.mode();
  if (!KeyMode::Kind_IsValid(mode.kind())) return "there is no such mode of a debug key";
  const bool needsNumber = mode.kind() == KeyMode::EVERY_N || mode.kind() == KeyMode::EVERY_MS;
  if (needsNumber && mode.n() == 0) return "this mode of a debug key needs a number above 0";
  if (!packageOfKey(key.name()).empty() || DebugKey::find(key.name()) >= 0) return "";
  std::vector<std::string> all;
  for (const auto& each : SolutionRegistry::all()) all.push_back(shadowKey(each.task, each.name));
  if (std::ranges::find(all, key.name()) != all.end()) return "";
  for (const DebugKey::Entry& entry : DebugKey::all()) all.push_back(entry.name);
  const std::string near = nearest(key.name(), all);
  return "there is no debug key '" + key.name() + "'" +
         (near.empty() ? "" : "; did you mean '" + near + "'?");
}

bool isFinite(const robotcontrol::Pose2& pose) {
  return std::isfinite(pose.x()) && std::isfinite(pose.y()) && std::isfinite(pose.heading());
}

bool isFinite(const robotcontrol::ColorCorrection& c) {
  const auto lines = {c.y().gain(),    c.y().offset(), c.cb().gain(),
                      c.cb().offset(), c.cr().gain(),  c.cr().offset()};
  const auto curves = {c.luma_r2(), c.luma_r4(), c.blue_r2(), c.blue_r4(), c.red_r2(), c.red_r4()};
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::ranges::all_of(lines, finite) && std::ranges::all_of(curves, finite);
}

/// A table without cells takes back the one that was set.
std::string wrongColorTable(const Request& request) {
  return wrongWith(request.set_color_table().table());
}

/// A coordinate that is left out of a pose is 0, but a pose that is left out as a whole was forgotten.
std::string wrongGoal(const Request& request) {
  const robotcontrol::DriveGoal& goal = request.set_goal();
  if (!goal.cancelled() && !goal.has_pose_in_field()) return "the goal has no pose";
  return isFinite(goal.pose_in_field()) ? "" : "the goal's pose has values that are not numbers";
}

bool isFinite(const robotcontrol::RemoteMotion& motion) {
  const auto& walk = motion.motion().walk();
  const auto& head = motion.head();
  const auto isPosition = [](const auto& joint) { return std::isfinite(joint.position()); };
  if (!std::ranges::all_of(motion.motion().joints(), isPosition)) return false;
  const auto numbers = {walk.x(),   walk.y(),    walk.rotation(), head.tilt(),
                        head.pan(), head.roll(), head.mouth()};
  return std::ranges::all_of(numbers, [](double value) { return std::isfinite(value); });
}

std::string wrongMotion(const Request& request) {
  const robotcontrol::RemoteMotion& motion = request.motion();
  if (!robotcontrol::MotionRequest::Kind_IsValid(motion.motion().kind()) ||
      !robotcontrol::HeadMode::Kind_IsValid(motion.head().kind()))
    return "there is no such kind of motion";
  if (motion.motion().joints_size() > kMaxJointTargets)
    return "a request has angles for at most " + std::to_string(kMaxJointTargets) + " joints";
  return isFinite(motion) ? "" : "the motion has values that are not numbers";
}

/// A motion without a text takes back the one that was sent.
std::string wrongMotionText(const Request& request) {
  const auto& motion = request.set_motion().motion();
  if (motion.name().empty()) return "the motion that was sent has no name";
  return motion.text().size() <= MotionLibrary::kMaxTextBytes
             ? ""
             : "the text of a motion is at most " + std::to_string(MotionLibrary::kMaxTextBytes) +
                   " bytes long";
}

std::string wrongPlace(const Request& request) {
  const auto& place = request.place_model();
  if (!place.has_pose_in_field()) return "the request needs the pose at which to place the model";
  return isFinite(place.pose_in_field()) && std::isfinite(place.height()) && std::isfinite(place.roll()) &&
                 std::isfinite(place.pitch())
             ? ""
             : "the place's pose has values that are not numbers";
}

std::string wrongActuator(const Request& request) {
  const auto& set = request.set_actuator();
  if (set.released()) return "";
  if (set.port().empty()) return "the actuator is not named";
  if (set.values().empty()) return "the actuator " + set.port() + " needs at least one value";
  const auto isFiniteNumber = [](double value) { return std::isfinite(value); };
  return std::ranges::all_of(set.values(), isFiniteNumber)
             ? ""
             : "the values of the actuator " + set.port() + " are not all numbers";
}

std::string wrongPorts(const Request& request) {
  constexpr int kMaxPorts = 10'000;
  const auto& read = request.read_ports();
  if (read.ports().empty() && !read.ended()) return "the request names no port to read";
  return read.ports_size() <= kMaxPorts ? ""
                                        : "a request names at most " + std::to_string(kMaxPorts) + " ports";
}

std::string wrongEvent(const Request& request) {
  using robotcontrol::ViewEvent;
  const ViewEvent& event = request.send_event();
  if (!ViewEvent::Kind_IsValid(event.kind())) return "there is no such kind of event";
  const bool isOfKey = event.kind() == ViewEvent::KEY_PRESSED || event.kind() == ViewEvent::KEY_RELEASED;
  if (isOfKey) return event.key().empty() ? "an event of the keyboard needs a key" : "";
  return event.has_origin() && event.has_direction() ? ""
                                                     : "an event of the mouse needs origin and direction";
}

std::string wrongController(const Request& request) {
  constexpr int kMaxSensors = 1000, kMaxOutputs = 100;
  constexpr double kMaxPatience = 60;
  const auto& attached = request.attach_controller();
  if (attached.name().empty()) return "the controller has no name";
  if (attached.sensors_size() > kMaxSensors || attached.outputs_size() > kMaxOutputs)
    return "a controller has at most 1000 sensors and 100 outputs";
  const bool isPatience = attached.patience() >= 0 && attached.patience() <= kMaxPatience;
  return isPatience ? "" : "the patience of a controller is 0 to 60 s";
}

std::string wrongCommands(const Request& request) {
  constexpr int kMaxCommands = 1000;
  const auto& set = request.set_ports();
  if (set.controller().empty()) return "the controller is not named";
  return set.commands_size() <= kMaxCommands && set.outputs_size() <= kMaxCommands
             ? ""
             : "a controller sets at most 1000 ports at once";
}

/// A negative speed leaves the speed as it is, as does one that is left out.
std::string wrongSimulationSpeed(const Request& request) {
  const auto& control = request.control_simulation();
  return !control.has_speed() || control.speed() < 0 ? "" : wrongSpeed(control.speed(), kSimulationSpeeds);
}

std::string wrongCamera(const Request& request) {
  return std::isfinite(request.set_camera().value()) ? "" : "the value of a camera setting must be a number";
}

std::string wrongPackage(const Request& request) {
  using robotcontrol::SetPackage;
  const SetPackage& set = request.set_package();
  if (!SetPackage::Mode_IsValid(set.mode())) return "there is no such mode of setting a package";
  const auto& types = ownPackageTypes();
  const auto type = types.find(set.package());
  if (type == types.end()) {
    std::vector<std::string> all;
    for (const auto& [name, each] : types) all.push_back(name);
    const std::string near = nearest(set.package(), all);
    return "there is no package '" + set.package() + "' that can be set" +
           (near.empty() ? "" : "; did you mean '" + near + "'?");
  }
  if (set.mode() == SetPackage::RELEASE) return "";
  const std::string& name = type->second->full_name();
  if (set.value().type() != name)
    return "package " + set.package() + " is a " + name + ", not a '" + set.value().type() + "'";
  return parsedMessage(name, set.value().data()) ? ""
                                                 : "the value of package " + set.package() + " is damaged";
}

std::string wrongHosting(const Request& request) {
  const auto& wanted = request.host_program();
  if (!robotcontrol::HostProgram::Where_IsValid(wanted.where()))
    return "there is no such place for a program";
  return robotcontrol::HostProgram::Executor_IsValid(wanted.executor())
             ? ""
             : "there is no such mode of executing processes";
}

std::string wrongReplay(const Request& request) {
  const auto& control = request.control_replay();
  for (const auto& offset : control.offsets()) {
    if (!(std::abs(static_cast<double>(offset.offset())) <= 1e9 * kMaxLogOffset))
      return "a log cannot be shifted by more than 100 years";
  }
  return control.has_speed() ? wrongSpeed(control.speed(), kReplaySpeeds) : "";
}

// ---- The subject of a request

std::string keyOf(const Request& request) {
  return request.set_key().name();
}
std::string taskOf(const Request& request) {
  return request.select_solution().task();
}
std::string parametersOf(const Request& request) {
  return request.set_parameters().task() + '\n' + request.set_parameters().solution();
}
std::string motionOf(const Request& request) {
  return request.set_motion().motion().name();
}
/// A package that is sent once does not replace one that is held.
std::string packageSet(const Request& request) {
  const auto& set = request.set_package();
  return set.package() + (set.mode() == robotcontrol::SetPackage::ONCE ? "\nonce" : "");
}
std::string cameraSettingOf(const Request& request) {
  return request.set_camera().setting();
}
std::string sensorOfErrors(const Request& request) {
  return request.set_sensor_errors().sensor();
}
std::string doorMoved(const Request& request) {
  return request.move_door().door();
}
std::string theOnlyOne(const Request&) {
  return {};
}

// ---- The user's choice in a request

std::string solutionChosen(const Request& request) {
  return "solution " + request.select_solution().solution() + " of task " + request.select_solution().task();
}
std::string parametersChosen(const Request& request) {
  const auto& chosen = request.set_parameters();
  return "the parameters of " + chosen.task() +
         (chosen.solution().empty() ? "" : ", solution " + chosen.solution());
}
std::string tableChosen(const Request&) {
  return "the color table that was sent";
}
std::string motionChosen(const Request& request) {
  return "the motion " + motionOf(request) + " that was sent";
}
std::string goalChosen(const Request&) {
  return "its goal";
}

// ---- The task that it concerns

std::string taskOfGet(const Request& request) {
  return request.get_parameters().task();
}
std::string taskOfSet(const Request& request) {
  return request.set_parameters().task();
}

// ---- The file that it names

std::string fileOfRecording(const Request& request) {
  return request.control_recording().path();
}

// ---- Whether it removes what was chosen before

/// Off is the default, but of shadows, which a layout may have; and "n times" is over when the program ends.
bool keyEnds(const Request& request) {
  const auto kind = request.set_key().mode().kind();
  if (kind == robotcontrol::KeyMode::OFF && shadowOfKey(request.set_key().name())) return false;
  return kind == robotcontrol::KeyMode::OFF || kind == robotcontrol::KeyMode::N_TIMES;
}
bool tableIsBuiltIn(const Request& request) {
  return request.set_color_table().table().cells().empty();
}
bool motionIsOfFile(const Request& request) {
  return request.set_motion().motion().text().empty();
}
bool goalIsCancelled(const Request& request) {
  return request.set_goal().cancelled();
}
bool nothingIsRecorded(const Request& request) {
  return request.record_packages().packages().empty();
}

constexpr RequestKind kNothing{Request::WHAT_NOT_SET, RequestDoer::kNobody, "nothing"};

using Doer = RequestDoer;
using Effect = RequestEffect;

constexpr std::array<RequestKind, 36> kKinds{{
    {.what = Request::kSetKey,
     .doer = Doer::kDebugProcess,
     .words = "set key",
     .effect = Effect::kPublishing,
     .isOverride = true,
     .subject = keyOf,
     .wrong = wrongKey,
     .removes = keyEnds,
     .publishesTables = true},
    // Before the choice of solutions, which may read them when they are constructed.
    {.what = Request::kSetParameters,
     .doer = Doer::kTask,
     .words = "set parameters",
     .effect = Effect::kBehavior,
     .isOverride = true,
     .subject = parametersOf,
     .choice = parametersChosen,
     .task = taskOfSet},
    {.what = Request::kSelectSolution,
     .doer = Doer::kTask,
     .words = "select solution",
     .effect = Effect::kBehavior,
     .isOverride = true,
     .subject = taskOf,
     .choice = solutionChosen,
     .task = taskOf,
     .publishesTables = true},
    {.what = Request::kSetColorTable,
     .doer = Doer::kDebugProcess,
     .words = "set color table",
     .effect = Effect::kBehavior,
     .isOverride = true,
     .subject = theOnlyOne,
     .wrong = wrongColorTable,
     .choice = tableChosen,
     .removes = tableIsBuiltIn},
    {.what = Request::kSetMotion,
     .doer = Doer::kDebugProcess,
     .words = "set motion",
     .effect = Effect::kBehavior,
     .isOverride = true,
     .subject = motionOf,
     .wrong = wrongMotionText,
     .choice = motionChosen,
     .removes = motionIsOfFile},
    {.what = Request::kRecordPackages,
     .doer = Doer::kDebugProcess,
     .words = "record packages",
     .isOverride = true,
     .subject = theOnlyOne,
     .removes = nothingIsRecorded},
    {.what = Request::kGetParameters, .doer = Doer::kTask, .words = "get parameters", .task = taskOfGet},
    {.what = Request::kSendTables,
     .doer = Doer::kDebugProcess,
     .words = "send tables",
     .publishesTables = true},
    {.what = Request::kMotion,
     .doer = Doer::kDebugProcess,
     .words = "motion",
     .effect = Effect::kBehavior,
     .wrong = wrongMotion},
    {.what = Request::kSetGoal,
     .doer = Doer::kDebugProcess,
     .words = "set goal",
     .effect = Effect::kBehavior,
     .isContinued = true,
     .subject = theOnlyOne,
     .wrong = wrongGoal,
     .choice = goalChosen,
     .removes = goalIsCancelled},
    {.what = Request::kSetPackage,
     .doer = Doer::kDebugProcess,
     .words = "set package",
     .effect = Effect::kBehavior,
     .subject = packageSet,
     .wrong = wrongPackage,
     .publishesTables = true},
    {.what = Request::kStop, .doer = Doer::kPlatform, .words = "stop", .subject = theOnlyOne},
    {.what = Request::kControlDrive, .doer = Doer::kPlatform, .words = "control drive"},
    {.what = Request::kSetCamera,
     .doer = Doer::kPlatform,
     .words = "set camera",
     .subject = cameraSettingOf,
     .wrong = wrongCamera},
    {.what = Request::kControlSimulation,
     .doer = Doer::kSimulation,
     .words = "control simulation",
     .wrong = wrongSimulationSpeed},
    {.what = Request::kPlaceModel, .doer = Doer::kSimulation, .words = "place model", .wrong = wrongPlace},
    {.what = Request::kEditScene,
     .doer = Doer::kSimulation,
     .words = "edit scene",
     .wrong = wrongSceneEdit,
     .file = fileOfSceneEdit},
    {.what = Request::kSetLighting,
     .doer = Doer::kSimulation,
     .words = "set lighting",
     .subject = theOnlyOne},
    {.what = Request::kSetActuator,
     .doer = Doer::kSimulation,
     .words = "set actuator",
     .wrong = wrongActuator},
    {.what = Request::kReadPorts, .doer = Doer::kSimulation, .words = "read ports", .wrong = wrongPorts},
    {.what = Request::kSetSensorErrors,
     .doer = Doer::kSimulation,
     .words = "set sensor errors",
     .subject = sensorOfErrors},
    {.what = Request::kMoveDoor, .doer = Doer::kSimulation, .words = "move door", .subject = doorMoved},
    {.what = Request::kTurnModel, .doer = Doer::kSimulation, .words = "turn model", .wrong = wrongTurn},
    {.what = Request::kThrowModel, .doer = Doer::kSimulation, .words = "throw model", .wrong = wrongThrow},
    {.what = Request::kPinObject, .doer = Doer::kSimulation, .words = "pin object", .wrong = wrongPin},
    {.what = Request::kDragObject, .doer = Doer::kSimulation, .words = "drag object", .wrong = wrongDrag},
    {.what = Request::kPushObject, .doer = Doer::kSimulation, .words = "push object", .wrong = wrongPush},
    {.what = Request::kReadForces,
     .doer = Doer::kSimulation,
     .words = "read forces",
     .wrong = wrongForceReading},
    {.what = Request::kControlSnapshots,
     .doer = Doer::kSimulation,
     .words = "control snapshots",
     .wrong = wrongSnapshots,
     .file = fileOfSnapshot},
    {.what = Request::kSendEvent, .doer = Doer::kSimulation, .words = "send event", .wrong = wrongEvent},
    {.what = Request::kAttachController,
     .doer = Doer::kSimulation,
     .words = "attach controller",
     .wrong = wrongController},
    {.what = Request::kSetPorts, .doer = Doer::kSimulation, .words = "set ports", .wrong = wrongCommands},
    {.what = Request::kControlGame, .doer = Doer::kSimulation, .words = "control game", .wrong = wrongGame},
    {.what = Request::kHostProgram,
     .doer = Doer::kSimulation,
     .words = "host program",
     .wrong = wrongHosting},
    {.what = Request::kControlRecording,
     .doer = Doer::kRecording,
     .words = "control recording",
     .file = fileOfRecording},
    {.what = Request::kControlReplay, .doer = Doer::kReplay, .words = "control replay", .wrong = wrongReplay},
}};

}  // namespace

std::span<const RequestKind> requestKinds() {
  return kKinds;
}

const RequestKind& kindOf(const Request& request) {
  const auto found = std::ranges::find(kKinds, request.what_case(), &RequestKind::what);
  return found == kKinds.end() ? kNothing : *found;
}

std::string inWords(const Request& request) {
  const std::string words = kindOf(request).words;
  return request.robot().empty() ? words : words + " of " + request.robot();
}

std::string wrongWith(const Request& request) {
  const RequestKind& kind = kindOf(request);
  return kind.wrong != nullptr ? kind.wrong(request) : std::string();
}

std::string wrongFromElsewhere(const Request& request) {
  const RequestKind& kind = kindOf(request);
  if (kind.file == nullptr || kind.file(request).empty()) return "";
  return "files on this machine cannot be chosen remotely; leave out '" + kind.file(request) +
         "' to use the folder that was chosen there";
}

bool engagesStop(const Request& request) {
  return request.has_stop() && (!request.stop().has_engaged() || request.stop().engaged());
}

std::string wrongWith(const robotcontrol::ColorTable& table) {
  constexpr std::size_t kCells = std::size_t{64} * 64 * 64;
  if (table.cells().empty()) return "";
  if (table.cells().size() != kCells)
    return "a color table has " + std::to_string(kCells) + " cells, this one has " +
           std::to_string(table.cells().size());
  const auto known = [&](char cell) { return static_cast<unsigned char>(cell) <= table.class_names_size(); };
  if (!std::ranges::all_of(table.cells(), known))
    return "cells of the color table have classes without a name";
  return isFinite(table.correction()) ? "" : "the color table's correction has values that are not numbers";
}

std::string wrongSpeed(double speed, const SpeedRange& range) {
  // Written so that a NaN is out of range, too.
  if (speed >= range.min && speed <= range.max) return "";
  std::ostringstream text;
  text << "the speed must be between " << range.min << " and " << range.max << " times real time";
  return text.str();
}

bool setTheSame(const Request& a, const Request& b) {
  const RequestKind& kind = kindOf(a);
  return a.what_case() == b.what_case() && kind.subject != nullptr && kind.subject(a) == kind.subject(b);
}

}  // namespace robotlink
