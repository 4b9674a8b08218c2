// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/real/RealFeed.h"

#include "app/core/platform/HostingMemory.h"
#include "app/core/platform/RobotPublishing.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kStep{10};

}  // namespace

PlatformOpening RealFeed::opening(RealRobotOptions options) {
  return {options.adapter, {options.url}, [options](const PlatformContext& context) -> PlatformOpening::Made {
            RealRobotOptions chosen = options;
            const auto before = context.overrides.find(chosen.robot);
            if (before != context.overrides.end()) chosen.program.overrides = before->second;
            chosen.program.hosting =
                hostingAtOpening(chosen.program.hosting, context.hosting, chosen.adapter);
            return create(std::move(chosen), context.session, context.recorder, context.hosting);
          }};
}

tl::expected<std::unique_ptr<RealFeed>, robotlink::Errors> RealFeed::create(RealRobotOptions options,
                                                                            robotlink::Session& session,
                                                                            logplayer::Recorder& recorder,
                                                                            HostingMemory* hosting) {
  auto feed = std::unique_ptr<RealFeed>(new RealFeed(session, recorder, hosting, options.adapter, kStep));
  feed->url_ = options.url;
  auto run = RealRun::create(std::move(options), listenersOf(feed->gate_), &recorder);
  if (!run) return tl::unexpected(std::move(run.error()));
  feed->run_ = run->get();
  feed->program_ = std::move(*run);
  return feed;
}

LoadedPlatform RealFeed::describe() const {
  LoadedPlatform loaded = RealTimeFeed::describe();
  if (!program_->robot().fieldFile.empty()) loaded.field = program_->robot().field;
  return loaded;
}

}  // namespace app
