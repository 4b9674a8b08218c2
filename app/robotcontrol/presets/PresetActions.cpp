// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/presets/PresetActions.h"

#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/RobotTables.h"
#include "widgets/solutions/ParameterEdits.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Preset;
using robotlink::Result;
using Values = robotlink::CommandTable::Values;

constexpr char kAllParts[] = "all";

/// The robot reports them only on request, and a preset is to change no key.
constexpr char kUnknownCamera[] =
    "the settings of the camera are not known; open the view Camera, or switch on the key "
    "package/camera/settings";

std::string argument(const Values& values, std::size_t index) {
  return std::get<std::string>(values[index]);
}

/// "keys,views" or "all"
Result<std::vector<Preset::Part>> partsOf(const std::string& words) {
  std::vector<Preset::Part> parts;
  for (std::size_t at = 0; at <= words.size();) {
    const std::size_t end = std::min(words.find(',', at), words.size());
    const std::string word = words.substr(at, end - at);
    at = end + 1;
    for (int i = 0; i < Preset::kParts; ++i) {
      if (word == kAllParts || word == Preset::kPartNames[static_cast<std::size_t>(i)])
        parts.push_back(static_cast<Preset::Part>(i));
    }
    const bool isKnown =
        word == kAllParts || std::ranges::find(Preset::kPartNames, word) != Preset::kPartNames.end();
    if (!isKnown)
      return failure(
          "preset.part",
          "the parts of a preset are keys, solutions, parameters, views and camera, not '" + word + "'");
  }
  return parts;
}

std::vector<Preset::Part> partsIn(const Preset& preset) {
  std::vector<Preset::Part> parts;
  for (int i = 0; i < Preset::kParts; ++i) {
    if (preset.parts[static_cast<std::size_t>(i)]) parts.push_back(static_cast<Preset::Part>(i));
  }
  return parts;
}

Result<void> firstError(const robotlink::Errors& errors) {
  if (errors.empty()) return {};
  robotlink::Error first = errors.front();
  if (errors.size() > 1) first.text += " (and " + std::to_string(errors.size() - 1) + " more)";
  return tl::unexpected(first);
}

}  // namespace

PresetActions::PresetActions(robotlink::CommandTable& commands, robotlink::Session& session,
                             widgets::ParameterEdits& parameters, std::filesystem::path folder, Views views,
                             QObject* parent)
    : QObject(parent),
      commands_(commands),
      session_(session),
      parameters_(parameters),
      presets_(std::move(folder)),
      views_(std::move(views)) {
  if (!commands_.isAttached("preset.save")) attach();
}

void PresetActions::attach() {
  using Run = std::function<Result<void>(PresetActions&, const Values&)>;
  const auto attach = [this](const char* name, Run run) {
    const auto act = [run = std::move(run), guard = QPointer(this)](const Values& values) -> Result<void> {
      if (guard) return run(*guard, values);
      return failure("window.closed", "the window is closed");
    };
    commands_.attach(name, act, [guard = QPointer(this)](const auto& before) {
      return guard && before.empty() ? guard->presets_.names() : std::vector<std::string>();
    });
  };
  attach("preset.save", [](PresetActions& to, const Values& values) {
    return partsOf(argument(values, 1)).and_then([&](const auto& parts) {
      return to.save(argument(values, 0), parts);
    });
  });
  attach("preset.load", [](PresetActions& to, const Values& values) {
    return to.named(argument(values, 0)).and_then([&](const Preset& preset) { return to.load(preset); });
  });
  attach("preset.diff", [](PresetActions& to, const Values& values) -> Result<void> {
    const auto preset = to.named(argument(values, 0));
    if (!preset) return tl::unexpected(preset.error());
    to.compare(*preset, [&to, name = argument(values, 0)](const auto& lines) {
      std::string listed = lines ? std::string() : lines.error().describe();
      for (const std::string& line : lines.value_or(std::vector<std::string>())) listed += "\n" + line;
      if (!listed.empty()) to.session_.reportRefusal("preset " + name, "differs: " + listed);
    });
    return {};
  });
  attach("preset.delete",
         [](PresetActions& to, const Values& values) { return to.remove(argument(values, 0)); });
  attach("preset.rename", [](PresetActions& to, const Values& values) {
    return to.rename(argument(values, 0), argument(values, 1));
  });
}

