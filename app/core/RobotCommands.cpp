// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/RobotCommands.h"

#include <algorithm>
#include <chrono>

#include "app/core/Workbench.h"
#include "app/core/program/ColorTables.h"
#include "app/core/program/CommandValues.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Conversions.h"

namespace app {
namespace {

using robotcontrol::KeyMode;
using robotcontrol::Request;
using robotlink::CommandTable;
using robotlink::Result;
using Type = CommandTable::Type;

/// Sends a request to the selected robot. Fails if there is no robot.
Result<void> ask(Workbench& workbench, Request request) {
  if (workbench.session().robots().empty()) {
    return robotlink::failure("robot.none", "there is no robot; open a scene or a log, or connect one first");
  }
  request.set_robot(workbench.session().selectedRobot());
  workbench.ask(std::move(request));
  return {};
}

Result<void> select(Workbench& workbench, const std::string& name) {
  const auto& robots = workbench.session().robots();
  if (std::find(robots.begin(), robots.end(), name) == robots.end()) {
    return robotlink::failure("robot.unknown", "there is no robot " + name, {}, {name});
  }
  workbench.session().selectRobot(name);
  return {};
}

Result<void> connect(Workbench& workbench, const Values& values) {
  PioneerOptions options{.url = text(values, 0)};
  if (!text(values, 1).empty()) options.layout = Workbench::layoutNamed(text(values, 1));
  options.map = text(values, 2);
  workbench.connectRobot(std::move(options));
  return {};
}

/// Reads the mode of a debug key: "off", "always", "n 3", "every 3" or "every-ms 40"; nothing if it is none
/// of these.
std::optional<KeyMode> modeOf(const std::string& words) {
  const auto space = words.find(' ');
  const std::string kind = words.substr(0, space);
  KeyMode mode;
  if (kind == "off" || kind == "always") {
    mode.set_kind(kind == "off" ? KeyMode::OFF : KeyMode::ALWAYS);
    return space == std::string::npos ? std::optional(mode) : std::nullopt;
  }
  const bool known = kind == "n" || kind == "every" || kind == "every-ms";
  const std::string count = space == std::string::npos ? "" : words.substr(space + 1);
  const bool digits = !count.empty() && count.size() < 8 &&
                      std::all_of(count.begin(), count.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!known || !digits) return std::nullopt;
  mode.set_kind(kind == "n" ? KeyMode::N_TIMES : kind == "every" ? KeyMode::EVERY_N : KeyMode::EVERY_MS);
  mode.set_n(static_cast<std::uint32_t>(std::stoul(count)));
  return mode;
}

Result<void> setKey(Workbench& workbench, const Values& values) {
  const auto mode = modeOf(text(values, 1));
  if (!mode) {
    return robotlink::failure("robot.key",
                              "a debug key's mode is off, always, 'n 3', 'every 3' or 'every-ms 40', not '" +
                                  text(values, 1) + "'");
  }
  Request request;
  request.mutable_set_key()->set_name(text(values, 0));
  *request.mutable_set_key()->mutable_mode() = *mode;
  return ask(workbench, std::move(request));
}

Result<void> setColorTable(Workbench& workbench, const std::string& file) {
  auto table = readColorTable(file);
  if (!table) return tl::unexpected(table.error());
  Request request;
  *request.mutable_set_color_table()->mutable_table() = std::move(**table);
  robotlink::assign(*request.mutable_set_color_table()->mutable_table()->mutable_loaded(),
                    robotlink::Instant(std::chrono::system_clock::now().time_since_epoch()));
  return ask(workbench, std::move(request));
}

void addForAll(CommandTable& commands, Workbench& workbench) {
  commands.add({"robot.connect",
                "Connects a Pioneer over TCP or a serial line and runs its program here; it stays connected "
                "until something "
                "else is opened",
                {{"address", Type::kText, "HOST:PORT, tcp://HOST[:PORT] or serial://DEVICE[?baud=RATE]"},
                 {"layout", Type::kText, "a layout file or the name of a shipped one; empty: the Pioneer's"},
                 {"map", Type::kText, "a map (.map) of where it drives; empty: none"}},
                [&workbench](const Values& values) { return connect(workbench, values); }});
  commands.add({"robot.connect-now",
                "Reconnects to the robot now instead of after a pause; its program keeps running",
                {},
                [&workbench](const Values&) { return workbench.connectNow(); }});
  commands.add({"robot.select",
                "Selects the robot that toolbars and views show",
                {{"robot", Type::kText, "its name"}},
                [&workbench](const Values& values) { return select(workbench, text(values, 0)); }});
  commands.add(
      {"robot.stop",
       "Engages or releases STOP for all robots: their platforms hold them, whatever the programs do",
       {{"engaged", Type::kBool, "true engages, false releases"}},
       [&workbench](const Values& values) -> Result<void> {
         for (const std::string& robot : workbench.session().robots()) {
           Request request;
           request.set_robot(robot);
           request.mutable_stop()->set_engaged(flag(values, 0));
           workbench.session().request(request);
         }
         return {};
       }});
}

void addForProgram(CommandTable& commands, Workbench& workbench) {
  commands.add({"robot.key",
                "Sets a debug key of the selected robot's program",
                {{"key", Type::kText, "its name, as in the view of debug keys"},
                 {"mode", Type::kText, "off, always, 'n 3' (times), 'every 3' (frames) or 'every-ms 40'"}},
                [&workbench](const Values& values) { return setKey(workbench, values); }});
  commands.add({"robot.solution",
                "Switches the solution of a task of the selected robot's program",
                {{"task", Type::kText, "its name"}, {"solution", Type::kText, "its name"}},
                [&workbench](const Values& values) {
                  Request request;
                  request.mutable_select_solution()->set_task(text(values, 0));
                  request.mutable_select_solution()->set_solution(text(values, 1));
                  return ask(workbench, std::move(request));
                }});
  commands.add({"robot.color-table",
                "Sends a color table to the selected robot's program, which uses it from its next image on",
                {{"file", Type::kText, "a color table: .c64, or another team's"}},
                [&workbench](const Values& values) { return setColorTable(workbench, text(values, 0)); }});
  commands.add({"robot.no-color-table",
                "Switches the selected robot's program back to its built-in color table",
                {},
                [&workbench](const Values&) {
                  Request request;
                  request.mutable_set_color_table();
                  return ask(workbench, std::move(request));
                }});
}

void addForDrive(CommandTable& commands, Workbench& workbench) {
  commands.add({"robot.goal",
                "Sends the selected robot to a place, if it has wheels",
                {{"x", Type::kNumber, "m, in the map's frame"}, {"y", Type::kNumber, "m"}},
                [&workbench](const Values& values) {
                  Request request;
                  request.mutable_set_goal()->mutable_pose_in_field()->set_x(number(values, 0));
                  request.mutable_set_goal()->mutable_pose_in_field()->set_y(number(values, 1));
                  request.mutable_set_goal()->set_any_heading(true);
                  return ask(workbench, std::move(request));
                }});
  commands.add({"robot.no-goal", "Cancels the selected robot's goal", {}, [&workbench](const Values&) {
                  Request request;
                  request.mutable_set_goal()->set_cancelled(true);
                  return ask(workbench, std::move(request));
                }});
  const auto addSwitch = [&](const char* name, const char* help,
                             void (*set)(robotcontrol::ControlDrive&, bool)) {
    commands.add(
        {name, help, {{"on", Type::kBool, "true: on, false: off"}}, [&workbench, set](const Values& values) {
           Request request;
           set(*request.mutable_control_drive(), flag(values, 0));
           return ask(workbench, std::move(request));
         }});
  };
  addSwitch("robot.motors", "Switches the motors of the selected robot on wheels",
            [](auto& details, bool on) { details.set_motors(on); });
  addSwitch("robot.sonars", "Switches the sonars of the selected robot on wheels",
            [](auto& details, bool on) { details.set_sonar(on); });
}

}  // namespace

void addRobotCommands(Workbench& workbench) {
  addForAll(workbench.commands(), workbench);
  addForProgram(workbench.commands(), workbench);
  addForDrive(workbench.commands(), workbench);
}

}  // namespace app
