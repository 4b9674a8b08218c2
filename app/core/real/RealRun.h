// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "app/core/own/OwnProgram.h"
#include "app/core/platform/HostingChoices.h"
#include "app/core/platform/StopSwitch.h"
#include "app/core/program/LeftOverPrograms.h"
#include "app/core/program/RobotHost.h"
#include "app/core/real/RealPlatform.h"
#include "app/core/spread/SpreadOptions.h"

namespace logplayer {
class Recorder;
}
namespace robotcontrol {
class HostProgram;
class Request;
}  // namespace robotcontrol
namespace robotlink {
class RobotProgram;
struct FieldDescription;
struct GroundMap;
}  // namespace robotlink

namespace app {

class RecordingTap;
class SpreadProgram;

/// A real robot and the program that runs for it here. A plain value.
struct RealRobotOptions {
  using Platform = robotlink::Result<std::unique_ptr<RealPlatform>>;

  /// The name of its PlatformAdapter.
  std::string adapter;
  /// Where it is: "tcp://localhost:8101", "camera:///dev/video0". The same robot always has the same address.
  std::string url;
  /// The robot's name in the workbench.
  std::string robot;
  /// The kind of robot, whose description is resources/robots/<kind>.yaml.
  std::string kind;
  /// Makes its platform. Fails if the address is none; whether the robot can be reached does not matter.
  std::function<Platform(const robotlink::Clock& clock, const std::string& robot,
                         const robotlink::RobotDescription& description)>
      platform;
  /// The file of the process layout; empty: that of its kind.
  std::filesystem::path layout = {};
  /// The file of the map by which it drives; empty if it knows none.
  std::filesystem::path map = {};
  /// Maps tasks to the solutions at the start, instead of the layout's.
  std::map<std::string, std::string> solutions = {};
  /// Whether the program runs in a process of the operating system of its own.
  HostingChoices hosting = {};
  /// How it is run there; always with threads, in real time.
  OwnProgram::Options own = {};
  /// Makes what runs instead of a program, such as a link to one elsewhere; empty: a program.
  HostedProgram::Maker instead = {};
  /// Which of the layout's programs it is, if other programs run the other processes.
  SpreadOptions spread = {};
  /// Gets sentences about the other programs, from any thread; empty: they go to the listener of the
  /// platform.
  std::function<void(const std::string& text)> spreadReport = {};
  /// What the user chose for this robot when it was connected before.
  ProgramOverrides overrides = {};
};

/// Reads the description, the field and the map of a real robot.
tl::expected<HostedRobot, robotlink::Errors> hostedRobot(const RealRobotOptions& options);

/// A real robot together with its program, which runs here in real time: each process in a thread of its own,
/// in this process of the operating system or in another one.
///
/// The caller steps it about a hundred times per second. It is made as a whole or refused with all reasons. A
/// robot that does not answer is no such reason: its platform tries to connect again and again. One thread at
/// a time; listeners are called in the threads of the processes.
class RealRun {
 public:
  using Listeners = RobotHost::Listeners;

  /// The recorder gets everything that a log may contain and must outlive the run; null: nothing is recorded.
  static tl::expected<std::unique_ptr<RealRun>, robotlink::Errors> create(
      RealRobotOptions options, Listeners listeners, logplayer::Recorder* recorder = nullptr);
  /// Ends the program and the connection. Waits for modules that do not return, unless end() was called and
  /// hasEnded() is true.
  ~RealRun();
  /// Ends the program and the connection. Nothing else but hasEnded() may be called then.
  void end();
  /// Whether all modules of programs that were ended have returned. Any thread, after end().
  bool hasEnded() const;

  /// One step of the platform: requests, commands, sensor data.
  void step();
  /// Restarts the program in another layout while the robot stays connected. If that is impossible, the
  /// program that runs continues. The user's overrides are kept as far as the layout permits.
  robotlink::Errors setLayout(const std::filesystem::path& file);
  /// Chooses where the program runs, and starts it there or anew; the robot stays connected. If that is
  /// impossible, the program that runs continues.
  robotlink::Errors hostProgram(const std::string& robot, const robotcontrol::HostProgram& choice);
  /// The overrides that the present program cannot fulfill, as a sentence each.
  const std::vector<std::string>& lostChoices() const { return lostChoices_; }
  /// Enqueues a request for the program, or has the platform fulfill it (STOP, motors, sonars). Fails if it
  /// is for another robot or is refused.
  robotlink::Result<void> request(const robotcontrol::Request& request);
  /// Retries a lost connection at once; the program continues.
  void connectNow() { platform_->connectNow(); }

  /// Stops the robot from any thread; not null.
  std::shared_ptr<StopSwitch> stopSwitch() const { return stopSwitch_; }

  const RealRobotOptions& options() const { return options_; }
  /// The file of the layout in which the program runs.
  std::filesystem::path layout() const;
  const robotlink::Clock& clock() const { return clock_; }
  const RealPlatform& platform() const { return *platform_; }
  const HostedRobot& robot() const { return robot_->robot(); }
  ProgramOverrides overrides() const { return robot_->overrides(); }
  /// Null if the robot knows no map.
  std::shared_ptr<const robotlink::GroundMap> map() const { return robot().map; }

 private:
  RealRun(RealRobotOptions options, Listeners listeners, logplayer::Recorder* recorder);
  /// Makes and starts everything; to be called once.
  robotlink::Errors load();
  /// Reads description, field and map, and makes the host.
  robotlink::Errors describeRobot();
  /// Makes a program in a layout; `platform` is null if that of the robot stays.
  tl::expected<RobotHost::Candidate, robotlink::Errors> makeProgram(
      std::unique_ptr<robotlink::Platform> platform, const std::filesystem::path& file);
  /// What makes the program; empty: it is one inside.
  HostedProgram::Maker maker() const;
  /// Adopts a program and starts its threads.
  void start(RobotHost::Candidate program);
  /// Ends the threads and the program.
  void stop();
  /// Passes a sentence about the other programs to the listener; any thread.
  void reportSpread(const std::string& text) const;

  RealRobotOptions options_;
  Listeners listeners_;
  robotlink::SteadyClock clock_;
  /// Null if nothing is recorded.
  std::unique_ptr<RecordingTap> tap_;
  /// Owned by robot_, or by a candidate before that is adopted.
  RealPlatform* platform_ = nullptr;
  /// Null if all processes run in this program.
  std::unique_ptr<SpreadProgram> spread_;
  std::unique_ptr<RobotHost> robot_;
  std::vector<std::string> lostChoices_;
  std::shared_ptr<StopSwitch> stopSwitch_;
  LeftOverPrograms leftOver_;
  std::unique_ptr<ProgramExecutor> executor_;
};

}  // namespace app
