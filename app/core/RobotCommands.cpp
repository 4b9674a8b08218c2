// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/RobotCommands.h"

#include <algorithm>
#include <chrono>

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "app/core/program/ColorTables.h"
#include "foxglove/Grid.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GridConversions.h"
#include "robotlink/packages/MapPackages.h"
#include "robotlink/packages/PackageJson.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/KeyModes.h"
#include "robotlink/session/RobotTables.h"
#include "robotlink/session/RobotTeams.h"

namespace app {
namespace {

using robotcontrol::Request;
using robotlink::CommandTable;
using robotlink::Result;

Result<void> requireRobot(OpenPlatform& open, const std::string& name) {
  const auto& robots = open.session().robots();
  if (std::ranges::find(robots, name) != robots.end()) return {};
  return robotlink::failure("robot.unknown",
                            "there is no robot " + name + robotlink::suggestion(name, robots), {}, {name});
}

Result<void> select(OpenPlatform& open, const std::string& name) {
  if (auto known = requireRobot(open, name); !known) return known;
  open.session().selectRobot(name);
  return {};
}

/// Stands for every robot where commands name one.
constexpr char kAll[] = "all";

/// The selected robot if `whose` is empty, all robots, the one of this name, or those of this team. Fails if
/// there are none.
Result<std::vector<std::string>> robotsMeant(OpenPlatform& open, const std::string& whose) {
  const auto& robots = open.session().robots();
  if (robots.empty())
    return robotlink::failure("robot.none", "there is no robot; open a scene or a log, or connect one first");
  if (whose.empty()) return std::vector<std::string>{open.session().selectedRobot()};
  if (whose == kAll) return robots;
  auto named = robotlink::robotsNamed(open.session(), whose);
  if (!named.empty()) return named;
  return robotlink::failure("robot.unknown",
                            "there is no robot or team " + whose +
                                robotlink::suggestion(whose, robotlink::robotAndTeamNames(open.session())),
                            {}, {whose});
}

/// Sends a request to each of robotsMeant().
Result<void> askRobots(OpenPlatform& open, const std::string& whose, const Request& request) {
  const auto meant = robotsMeant(open, whose);
  if (!meant) return tl::unexpected(meant.error());
  for (const std::string& robot : *meant) {
    Request one = request;
    one.set_robot(robot);
    open.ask(std::move(one));
  }
  return {};
}

/// Returns completions for the name of a robot, of a team, or all.
std::vector<std::string> robotsOrAll(OpenPlatform& open) {
  std::vector<std::string> names = robotlink::robotAndTeamNames(open.session());
  names.emplace_back(kAll);
  return names;
}

Result<void> setKey(OpenPlatform& open, const Values& values) {
  const auto mode = robotlink::keyModeOf(text(values, 1));
  if (!mode) {
    return robotlink::failure("robot.key",
                              "a debug key's mode is off, always, 'n 3', 'every 3' or 'every-ms 40', not '" +
                                  text(values, 1) + "'");
  }
  Request request;
  request.mutable_set_key()->set_name(text(values, 0));
  *request.mutable_set_key()->mutable_mode() = *mode;
  return askRobots(open, text(values, 2), request);
}

Result<void> setShadow(OpenPlatform& open, const Values& values) {
  using robotcontrol::KeyMode;
  const std::string &task = text(values, 0), &solution = text(values, 1);
  const auto meant = robotsMeant(open, text(values, 3));
  if (!meant) return tl::unexpected(meant.error());
  const bool isUsed = std::ranges::all_of(*meant, [&](const std::string& robot) {
    return robotlink::activeSolution(open.session().store(), robot, task) == solution;
  });
  if (flag(values, 2) && isUsed)
    return robotlink::failure(
        "robot.shadow",
        solution + " is the solution that is used for " + task +
            "; name another one, or switch the task to another one (robot.solution) first",
        {}, {task, solution});
  Request request;
  request.mutable_set_key()->set_name(robotlink::shadowKey(task, solution));
  request.mutable_set_key()->mutable_mode()->set_kind(flag(values, 2) ? KeyMode::ALWAYS : KeyMode::OFF);
  return askRobots(open, text(values, 3), request);
}

/// Returns completions for the name of a task, then for one of its solutions.
std::vector<std::string> tasksOrSolutions(OpenPlatform& open, const std::vector<std::string>& before) {
  return before.empty() ? robotlink::taskNames(open.session())
                        : robotlink::solutionNames(open.session(), before.front());
}

Result<void> setPackage(OpenPlatform& open, const Values& values) {
  using robotcontrol::SetPackage;
  Request request;
  SetPackage& set = *request.mutable_set_package();
  set.set_package(text(values, 0));
  const std::string& mode = text(values, 1);
  set.set_mode(mode == "hold"      ? SetPackage::HOLD
               : mode == "release" ? SetPackage::RELEASE
                                   : SetPackage::ONCE);
  if (set.mode() != SetPackage::RELEASE) {
    auto value = robotlink::packageFromJson(set.package(), text(values, 2));
    if (!value) return tl::unexpected(value.error());
    *set.mutable_value() = std::move(*value);
  }
  return askRobots(open, text(values, 3), request);
}

/// Returns completions for the name of a package: those of the selected robot's program.
std::vector<std::string> packageNames(OpenPlatform& open) {
  const auto names = robotlink::programPackages(open.session().store(), open.session().selectedRobot(),
                                                robotlink::Instant::max());
  return {names.begin(), names.end()};
}

/// Asks for a change of where and how programs run. Without a name for the selected robot.
Result<void> host(OpenPlatform& open, const std::string& whose, const robotcontrol::HostProgram& choice) {
  Request request;
  *request.mutable_host_program() = choice;
  if (whose != kAll || open.session().robots().empty()) return askRobots(open, whose, request);
  open.ask(std::move(request));  // without a robot it is for all, which change together
  return {};
}

Result<void> chooseHost(OpenPlatform& open, const Values& values) {
  using robotcontrol::HostProgram;
  const std::string& where = text(values, 0);
  const std::string& whose = text(values, 1);
  HostProgram choice;
  if (where == "inside" || where == "own-process") {
    choice.set_where(where == "inside" ? HostProgram::IN_WORKBENCH : HostProgram::OWN_PROCESS);
    return host(open, whose, choice);
  }
  if (!whose.empty() && whose != kAll) {
    return robotlink::failure("robot.host", where + " is chosen for all robots together; leave out " + whose,
                              {}, {where, whose});
  }
  choice.set_executor(where == "threads" ? HostProgram::THREADS : HostProgram::LOCKSTEP);
  return host(open, kAll, choice);
}

Result<void> setColorTable(OpenPlatform& open, const std::string& file) {
  auto table = readColorTable(file);
  if (!table) return tl::unexpected(table.error());
  Request request;
  *request.mutable_set_color_table()->mutable_table() = std::move(**table);
  robotlink::assign(*request.mutable_set_color_table()->mutable_table()->mutable_loaded(),
                    robotlink::Instant(std::chrono::system_clock::now().time_since_epoch()));
  return askSelectedRobot(open, request);
}

void addForAll(CommandTable& commands, OpenPlatform& open) {
  commands.attach("robot.connect-now", [&open](const Values&) { return open.connectNow(); });
  commands.attach(
      "robot.select", [&open](const Values& values) { return select(open, text(values, 0)); },
      [&open](const auto&) { return open.session().robots(); });
  commands.attach("robot.stop", [&open](const Values& values) -> Result<void> {
    for (const std::string& robot : open.session().robots()) {
      Request request;
      request.set_robot(robot);
      request.mutable_stop()->set_engaged(flag(values, 0));
      open.session().request(request);
    }
    return {};
  });
}

void addForPackages(CommandTable& commands, OpenPlatform& open) {
  commands.attach(
      "robot.package", [&open](const Values& values) { return setPackage(open, values); },
      [&open](const auto& before) {
        if (before.size() > 2) return robotsOrAll(open);
        return before.empty() ? packageNames(open) : std::vector<std::string>();
      });
}

void addForProgram(CommandTable& commands, OpenPlatform& open) {
  commands.attach(
      "robot.key", [&open](const Values& values) { return setKey(open, values); },
      [&open](const auto& before) {
        if (before.size() > 1) return robotsOrAll(open);
        return before.empty() ? robotlink::keyNames(open.session())
                              : std::vector<std::string>{"off", "always", "n 1", "every 10", "every-ms 100"};
      });
  commands.attach(
      "robot.solution",
      [&open](const Values& values) {
        Request request;
        request.mutable_select_solution()->set_task(text(values, 0));
        request.mutable_select_solution()->set_solution(text(values, 1));
        return askRobots(open, text(values, 2), request);
      },
      [&open](const auto& before) {
        return before.size() > 1 ? robotsOrAll(open) : tasksOrSolutions(open, before);
      });
  commands.attach(
      "robot.shadow", [&open](const Values& values) { return setShadow(open, values); },
      [&open](const auto& before) {
        if (before.size() > 2) return robotsOrAll(open);
        return before.size() == 2 ? std::vector<std::string>() : tasksOrSolutions(open, before);
      });
  commands.attach(
      "robot.host", [&open](const Values& values) { return chooseHost(open, values); },
      [&open](const auto& before) {
        return before.size() == 1 ? robotsOrAll(open) : std::vector<std::string>();
      });
  commands.attach(
      "robot.start-again",
      [&open](const Values& values) {
        robotcontrol::HostProgram choice;
        choice.set_start_again(true);
        return host(open, text(values, 0), choice);
      },
      [&open](const auto& before) {
        return before.empty() ? robotsOrAll(open) : std::vector<std::string>();
      });
  commands.attach("robot.color-table",
                  [&open](const Values& values) { return setColorTable(open, text(values, 0)); });
  commands.attach("robot.no-color-table", [&open](const Values&) {
    Request request;
    request.mutable_set_color_table();
    return askSelectedRobot(open, request);
  });
}

std::vector<std::string> cameraSettings(OpenPlatform& open) {
  std::vector<std::string> names;
  const auto* settings = open.session().store().latestAs<robotcontrol::CameraSettings>(
      open.session().selectedRobot() + "/" + robotlink::kCameraSettings.name,
      open.session().timeline().shown());
  if (settings == nullptr) return names;
  for (const auto& setting : settings->settings()) names.push_back(setting.name());
  return names;
}

void addForCamera(CommandTable& commands, OpenPlatform& open) {
  commands.attach(
      "robot.camera",
      [&open](const Values& values) {
        Request request;
        request.mutable_set_camera()->set_setting(text(values, 0));
        request.mutable_set_camera()->set_value(number(values, 1));
        return askSelectedRobot(open, request);
      },
      [&open](const auto& before) {
        return before.empty() ? cameraSettings(open) : std::vector<std::string>();
      });
}

/// Writes the map made by the selected robot, as of the instant that the timeline shows; the home of the map
/// is where the robot was then. A map that the robot does not publish yet is requested.
Result<void> saveMap(OpenPlatform& open, const std::string& file) {
  const std::string& robot = open.session().selectedRobot();
  const auto& store = open.session().store();
  const robotlink::Instant shown = open.session().timeline().shown();
  const auto* grid = store.latestAs<foxglove::Grid>(robot + "/" + robotlink::kGridMap.name, shown);
  if (grid == nullptr) {
    Request show;
    show.mutable_set_key()->set_name(std::string("package/") + robotlink::kGridMap.name);
    show.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    if (auto asked = askSelectedRobot(open, show); !asked) return asked;
    return robotlink::failure(
        "robot.no-map",
        "there is no map of " + robot +
            " here yet; it has been requested now. Repeat the command in a moment, if the robot's program "
            "runs the task mapping, as in the layout pioneer-mapping",
        {}, {robot});
  }
  auto map = robotlink::groundMap(*grid);
  if (!map) return tl::unexpected(map.error());
  const auto* pose = store.latestAs<robotcontrol::RobotPose>(robot + "/" + robotlink::kRobotPose.name, shown);
  if (pose != nullptr) {
    robotlink::GroundMap::Place& home = map->places.emplace_back();
    home.kind = robotlink::GroundMap::Place::Kind::kHome;
    home.pose = robotlink::pose2(pose->robot_in_field());
    home.hasHeading = true;
  }
  return map->save(file);
}

void addForDrive(CommandTable& commands, OpenPlatform& open) {
  commands.attach("robot.goal", [&open](const Values& values) {
    Request request;
    request.mutable_set_goal()->mutable_pose_in_field()->set_x(number(values, 0));
    request.mutable_set_goal()->mutable_pose_in_field()->set_y(number(values, 1));
    request.mutable_set_goal()->set_any_heading(true);
    return askSelectedRobot(open, request);
  });
  commands.attach("robot.no-goal", [&open](const Values&) {
    Request request;
    request.mutable_set_goal()->set_cancelled(true);
    return askSelectedRobot(open, request);
  });
  const auto addSwitch = [&](const char* name, void (*set)(robotcontrol::ControlDrive&, bool)) {
    commands.attach(name, [&open, set](const Values& values) {
      Request request;
      set(*request.mutable_control_drive(), flag(values, 0));
      return askSelectedRobot(open, request);
    });
  };
  commands.attach("robot.save-map", [&open](const Values& values) { return saveMap(open, text(values, 0)); });
  addSwitch("robot.motors", [](auto& details, bool on) { details.set_motors(on); });
  addSwitch("robot.sonars", [](auto& details, bool on) { details.set_sonar(on); });
}

}  // namespace

Result<void> askSelectedRobot(OpenPlatform& open, const Request& request) {
  return askRobots(open, {}, request);
}

void addRobotCommands(CommandTable& commands, OpenPlatform& open) {
  addForAll(commands, open);
  addForProgram(commands, open);
  addForPackages(commands, open);
  addForCamera(commands, open);
  addForDrive(commands, open);
}

}  // namespace app
