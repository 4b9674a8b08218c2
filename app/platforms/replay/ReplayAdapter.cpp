// SPDX-License-Identifier: GPL-3.0-or-later
// The adapter of logs.
#include "app/core/platform/PlatformAdapter.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/replay/LogSearchJob.h"
#include "app/platforms/replay/ReplayFeed.h"
#include "app/platforms/replay/ReplayHeadless.h"
#include "logplayer/pictures/PictureFrames.h"
#include "logplayer/pictures/VideoFrames.h"

namespace app {
namespace {

robotlink::Result<PlatformOpening> openLogFiles(const PlatformChoices& choices) {
  ReplayOptions options;
  for (const std::string& file : choices.sources) options.logs.push_back({file});
  if (const std::string layout = textOf(choices.values, "layout"); !layout.empty())
    options.layout = layoutNamed(layout);
  options.hosting.ownProcesses = flagOf(choices.values, ownProcessField().name);
  return ReplayFeed::opening(std::move(options));
}

/// The last adapter: every source that no other one opens is a log, or is reported not to be one.
const PlatformRegistration kReplayRegistration{
    {.name = ReplayFeed::kAdapter,
     .sources = "logs, videos or folders of pictures to open on one timeline",
     .time = TimeKind::kLogged,
     .severalSources = true,
     .opens = [](const std::string&) { return true; },
     .order = 3,
     .open = openLogFiles,
     .command = "log.open",
     .commandHelp =
         "Opens a log, a video or a folder of pictures, paused at its first image; closes what was open",
     .perspective =
         [](const std::string& source) {
           return logplayer::isVideo(source) || logplayer::isPictureFolder(source) ? "Colour" : "Log";
         },
     .headless = headlessReplay,
     .commands = addLogSearch}};

}  // namespace
}  // namespace app
