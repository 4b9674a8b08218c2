// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/real/RealRun.h"

#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RobotFiles.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/RobotUse.h"

namespace app {

using robotlink::Errors;

tl::expected<HostedRobot, Errors> hostedRobot(const RealRobotOptions& options) {
  auto description = readRobot(options.kind);
  if (!description) return tl::unexpected(description.error());
  const auto use = readUse(options.kind);
  if (!use) return tl::unexpected(use.error());
  const std::filesystem::path fieldOfKind = fieldFile(use->field);
  auto field = readField(fieldOfKind);
  if (!field) return tl::unexpected(field.error());
  const std::string& team = options.program.team.team;
  HostedRobot robot{options.robot, team.empty() ? use->teamOf(options.robot) : team,
                    *description,  *field,
                    nullptr,       fieldOfKind};
  if (options.program.map.empty()) return robot;
  auto map = robotlink::GroundMap::load(options.program.map);
  if (!map) return tl::unexpected(map.error());
  robot.map = std::make_shared<const robotlink::GroundMap>(std::move(*map));
  return robot;
}

RealRun::RealRun(const RealRobotOptions& options, HostedRobot robot, Listeners listeners,
                 logplayer::Recorder* recorder)
    : RealTimeProgram(options.program, std::move(robot), std::make_unique<robotlink::SteadyClock>(),
                      std::move(listeners), recorder),
      adapter_(options.adapter),
      url_(options.url) {}

tl::expected<std::unique_ptr<RealRun>, Errors> RealRun::create(RealRobotOptions options, Listeners listeners,
                                                               logplayer::Recorder* recorder) {
  auto robot = hostedRobot(options);
  if (!robot) return tl::unexpected(robot.error());
  auto run =
      std::unique_ptr<RealRun>(new RealRun(options, std::move(*robot), std::move(listeners), recorder));
  if (Errors errors = run->checkSolutions(); !errors.empty()) return tl::unexpected(std::move(errors));
  auto platform = options.platform(run->clock(), run->name(), *run->robot().description);
  if (!platform) return tl::unexpected(Errors{platform.error()});
  run->platform_ = platform->get();
  if (Errors errors = run->start(std::move(*platform)); !errors.empty())
    return tl::unexpected(std::move(errors));
  return run;
}

}  // namespace app
