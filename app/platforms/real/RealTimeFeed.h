// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/platform/PlatformFeed.h"
#include "app/core/platform/PublishGate.h"
#include "app/platforms/real/RealTimeProgram.h"

namespace app {

class HostingMemory;

/// The part that all platforms of one robot in real time have in common: publishes to a session what the
/// robot and its program send, and the state of the platform. Derived classes make the program, which passes
/// to the recorder what a log may contain. Session and recorder must outlive it.
class RealTimeFeed : public PlatformFeed {
 public:
  void begin() override;
  std::optional<robotlink::PacedThread::Clock::time_point> due() override { return due_; }
  void step() override;
  robotlink::Errors setLayout(const std::filesystem::path& file) override;
  LoadedPlatform describe() const override;
  void publishStatus() override;
  void setDemand(const Demand& demand) override;
  std::vector<std::string> end() override;
  bool hasEnded() const override { return !program_ || program_->hasEnded(); }
  std::shared_ptr<StopSwitch> stopSwitch() const override { return program_->stopSwitch(); }
  std::map<std::string, ProgramOverrides> overrides() const override;

 protected:
  using Clock = robotlink::PacedThread::Clock;

  /// `adapter` is the name of the PlatformAdapter, `period` the real time between two steps. `hosting`
  /// remembers what the user chooses; it may be null, otherwise it must outlive the feed.
  RealTimeFeed(robotlink::Session& session, logplayer::Recorder& recorder, HostingMemory* hosting,
               std::string adapter, std::chrono::milliseconds period);
  /// Executes one step of the program.
  virtual void stepProgram() { program_->step(); }
  /// Passes all requests for the robot on, whatever the program does.
  robotlink::Result<void> requestRobot(const robotcontrol::Request& request) override;
  /// Fulfills requests about where the program runs; the others are refused.
  robotlink::Result<void> requestSimulation(const robotcontrol::Request& request) override;

  /// Publishes to the session from begin() on.
  PublishGate gate_;
  logplayer::Recorder& recorder_;
  /// The robot's address, as users see it.
  std::string url_;
  /// Null before it is made, and after it has ended.
  std::unique_ptr<RealTimeProgram> program_;

 private:
  HostingMemory* const hosting_;
  const std::string adapter_;
  const std::chrono::milliseconds period_;
  /// Whether the published messages have readers.
  bool isRead_ = true;
  /// The time at which the next step is due, and that of the last publication of the status.
  Clock::time_point due_, lastStatus_;
};

}  // namespace app
