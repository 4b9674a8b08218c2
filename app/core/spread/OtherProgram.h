// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "app/core/program/HostedRobot.h"
#include "app/core/spread/SpreadNetwork.h"
#include "robotlink/dds/FollowedClock.h"
#include "robotlink/dds/ProgramNet.h"
#include "robotlink/dds/ProgramPresence.h"
#include "robotlink/process/ThreadExecutor.h"

namespace robotlink {
class Platform;
class RobotProgram;
}  // namespace robotlink

namespace app {

/// One of the programs that run the processes of a robot's layout, but not the one with the debug process and
/// the platform: each of its processes runs in a thread, by the clock of that program. It goes on whatever
/// the others do; what they send is missing while they do not run.
class OtherProgram {
 public:
  /// What it is made of. A plain value.
  struct Parts {
    HostedRobot robot;
    robotlink::Layout layout;
    SpreadOptions options;
    /// Makes a platform like that of the other program, which is never used: it only says which packages
    /// there are.
    std::function<std::unique_ptr<robotlink::Platform>(const robotlink::Clock& clock)> platform;
    /// Called with sentences for the user, from any thread.
    std::function<void(const std::string& text)> report;
  };

  /// Fails with all reasons why it cannot run. It ends when it is destroyed.
  static tl::expected<std::unique_ptr<OtherProgram>, robotlink::Errors> create(Parts parts);
  ~OtherProgram();

  /// To be called again and again: starts the processes when the program with the platform is heard for the
  /// first time, since there is no time before. Returns whether they were started.
  bool begin();
  /// Runs it until `seconds` of real time have passed (0: for ever) or `interrupted` says so. Returns whether
  /// the program with the platform was heard.
  bool run(double seconds, const std::function<bool()>& interrupted);

 private:
  explicit OtherProgram(Parts parts);
  robotlink::Errors make();

  Parts parts_;
  robotlink::dds::FollowedClock clock_;
  std::shared_ptr<robotlink::dds::Node> node_;
  std::unique_ptr<robotlink::dds::ProgramPresence> presence_;
  std::unique_ptr<robotlink::dds::ProgramNet> net_;
  std::unique_ptr<robotlink::dds::LifeSign> life_;
  std::unique_ptr<robotlink::Platform> platform_;
  std::unique_ptr<robotlink::RobotProgram> program_;
  std::unique_ptr<robotlink::ThreadExecutor> executor_;
  bool begun_ = false;
};

}  // namespace app
