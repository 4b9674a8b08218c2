// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "app/core/platform/PlatformFeed.h"
#include "app/core/platform/PublishGate.h"
#include "app/core/real/RealRun.h"

namespace app {

class HostingMemory;

/// A RealRun in the workbench: a platform in real time, stepped every 10 ms, that publishes to a session
/// what the robot and its program send. The run itself passes to the recorder what a log may contain. Session
/// and recorder must outlive it.
class RealFeed final : public PlatformFeed {
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

  void begin() override;
  std::optional<PacedThread::Clock::time_point> due() override { return due_; }
  void step() override;
  robotlink::Errors setLayout(const std::filesystem::path& file) override;
  LoadedPlatform describe() const override;
  void publishStatus() override;
  void setDemand(const Demand& demand) override;
  std::vector<std::string> end() override;
  bool hasEnded() const override { return !run_ || run_->hasEnded(); }
  std::shared_ptr<StopSwitch> stopSwitch() const override { return run_->stopSwitch(); }
  std::map<std::string, ProgramOverrides> overrides() const override;
  void connectNow() override { run_->connectNow(); }

 protected:
  /// STOP and requests for the base go to the platform, whatever the program does.
  robotlink::Result<void> requestRobot(const robotcontrol::Request& request) override;
  /// Only where the program runs counts here.
  robotlink::Result<void> requestSimulation(const robotcontrol::Request& request) override;

 private:
  using Clock = PacedThread::Clock;

  RealFeed(robotlink::Session& session, logplayer::Recorder& recorder)
      : gate_(session), recorder_(recorder) {}
  /// Publishes the overrides that the present program cannot fulfill as warnings, where describe() is not
  /// asked.
  void publishLostOverrides();

  /// Publishes to the session from begin() on.
  PublishGate gate_;
  /// Whether somebody reads that.
  bool isRead_ = true;
  logplayer::Recorder& recorder_;
  std::unique_ptr<RealRun> run_;
  HostingMemory* hosting_ = nullptr;
  /// When the next step is due, and when the status was last published.
  Clock::time_point due_, lastStatus_;
};

}  // namespace app
