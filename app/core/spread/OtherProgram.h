// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "app/core/program/HostedRobot.h"
#include "app/core/program/LeftOverPrograms.h"
#include "app/core/spread/SpreadNetwork.h"
#include "robotlink/dds/FollowedClock.h"
#include "robotlink/dds/ProgramNet.h"
#include "robotlink/dds/ProgramPresence.h"
#include "robotlink/process/ThreadExecutor.h"

namespace robotlink {
class Platform;
class Process;
class RobotProgram;
}  // namespace robotlink

namespace app {

/// A program that runs processes of a robot's layout, but not the one with the debug process and
/// the platform: each of its processes runs in a thread, by the clock of that program. It continues whatever
/// the others do; what they send is missing while they do not run. A module that does not return is named
/// here, and in the program with the platform, whose robot stands still meanwhile.
class OtherProgram {
 public:
  /// The parts of which it is made. A plain value.
  struct Parts {
    HostedRobot robot;
    robotlink::Layout layout;
    SpreadOptions options;
    /// Makes a platform like that of the other program, which is never used: it only says which packages
    /// there are.
    std::function<std::unique_ptr<robotlink::Platform>(const robotlink::Clock& clock)> platform;
    /// Called with sentences for the user, from any thread.
    std::function<void(const std::string& text)> report;
    /// The time that a frame may last before it counts as not returning.
    std::chrono::milliseconds patience = kModulePatience;
  };

  /// Fails with all reasons why it cannot run. It ends when it is destroyed.
  static tl::expected<std::unique_ptr<OtherProgram>, robotlink::Errors> create(Parts parts);
  ~OtherProgram();

  /// Call this repeatedly: starts the processes when the first message of the program with the platform
  /// arrives, since there is no time before, and checks whether their modules return. Returns whether they
  /// were started.
  bool look();
  /// Runs it until `seconds` of real time have passed (0: forever) or `interrupted` says so. Returns whether
  /// the program with the platform was found.
  bool run(double seconds, const std::function<bool()>& interrupted);

 private:
  /// The objects that exist as long as a module does not return.
  struct Running {
    robotlink::dds::FollowedClock clock;
    std::shared_ptr<robotlink::dds::Node> node;
    std::unique_ptr<robotlink::dds::ProgramPresence> presence;
    std::unique_ptr<robotlink::dds::ProgramNet> net;
    std::unique_ptr<robotlink::dds::LifeSign> life;
    std::unique_ptr<robotlink::Platform> platform;
    std::unique_ptr<robotlink::RobotProgram> program;
    std::unique_ptr<robotlink::ThreadExecutor> executor;
    Running();
    ~Running();
  };
  explicit OtherProgram(Parts parts);
  robotlink::Errors join();
  robotlink::Errors make();
  void lookForStuck();

  Parts parts_;
  std::shared_ptr<Running> running_;
  bool begun_ = false;
  std::set<const robotlink::Process*> stuck_;
};

}  // namespace app
