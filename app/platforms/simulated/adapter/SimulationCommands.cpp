// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/adapter/SimulationCommands.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

using Control = robotcontrol::ControlSimulation;
using robotlink::CommandTable;
using robotlink::Result;

/// Requests an action; a negative speed leaves the speed as it is.
Result<void> control(OpenPlatform& open, Control::Action action, double speed = -1) {
  robotcontrol::Request request;
  request.mutable_control_simulation()->set_action(action);
  request.mutable_control_simulation()->set_speed(speed);
  open.ask(std::move(request));
  return {};
}

Result<void> setSimulationSpeed(OpenPlatform& open, double speed) {
  const std::string wrong = robotlink::wrongSpeed(speed, robotlink::kSimulationSpeeds);
  if (!wrong.empty()) return robotlink::failure("simulation.speed", wrong);
  return control(open, Control::UNCHANGED, speed);
}

using Snapshots = robotcontrol::ControlSnapshots;

/// Whether a word of a command means a file instead of a snapshot in memory.
bool isSnapshotFile(const std::string& name) {
  return name.find('/') != std::string::npos || std::filesystem::path(name).extension() == ".snapshot";
}

/// Sets a name or a file, whose path is made absolute, since the request may be fulfilled elsewhere.
void nameSnapshot(Snapshots& control, const std::string& name) {
  if (!isSnapshotFile(name)) return control.set_name(name);
  std::error_code ignored;
  const auto absolute = std::filesystem::absolute(name, ignored);
  control.set_file(ignored ? name : absolute.string());
}

Result<void> controlSnapshots(OpenPlatform& open, Snapshots control) {
  robotcontrol::Request request;
  *request.mutable_control_snapshots() = std::move(control);
  if (const std::string wrong = robotlink::wrongWith(request); !wrong.empty())
    return robotlink::failure("simulation.snapshot", wrong);
  open.ask(std::move(request));
  return {};
}

/// The names of the snapshots in memory.
std::vector<std::string> snapshotNames(OpenPlatform& open) {
  std::vector<std::string> names;
  const auto* status = open.session().store().latestAs<robotcontrol::SimulationStatus>(
      robotlink::streams::kSimulation, open.session().timeline().newest());
  for (int i = 0; status != nullptr && i < status->snapshots_size(); ++i)
    names.push_back(status->snapshots(i).name());
  return names;
}

void addSnapshotCommands(CommandTable& commands, OpenPlatform& open) {
  const auto names = [&open](const auto& before) {
    return before.empty() ? snapshotNames(open) : std::vector<std::string>();
  };
  const auto named = [&](const char* command, Snapshots::Action action) {
    commands.attach(
        command,
        [&open, action](const Values& values) {
          Snapshots control;
          control.set_action(action);
          nameSnapshot(control, text(values, 0));
          if (action == Snapshots::RESTORE) control.set_programs(flag(values, 1));
          return controlSnapshots(open, std::move(control));
        },
        names);
  };
  named("simulation.snapshot", Snapshots::TAKE);
  named("simulation.restore", Snapshots::RESTORE);
  commands.attach(
      "simulation.forget",
      [&open](const Values& values) {
        Snapshots control;
        control.set_action(Snapshots::FORGET);
        control.set_name(text(values, 0));
        return controlSnapshots(open, std::move(control));
      },
      names);
  commands.attach("simulation.rewind", [&open](const Values& values) {
    Snapshots control;
    control.set_action(Snapshots::REWIND);
    control.set_seconds(number(values, 0));
    return controlSnapshots(open, std::move(control));
  });
  commands.attach("simulation.cancel", [&open](const Values&) {
    Snapshots control;
    control.set_action(Snapshots::CANCEL);
    return controlSnapshots(open, std::move(control));
  });
}

/// Opens the simulation that runs again, since a world gets its noise when it is made.
Result<void> setNoise(OpenPlatform& open, bool on) {
  const LoadedPlatform* loaded = open.loaded();
  if (loaded == nullptr || loaded->adapter != SimulationFeed::kAdapter || loaded->sources.empty())
    return robotlink::failure("simulation.none", "there is no simulation; open a scene first");
  open.open(SimulationFeed::opening(loaded->sources.front(),
                                    [on](RunOptions& options) { options.world.noise = on; }));
  return {};
}

void sendEvent(OpenPlatform& open, const robotcontrol::ViewEvent& event) {
  robotcontrol::Request request;
  *request.mutable_send_event() = event;
  open.ask(std::move(request));
}