Result<void> PresetActions::changing(Result<void> done) {
  if (done) Q_EMIT changed();
  return done;
}

Result<Preset> PresetActions::named(const std::string& name) const {
  const bool isFile = name.find('/') != std::string::npos || name.ends_with(".json");
  return isFile ? robotlink::Presets::loadFile(name) : presets_.load(name);
}

void PresetActions::requestTables(std::function<void(const Result<void>&)> done) {
  robotcontrol::Request request;
  request.set_robot(session_.selectedRobot());
  request.mutable_send_tables();
  session_.request(std::move(request), [guard = QPointer(this), done = std::move(done)](const auto& result) {
    if (!guard) return;
    done(result.accepted() ? Result<void>() : failure("preset.tables", result.reason()));
  });
}

void PresetActions::capture(const std::vector<Preset::Part>& parts,
                            std::function<void(Result<Preset>)> done) {
  const bool needsTables = std::ranges::any_of(
      parts, [](Preset::Part part) { return part != Preset::kParameters && part != Preset::kViews; });
  if (!needsTables || session_.selectedRobot().empty()) return captureNow(parts, std::move(done));
  // A program that has begun just now reports process by process. What has no program, such as a log without
  // one, refuses; then what was logged counts.
  requestTables([this, parts, done = std::move(done)](const auto&) { captureNow(parts, done); });
}

void PresetActions::captureNow(const std::vector<Preset::Part>& parts,
                               std::function<void(Result<Preset>)> done) {
  Preset now;
  const auto has = [&](Preset::Part part) { return std::ranges::find(parts, part) != parts.end(); };
  if (has(Preset::kKeys)) now.parts[Preset::kKeys] = robotlink::keysThatAreOn(session_);
  if (has(Preset::kSolutions)) now.parts[Preset::kSolutions] = robotlink::activeSolutions(session_);
  if (has(Preset::kViews)) now.parts[Preset::kViews] = views_.now();
  if (has(Preset::kCamera)) now.parts[Preset::kCamera] = robotlink::cameraSettings(session_);
  if (!has(Preset::kParameters)) return done(std::move(now));
  parameters_.requestChanges([now = std::move(now), done = std::move(done)](auto changes) mutable {
    if (!changes) return done(tl::unexpected(changes.error()));
    now.parts[Preset::kParameters] = std::move(*changes);
    done(std::move(now));
  });
}

Result<void> PresetActions::save(const std::string& name, const std::vector<Preset::Part>& parts) {
  const bool isFile = name.find('/') != std::string::npos;
  // An invalid name fails at once.
  if (const auto known = presets_.load(name); !isFile && !known && known.error().id == "preset.name")
    return tl::unexpected(known.error());
  capture(parts, [guard = QPointer(this), name, isFile, parts](Result<Preset> now) {
    if (!guard) return;
    // A robot without a camera must not keep anybody from saving everything.
    if (now && parts == std::vector{Preset::kCamera} && !now->parts[Preset::kCamera])
      now = failure("preset.camera", kUnknownCamera);
    const auto saved = !now     ? Result<void>(tl::unexpected(now.error()))
                       : isFile ? robotlink::Presets::saveFile(name, *now)
                                : guard->presets_.save(name, *now);
    if (!guard->changing(saved)) guard->session_.reportRefusal("preset " + name, saved.error().describe());
  });
  return {};
}

void PresetActions::compare(const Preset& preset,
                            std::function<void(Result<std::vector<std::string>>)> done) {
  capture(partsIn(preset), [preset, done = std::move(done)](const Result<Preset>& now) {
    if (!now) return done(tl::unexpected(now.error()));
    std::vector<std::string> lines = robotlink::differences(*now, preset);
    if (preset.parts[Preset::kCamera] && !now->parts[Preset::kCamera])
      lines.push_back(std::string("camera: ") + kUnknownCamera);
    done(std::move(lines));
  });
}

