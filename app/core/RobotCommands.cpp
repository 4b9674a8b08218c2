// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/RobotCommands.h"

#include <algorithm>
#include <chrono>

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "app/core/program/ColorTables.h"
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
Result<void> ask(OpenPlatform& open, Request request) {
  if (open.session().robots().empty()) {
    return robotlink::failure("robot.none", "there is no robot; open a scene or a log, or connect one first");
  }
  request.set_robot(open.session().selectedRobot());
  open.ask(std::move(request));
  return {};
}

Result<void> select(OpenPlatform& open, const std::string& name) {
  const auto& robots = open.session().robots();
  if (std::ranges::find(robots, name) == robots.end()) {
    return robotlink::failure("robot.unknown", "there is no robot " + name, {}, {name});
  }
  open.session().selectRobot(name);
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
                      std::ranges::all_of(count, [](char c) { return c >= '0' && c <= '9'; });
  if (!known || !digits) return std::nullopt;
  mode.set_kind(kind == "n" ? KeyMode::N_TIMES : kind == "every" ? KeyMode::EVERY_N : KeyMode::EVERY_MS);
  mode.set_n(static_cast<std::uint32_t>(std::stoul(count)));
  return mode;
}

Result<void> setKey(OpenPlatform& open, const Values& values) {
  const auto mode = modeOf(text(values, 1));
  if (!mode) {
    return robotlink::failure("robot.key",
                              "a debug key's mode is off, always, 'n 3', 'every 3' or 'every-ms 40', not '" +
                                  text(values, 1) + "'");
  }
  Request request;
  request.mutable_set_key()->set_name(text(values, 0));
  *request.mutable_set_key()->mutable_mode() = *mode;
  return ask(open, std::move(request));
}

Result<void> setColorTable(OpenPlatform& open, const std::string& file) {
  auto table = readColorTable(file);
  if (!table) return tl::unexpected(table.error());
  Request request;
  *request.mutable_set_color_table()->mutable_table() = std::move(**table);
  robotlink::assign(*request.mutable_set_color_table()->mutable_table()->mutable_loaded(),
                    robotlink::Instant(std::chrono::system_clock::now().time_since_epoch()));
  return ask(open, std::move(request));
}

void addForAll(CommandTable& commands, OpenPlatform& open) {
  commands.add({"robot.connect-now",
                "Reconnects to the robot now instead of after a pause; its program keeps running",
                {},
                [&open](const Values&) { return open.connectNow(); }});
  commands.add({"robot.select",
                "Selects the robot that toolbars and views show",
                {{"robot", Type::kText, "its name"}},
                [&open](const Values& values) { return select(open, text(values, 0)); }});
  commands.add(
      {"robot.stop",
       "Engages or releases STOP for all robots: their platforms hold them, whatever the programs do",
       {{"engaged", Type::kBool, "true engages, false releases"}},
       [&open](const Values& values) -> Result<void> {
         for (const std::string& robot : open.session().robots()) {
           Request request;
           request.set_robot(robot);
           request.mutable_stop()->set_engaged(flag(values, 0));
           open.session().request(request);
         }
         return {};
       }});
}

void addForProgram(CommandTable& commands, OpenPlatform& open) {
  commands.add({"robot.key",
                "Sets a debug key of the selected robot's program",
                {{"key", Type::kText, "its name, as in the view of debug keys"},
                 {"mode", Type::kText, "off, always, 'n 3' (times), 'every 3' (frames) or 'every-ms 40'"}},
                [&open](const Values& values) { return setKey(open, values); }});
  commands.add({"robot.solution",
                "Switches the solution of a task of the selected robot's program",
                {{"task", Type::kText, "its name"}, {"solution", Type::kText, "its name"}},
                [&open](const Values& values) {
                  Request request;
                  request.mutable_select_solution()->set_task(text(values, 0));
                  request.mutable_select_solution()->set_solution(text(values, 1));
                  return ask(open, std::move(request));
                }});
  commands.add({"robot.color-table",
                "Sends a color table to the selected robot's program, which uses it from its next image on",
                {{"file", Type::kText, "a color table: .c64, or another team's"}},
                [&open](const Values& values) { return setColorTable(open, text(values, 0)); }});
  commands.add({"robot.no-color-table",
                "Switches the selected robot's program back to its built-in color table",
                {},
                [&open](const Values&) {
                  Request request;
                  request.mutable_set_color_table();
                  return ask(open, std::move(request));
                }});
}

void addForDrive(CommandTable& commands, OpenPlatform& open) {
  commands.add({"robot.goal",
                "Sends the selected robot to a place, if it has wheels",
                {{"x", Type::kNumber, "m, in the map's frame"}, {"y", Type::kNumber, "m"}},
                [&open](const Values& values) {
                  Request request;
                  request.mutable_set_goal()->mutable_pose_in_field()->set_x(number(values, 0));
                  request.mutable_set_goal()->mutable_pose_in_field()->set_y(number(values, 1));
                  request.mutable_set_goal()->set_any_heading(true);
                  return ask(open, std::move(request));
                }});
  commands.add({"robot.no-goal", "Cancels the selected robot's goal", {}, [&open](const Values&) {
                  Request request;
                  request.mutable_set_goal()->set_cancelled(true);
                  return ask(open, std::move(request));
                }});
  const auto addSwitch = [&](const char* name, const char* help,
                             void (*set)(robotcontrol::ControlDrive&, bool)) {
    commands.add(
        {name, help, {{"on", Type::kBool, "true: on, false: off"}}, [&open, set](const Values& values) {
           Request request;
           set(*request.mutable_control_drive(), flag(values, 0));
           return ask(open, std::move(request));
         }});
  };
  addSwitch("robot.motors", "Switches the motors of the selected robot on wheels",
            [](auto& details, bool on) { details.set_motors(on); });
  addSwitch("robot.sonars", "Switches the sonars of the selected robot on wheels",
            [](auto& details, bool on) { details.set_sonar(on); });
}

}  // namespace

void addRobotCommands(CommandTable& commands, OpenPlatform& open) {
  addForAll(commands, open);
  addForProgram(commands, open);
  addForDrive(commands, open);
}

}  // namespace app
