// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/PlatformFeed.h"

#include "robotlink/debugging/RequestKinds.h"

namespace app {

using robotlink::RequestDoer;
using robotlink::Result;

Result<PlatformFeed::Answer> PlatformFeed::fulfil(const robotcontrol::Request& request) {
  const RequestDoer doer = robotlink::kindOf(request).doer;
  const bool ofProgram = doer == RequestDoer::kTask || doer == RequestDoer::kDebugProcess;
  if (const std::string wrong = robotlink::wrongWith(request); !ofProgram && !wrong.empty())
    return robotlink::failure("request.wrong", wrong);
  const Result<void> done = doer == RequestDoer::kSimulation ? requestSimulation(request)
                            : doer == RequestDoer::kReplay   ? requestReplay(request)
                                                             : requestRobot(request);
  if (!done) return tl::unexpected(done.error());
  return ofProgram ? Answer::kByProgram : Answer::kHere;
}

Result<void> PlatformFeed::requestSimulation(const robotcontrol::Request&) {
  return robotlink::failure("simulation.none", "nothing is simulated; open a scene first");
}

Result<void> PlatformFeed::requestReplay(const robotcontrol::Request&) {
  return robotlink::failure("replay.none", "no log is open; open one first");
}

PlatformOpening::Made PlatformFeed::withLog(const std::filesystem::path&, robotlink::Duration,
                                            const logplayer::LogFile::Progress&) const {
  return tl::unexpected(robotlink::Errors{{"replay.none", "no log is open to add this one to", {}, {}}});
}

}  // namespace app
