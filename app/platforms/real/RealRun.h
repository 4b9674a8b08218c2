// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/platforms/real/RealPlatform.h"
#include "app/platforms/real/RealTimeProgram.h"

namespace app {

/// A real robot and the program that runs for it here. A plain value.
struct RealRobotOptions {
  using Platform = robotlink::Result<std::unique_ptr<RealPlatform>>;

  /// The name of its PlatformAdapter.
  std::string adapter;
  /// The address: "tcp://localhost:8101", "camera:///dev/video0". The same robot always has the same address.
  std::string url;
  /// The robot's name in the workbench.
  std::string robot;
  /// The kind of robot, whose description is resources/robots/<kind>.yaml.
  std::string kind;
  /// Makes its platform. Fails if the address is invalid; whether the robot can be reached does not matter.
  std::function<Platform(const robotlink::Clock& clock, const std::string& robot,
                         const robotlink::RobotDescription& description)>
      platform;
  RealTimeOptions program = {};
};

/// Reads the description, the field and the map of a real robot.
tl::expected<HostedRobot, robotlink::Errors> hostedRobot(const RealRobotOptions& options);

/// A real robot together with its program, which runs here in real time. It is made as a whole or refused
/// with all reasons. A robot that does not answer is no such reason: its platform tries to connect again and
/// again.
class RealRun final : public RealTimeProgram {
 public:
  /// The recorder gets everything that a log may contain and must outlive the run; null: nothing is recorded.
  static tl::expected<std::unique_ptr<RealRun>, robotlink::Errors> create(
      RealRobotOptions options, Listeners listeners, logplayer::Recorder* recorder = nullptr);

  /// Retries a lost connection at once; the program continues.
  void connectNow() { platform_->connectNow(); }
  const RealPlatform& platform() const { return *platform_; }
  /// The name of its PlatformAdapter.
  const std::string& adapter() const { return adapter_; }
  const std::string& url() const { return url_; }

 private:
  RealRun(const RealRobotOptions& options, HostedRobot robot, Listeners listeners,
          logplayer::Recorder* recorder);

  const std::string adapter_, url_;
  /// Owned by the program's host.
  RealPlatform* platform_ = nullptr;
};

}  // namespace app
