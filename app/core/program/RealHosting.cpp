// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/RealHosting.h"

#include "robotcontrol/Hosting.pb.h"

namespace app {

robotlink::Errors refusalOfHosting(const std::string& robot, const std::string& asked,
                                   const robotcontrol::HostProgram& choice, bool isSpread) {
  if (!asked.empty() && asked != robot)
    return {{"request.no-robot", "there is no robot " + asked, {asked}, {}}};
  if (isSpread)
    return {{"spread.hosting",
             "the processes of " + robot +
                 " are spread over several programs already; end this program, and start it again",
             {robot},
             {}}};
  if (choice.executor() == robotcontrol::HostProgram::LOCKSTEP)
    return {{"program.real-time",
             "a real robot does not wait for its program: its processes have a thread each",
             {robot},
             {}}};
  return {};
}

}  // namespace app
