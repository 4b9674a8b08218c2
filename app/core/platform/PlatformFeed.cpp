// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/PlatformFeed.h"

#include "robotlink/debugging/RequestKinds.h"

namespace app {

using robotlink::RequestDoer;
using robotlink::Result;

namespace {

robotlink::Errors noSimulation() {
  return {{"simulation.none", "there is no simulation; open a scene first", {}, {}}};
}

/// Returns why a request that concerns a robot cannot be passed to it; empty if it can.
std::string whyForNoRobot(const robotcontrol::Request& request, RequestDoer doer) {
  if (doer == RequestDoer::kRecording)
    return "only the workbench records on this request; a robot's program that was started with --recordings "
           "has the services recordings/start and recordings/stop";
  return request.robot().empty() ? robotlink::inWords(request) + ": no robot is named" : "";
}

}  // namespace

Result<PlatformFeed::Answer> PlatformFeed::fulfill(const robotcontrol::Request& request) {
  const RequestDoer doer = robotlink::kindOf(request).doer;
  const bool ofProgram = doer == RequestDoer::kTask || doer == RequestDoer::kDebugProcess;
  if (const std::string wrong = robotlink::wrongWith(request); !ofProgram && !wrong.empty())
    return robotlink::failure("request.wrong", wrong);
  const bool ofRobot = doer != RequestDoer::kSimulation && doer != RequestDoer::kReplay;
  if (const std::string why = whyForNoRobot(request, doer); ofRobot && !why.empty())
    return robotlink::failure("request.no-robot", why);
  const Result<void> done = ofRobot                            ? requestRobot(request)
                            : doer == RequestDoer::kSimulation ? requestSimulation(request)
                                                               : requestReplay(request);
  if (!done) return tl::unexpected(done.error());
  return ofProgram ? Answer::kByProgram : Answer::kHere;
}

Result<void> PlatformFeed::requestSimulation(const robotcontrol::Request&) {
  return robotlink::failure("simulation.none", "nothing is simulated; open a scene first");
}

Result<void> PlatformFeed::requestReplay(const robotcontrol::Request&) {
  return robotlink::failure("replay.none", "no log is open; open one first");
}

robotlink::Errors PlatformFeed::setLayoutOf(const std::string& name, const std::filesystem::path& file) {
  (void)file;
  return {{"layout.robot",
           "only robots of a simulation can have individual layouts; without a name, " + name +
               " gets the layout of all",
           {name},
           {}}};
}

tl::expected<bool, robotlink::Errors> PlatformFeed::reload(FileTexts, bool) {
  return tl::unexpected(noSimulation());
}

PlatformOpening PlatformFeed::reopening(FileTexts) const {
  const LoadedPlatform loaded = describe();
  return {.adapter = loaded.adapter, .sources = loaded.sources, .make = [](const PlatformContext&) {
            return PlatformOpening::Made(tl::unexpected(noSimulation()));
          }};
}

PlatformOpening::Made PlatformFeed::withLog(const std::filesystem::path&, robotlink::Duration,
                                            const logplayer::LogFile::Progress&) const {
  return tl::unexpected(robotlink::Errors{{"replay.none", "no log is open to add this one to", {}, {}}});
}

}  // namespace app
