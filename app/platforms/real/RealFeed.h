// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/platforms/real/RealRun.h"
#include "app/platforms/real/RealTimeFeed.h"

namespace app {

/// A RealRun in the workbench, stepped every 10 ms.
class RealFeed final : public RealTimeFeed {
 public:
  /// Returns the opening of a robot for PlatformThread. The robot's overrides are those of the last time it
  /// was open.
  static PlatformOpening opening(RealRobotOptions options);
  /// Makes the run. Fails if the program cannot be run; whether the robot can be reached does not matter.
  /// `hosting` remembers what the user chooses; it may be null, otherwise it must outlive the feed.
  static tl::expected<std::unique_ptr<RealFeed>, robotlink::Errors> create(RealRobotOptions options,
                                                                           robotlink::Session& session,
                                                                           logplayer::Recorder& recorder,
                                                                           HostingMemory* hosting = nullptr);

  LoadedPlatform describe() const override;
  void connectNow() override { run_->connectNow(); }

 private:
  using RealTimeFeed::RealTimeFeed;

  /// The program.
  RealRun* run_ = nullptr;
};

}  // namespace app
