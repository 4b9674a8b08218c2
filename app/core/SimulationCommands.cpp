// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/SimulationCommands.h"

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "app/core/simulated/SimulationFeed.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/RequestKinds.h"

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

Result<void> pressKey(OpenPlatform& open, const std::string& key) {
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
  commands.attach("simulation.speed",
                  [&open](const Values& values) { return setSimulationSpeed(open, number(values, 0)); });
  commands.attach("simulation.noise",
                  [&open](const Values& values) { return setNoise(open, flag(values, 0)); });
  commands.attach("simulation.sensor-errors", [&open](const Values& values) -> Result<void> {
    robotcontrol::Request request;
    robotcontrol::SetSensorErrors& errors = *request.mutable_set_sensor_errors();
    errors.set_sensor(text(values, 0));
    errors.set_noise(number(values, 1));
    errors.set_bias(number(values, 2));
    errors.set_delay(number(values, 3));
    errors.set_rate(number(values, 4));
    errors.set_dropout(number(values, 5));
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