Result<void> PresetActions::load(const Preset& preset) {
  const auto parts = partsIn(preset);
  const bool isOfRobot = std::ranges::any_of(parts, [](Preset::Part part) { return part != Preset::kViews; });
  if (!isOfRobot) return loadNow(preset);
  if (session_.selectedRobot().empty())
    return failure("robot.none", "there is no robot; open a scene or a log, or connect one first");
  // The program must report its tables first, since they tell what has to be switched off.
  requestTables([this, preset](const Result<void>& reported) {
    const auto done = reported ? loadNow(preset) : reported;
    if (!done) session_.reportRefusal("preset", done.error().describe());
  });
  return {};
}

Result<void> PresetActions::loadNow(const Preset& preset) {
  robotlink::Errors errors;
  const auto& parts = preset.parts;
  if (parts[Preset::kSolutions]) loadSolutions(*parts[Preset::kSolutions], errors);
  if (parts[Preset::kParameters]) loadParameters(*parts[Preset::kParameters], errors);
  if (parts[Preset::kKeys]) loadKeys(*parts[Preset::kKeys], errors);
  if (parts[Preset::kCamera]) loadCamera(*parts[Preset::kCamera], errors);
  if (parts[Preset::kViews]) {
    if (const auto shown = views_.show(*parts[Preset::kViews]); !shown) errors.push_back(shown.error());
  }
  return firstError(errors);
}

void PresetActions::run(const std::string& command, const std::vector<std::string>& arguments,
                        robotlink::Errors& errors) {
  const auto done = commands_.run(command, Values(arguments.begin(), arguments.end()));
  if (!done) errors.push_back(done.error());
}

void PresetActions::loadKeys(const Preset::Values& wanted, robotlink::Errors& errors) {
  const Preset::Values now = robotlink::keysThatAreOn(session_);
  for (const auto& [key, mode] : now) {
    if (!wanted.contains(key)) run("robot.key", {key, "off"}, errors);
  }
  for (const auto& [key, mode] : wanted) {
    const auto found = now.find(key);
    if (found == now.end() || found->second != mode) run("robot.key", {key, mode}, errors);
  }
}

void PresetActions::loadSolutions(const Preset::Values& wanted, robotlink::Errors& errors) {
  const auto* table = robotlink::solutionTable(session_);
  Preset::Values all = wanted;
  for (int i = 0; table != nullptr && i < table->tasks_size(); ++i)
    all.emplace(table->tasks(i).name(), table->tasks(i).default_solution());
  const Preset::Values now = robotlink::activeSolutions(session_);
  for (const auto& [task, solution] : all) {
    const auto found = now.find(task);
    if (!solution.empty() && (found == now.end() || found->second != solution))
      run("robot.solution", {task, solution}, errors);
  }
}

void PresetActions::loadParameters(const Preset::Values& wanted, robotlink::Errors& errors) {
  run("parameters.reset", {}, errors);
  for (const auto& [name, value] : wanted) {
    const auto space = name.find(' ');
    const std::string path = space == std::string::npos ? std::string() : name.substr(space + 1);
    run("robot.parameter", {name.substr(0, space), path, value}, errors);
  }
}

void PresetActions::loadCamera(const Preset::Values& wanted, robotlink::Errors& errors) {
  std::map<std::string, double> values;
  const auto* known = session_.store().latestAs<robotcontrol::CameraSettings>(
      session_.selectedRobot() + "/" + robotlink::kCameraSettings.name, robotlink::Instant::max());
  for (int i = 0; known != nullptr && i < known->settings_size(); ++i)
    values[known->settings(i).name()] = known->settings(i).initial();
  for (const auto& [setting, text] : wanted) {
    if (const auto value = robotlink::parsedNumber<double>(text)) values[setting] = *value;
  }
  for (const auto& [setting, value] : values) {
    const auto done = commands_.run("robot.camera", {setting, value});
    if (!done) errors.push_back(done.error());
  }
}

}  // namespace app
