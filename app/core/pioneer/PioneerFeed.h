// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "app/core/pioneer/PioneerRun.h"
#include "app/core/program/PlatformFeed.h"
#include "app/core/program/PublishGate.h"

namespace app {

/// A PioneerRun in the workbench: tells a session what the robot and its program say, and a recorder. Both
/// must outlive it.
class PioneerFeed final : public PlatformFeed {
 public:
  static constexpr const char* kAdapter = "pioneer";

  static PlatformOpening opening(PioneerOptions options);
  static tl::expected<std::unique_ptr<PioneerFeed>, robotlink::Errors> create(PioneerOptions options,
                                                                              robotlink::Session& session,
                                                                              logplayer::Recorder& recorder);

  void begin() override;
  std::optional<PacedThread::Clock::time_point> due() override { return due_; }
  void step() override;
  robotlink::Errors setLayout(const std::filesystem::path& file) override;
  LoadedPlatform describe() const override;
  void publishStatus() override;
  std::shared_ptr<StopSwitch> stopSwitch() const override { return run_->stopSwitch(); }
  /// A robot has one client, and the other platform may want the same one.
  bool makeWay() override { return false; }
  std::map<std::string, ProgramOverrides> overrides() const override;
  void connectNow() override { run_->connectNow(); }

 protected:
  /// STOP acts whatever the program does.
  robotlink::Result<void> requestRobot(const robotcontrol::Request& request) override;

 private:
  using Clock = PacedThread::Clock;

  PioneerFeed(robotlink::Session& session, logplayer::Recorder& recorder)
      : outlet_(session), recorder_(recorder) {}
  PioneerRun::Listeners listeners();

  PublishGate outlet_;
  logplayer::Recorder& recorder_;
  std::unique_ptr<PioneerRun> run_;
  Clock::time_point due_, lastStatus_;
};

}  // namespace app
