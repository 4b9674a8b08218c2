// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/RobotPublishing.h"

#include "app/core/platform/PublishGate.h"

namespace app {

RobotHost::Listeners listenersOf(PublishGate& gate) {
  return {
      .queue = [&gate](const std::string& robot, auto queue) { gate.publishQueue(robot, std::move(queue)); },
      .trouble = [&gate](const std::string& robot, const robotlink::Process& process,
                         const std::string& text) { gate.publishTrouble(robot, process, text); },
      .platform = [&gate](const std::string& robot, robotlink::Instant time,
                          const std::string& text) { gate.publishPlatform(robot, time, text); },
      .overridden = {},
      .hosting = [&gate](
                     const std::string& robot, robotlink::Instant time,
                     const robotcontrol::HostingStatus& status) { gate.publishHosting(robot, time, status); },
      .problem = [&gate](const std::string& robot, robotlink::Instant time,
                         const std::string& text) { gate.publishPlatformProblem(robot, time, text); }};
}

}  // namespace app