/// Whether a text is a single character in UTF-8.
bool isCharacter(const std::string& text) {
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  return !text.empty() && std::ranges::count_if(text, continues) == std::ssize(text) - 1 &&
         !continues(text[0]);
}

/// Keys are named as the Scene view does.
Result<void> pressKey(OpenPlatform& open, const std::string& key) {
  static const std::vector<std::string> kKeys{"Space",     "Left",  "Right", "Up",   "Down",
                                              "Return",    "Enter", "Tab",   "Home", "End",
                                              "Backspace", "Del",   "Ins",   "PgUp", "PgDown"};
  if (!isCharacter(key) && std::ranges::find(kKeys, key) == kKeys.end())
    return robotlink::failure("simulation.key",
                              "there is no key '" + key + "'" + robotlink::suggestion(key, kKeys) +
                                  "; others are named by their character, such as A or 1",
                              {}, {key});
  robotcontrol::ViewEvent event;
  event.set_view("command");
  event.set_key(key);
  sendEvent(open, event);
  event.set_kind(robotcontrol::ViewEvent::KEY_RELEASED);
  sendEvent(open, event);
  return {};
}

Result<void> clickAt(OpenPlatform& open, const Values& values) {
  robotcontrol::ViewEvent event;
  event.set_view("command");
  event.set_button(1);
  event.set_kind(robotcontrol::ViewEvent::MOUSE_PRESSED);
  event.mutable_origin()->set_x(number(values, 0));
  event.mutable_origin()->set_y(number(values, 1));
  event.mutable_origin()->set_z(number(values, 2));
  event.mutable_direction()->set_x(number(values, 3) - number(values, 0));
  event.mutable_direction()->set_y(number(values, 4) - number(values, 1));
  event.mutable_direction()->set_z(number(values, 5) - number(values, 2));
  sendEvent(open, event);
  event.set_kind(robotcontrol::ViewEvent::MOUSE_RELEASED);
  sendEvent(open, event);
  return {};
}

}  // namespace

void addSimulationCommands(CommandTable& commands, OpenPlatform& open) {
  const auto action = [&](const char* name, Control::Action what) {
    commands.attach(name, [&open, what](const Values&) { return control(open, what); });
  };
  action("simulation.start", Control::START);
  action("simulation.pause", Control::PAUSE);
  action("simulation.step", Control::STEP);
  action("simulation.reset", Control::RESET);
  addSnapshotCommands(commands, open);
  commands.attach("simulation.speed",
                  [&open](const Values& values) { return setSimulationSpeed(open, number(values, 0)); });
  commands.attach("simulation.noise",
                  [&open](const Values& values) { return setNoise(open, flag(values, 0)); });
  commands.attach("simulation.sensor-errors", [&open](const Values& values) -> Result<void> {
    robotcontrol::Request request;
    robotcontrol::SetSensorErrors& errors = *request.mutable_set_sensor_errors();
    errors.set_sensor(text(values, 0));
    constexpr void (robotcontrol::SetSensorErrors::*kSetters[])(double) = {
        &robotcontrol::SetSensorErrors::set_noise,      &robotcontrol::SetSensorErrors::set_bias,
        &robotcontrol::SetSensorErrors::set_delay,      &robotcontrol::SetSensorErrors::set_rate,
        &robotcontrol::SetSensorErrors::set_dropout,    &robotcontrol::SetSensorErrors::set_drift,
        &robotcontrol::SetSensorErrors::set_drift_time, &robotcontrol::SetSensorErrors::set_precision};
    for (std::size_t i = 1; i < values.size(); ++i) {
      if (!std::isnan(number(values, i))) (errors.*kSetters[i - 1])(number(values, i));
    }
    open.ask(std::move(request));
    return {};
  });
  commands.attach("simulation.door", [&open](const Values& values) -> Result<void> {
    robotcontrol::Request request;
    request.mutable_move_door()->set_door(text(values, 0));
    request.mutable_move_door()->set_open(text(values, 1) == "open");
    open.ask(std::move(request));
    return {};
  });
  commands.attach("simulation.key",
                  [&open](const Values& values) { return pressKey(open, text(values, 0)); });
  commands.attach("simulation.click", [&open](const Values& values) { return clickAt(open, values); });
  commands.attach("simulation.light", [&open](const Values& values) -> Result<void> {
    robotcontrol::Request request;
    request.mutable_set_lighting()->set_brightness(number(values, 0));
    request.mutable_set_lighting()->set_warmth(number(values, 1));
    open.ask(std::move(request));
    return {};
  });
}

}  // namespace app
