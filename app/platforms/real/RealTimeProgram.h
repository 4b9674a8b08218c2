// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/core/own/OwnProgram.h"
#include "app/core/platform/HostingChoices.h"
#include "app/core/platform/StopSwitch.h"
#include "app/core/program/LeftOverPrograms.h"
#include "app/core/program/RobotHost.h"
#include "app/core/spread/SpreadOptions.h"
#include "app/core/team/TeamLink.h"

namespace logplayer {
class Recorder;
}
namespace robotcontrol {
class HostProgram;
class Request;
}  // namespace robotcontrol

namespace app {

class RecordingTap;
class SpreadProgram;

/// The program of a robot that is not simulated, and where it runs. A plain value.
struct RealTimeOptions {
  /// The file of the process layout; empty: that of the kind of robot.
  std::filesystem::path layout = {};
  /// The file of the map by which it drives; empty if it has none.
  std::filesystem::path map = {};
  /// Maps tasks to the solutions at the start, instead of the layout's.
  std::map<std::string, std::string> solutions = {};
  /// A preset with which the program additionally starts; null: none.
  std::shared_ptr<const robotlink::Preset> preset = nullptr;
  /// Whether the program runs in a process of the operating system of its own.
  HostingChoices hosting = {};
  /// The options of running it there; always with threads, in real time.
  OwnProgram::Options own = {};
  /// Makes what runs instead of a program, such as a link to a remote one; empty: a program.
  HostedProgram::Maker instead = {};
  /// The program of the layout that this one is, if other programs run the other processes.
  SpreadOptions spread = {};
  /// The link by which it hears its team.
  TeamLinkOptions team = {};
  /// Gets sentences about the other programs, from any thread; empty: they go to the listener of the
  /// platform.
  std::function<void(const std::string& text)> spreadReport = {};
  /// The user's choices for this robot when it was connected before.
  ProgramOverrides overrides = {};
};

/// The program of a robot in real time, and its platform: each process has a thread of its own, in this
/// process of the operating system, in another one, or in several programs. The owner steps it about a
/// hundred times a second. One thread at a time; listeners are called in the threads of the processes.
class RealTimeProgram {
 public:
  using Listeners = RobotHost::Listeners;

  /// `clock` is the platform's. The recorder gets everything that a log may contain and must outlive the
  /// program; null: nothing is recorded.
  RealTimeProgram(RealTimeOptions options, HostedRobot robot, std::unique_ptr<const robotlink::Clock> clock,
                  Listeners listeners, logplayer::Recorder* recorder);
  RealTimeProgram(const RealTimeProgram&) = delete;
  RealTimeProgram& operator=(const RealTimeProgram&) = delete;
  /// Ends the program and the platform. Waits for modules that do not return, unless end() was called and
  /// hasEnded() is true.
  virtual ~RealTimeProgram();

  /// Says whether the layout has the tasks and solutions of the options, before a platform is made.
  robotlink::Errors checkSolutions() const;
  /// Starts the program on its platform; call this once, before all of the following.
  robotlink::Errors start(std::unique_ptr<robotlink::Platform> platform);
  /// Ends the program and shuts the platform down. Nothing else but hasEnded() may be called then.
  void end();
  /// Whether all modules of programs that were ended have returned. Any thread, after end().
  bool hasEnded() const { return leftOver_.haveEnded(); }

  /// Executes one step of the platform: requests, commands, sensor data.
  void step();
  /// Restarts the program in another layout while the platform continues. If that is impossible, the program
  /// that runs continues. The user's overrides are kept as far as the layout permits.
  robotlink::Errors setLayout(const std::filesystem::path& file);
  /// Chooses where the program runs, and starts or restarts it there; the platform continues. `robot` is the
  /// one that the user named, empty for all. If that is impossible, the program that runs continues.
  robotlink::Errors hostProgram(const std::string& robot, const robotcontrol::HostProgram& choice);
  /// Enqueues a request for the program, or has the platform fulfill it (STOP, motors, sonars). Fails if it
  /// is for another robot or is refused.
  robotlink::Result<void> request(const robotcontrol::Request& request);

  /// Stops the robot from any thread; not null.
  std::shared_ptr<StopSwitch> stopSwitch() const { return stopSwitch_; }
  bool stopEngaged() const { return host_.platform()->stopEngaged(); }
  const std::string& name() const { return host_.name(); }
  const HostedRobot& robot() const { return host_.robot(); }
  /// Null if the robot has no map.
  std::shared_ptr<const robotlink::GroundMap> map() const { return robot().map; }
  const robotlink::Clock& clock() const { return *clock_; }
  /// The file of the layout in which the program runs.
  std::filesystem::path layout() const;
  const HostingChoices& hosting() const { return options_.hosting; }
  /// Whether only the robot's body is here, whose program runs remotely.
  bool isBody() const { return options_.instead != nullptr; }
  ProgramOverrides overrides() const { return host_.overrides(); }
  /// The overrides that the present program cannot fulfill, as a sentence each.
  const std::vector<std::string>& lostChoices() const { return lostChoices_; }

 private:
  /// Makes a program in a layout; `platform` is null if that of the robot stays.
  tl::expected<RobotHost::Candidate, robotlink::Errors> makeProgram(
      std::unique_ptr<robotlink::Platform> platform, const std::filesystem::path& file);
  /// Makes what the program is made by; empty: it is one inside.
  tl::expected<HostedProgram::Maker, robotlink::Errors> maker(const robotlink::Layout& layout);
  /// Makes a program in a layout, and replaces the present one by it.
  robotlink::Errors replace(const std::filesystem::path& file);
  /// Connects the platform with the robot's team, if that was chosen.
  robotlink::Result<void> joinTeam(robotlink::Platform& platform);
  /// Adopts a program and starts its threads.
  void adopt(RobotHost::Candidate program);
  /// Ends the threads and the program.
  void stop();
  /// Passes a sentence about the other programs to the listener; any thread.
  void reportSpread(const std::string& text) const;

  RealTimeOptions options_;
  const Listeners listeners_;
  const std::unique_ptr<const robotlink::Clock> clock_;
  /// Null if nothing is recorded.
  std::unique_ptr<RecordingTap> tap_;
  /// Null if all processes run in this program.
  std::unique_ptr<SpreadProgram> spread_;
  /// Null if it hears no team. Before the host, whose platform has its ends.
  std::unique_ptr<TeamLink> team_;
  RobotHost host_;
  std::vector<std::string> lostChoices_;
  std::shared_ptr<StopSwitch> stopSwitch_;
  LeftOverPrograms leftOver_;
  std::unique_ptr<ProgramExecutor> executor_;
};

}  // namespace app
