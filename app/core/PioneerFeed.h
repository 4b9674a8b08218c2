// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/core/Outlet.h"
#include "app/core/PioneerRun.h"
#include "app/core/PlatformFeed.h"

namespace app {

/// A PioneerRun in the workbench: tells a session what the robot and its program say, and a recorder. Both
/// must outlive it.
class PioneerFeed final : public PlatformFeed {
 public:
  static tl::expected<std::unique_ptr<PioneerFeed>, robotlink::Errors> create(PioneerOptions options,
                                                                              robotlink::Session& session,
                                                                              logplayer::Recorder& recorder);

  void begin() override;
  std::optional<PacedThread::Clock::time_point> due() override { return due_; }
  void step() override;
  /// STOP acts whatever the program does.
  robotlink::Result<Answer> fulfil(const robotcontrol::Request& request) override;
  robotlink::Errors setLayout(const std::filesystem::path& file) override;
  LoadedPlatform describe() const override;
  void publishStatus() override;
  std::shared_ptr<StopSwitch> stopSwitch() const override { return run_->stopSwitch(); }
  void connectNow() { run_->connectNow(); }

 private:
  using Clock = PacedThread::Clock;

  PioneerFeed(robotlink::Session& session, logplayer::Recorder& recorder)
      : outlet_(session), recorder_(recorder) {}
  PioneerRun::Listeners listeners();

  Outlet outlet_;
  logplayer::Recorder& recorder_;
  std::unique_ptr<PioneerRun> run_;
  Clock::time_point due_, lastStatus_;
};

}  // namespace app
