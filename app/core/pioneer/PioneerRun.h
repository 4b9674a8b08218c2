// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "app/core/pioneer/PioneerPlatform.h"
#include "app/core/program/RobotHost.h"
#include "app/core/program/StopSwitch.h"

namespace logplayer {
class Recorder;
}
namespace robotcontrol {
class DebugQueue;
class Request;
}  // namespace robotcontrol
namespace robotlink {
class RobotProgram;
struct FieldDescription;
struct GroundMap;
}  // namespace robotlink

namespace app {

class RecordingTap;

/// A robot at the far end of a line, and what runs on it. Paths are files.
struct PioneerOptions {
  std::string url;                    ///< "tcp://localhost:8101", "serial:///dev/ttyUSB0?baud=9600"
  std::string robot = "p3at1";        ///< what it is called here
  std::string kind = "p3at";          ///< which resources/robots/<kind>.yaml it is
  std::filesystem::path layout = {};  ///< empty: that of its kind
  std::filesystem::path map = {};     ///< of where it drives; empty: it knows none
  std::map<std::string, std::string> solutions =
      {};                           ///< task -> solution at the start, instead of the layout's
  bool motorsOn = false;            ///< as soon as it is connected
  ProgramOverrides overrides = {};  ///< what a person chose for it while it was connected before
};

/// A Pioneer at the far end of a line with its program, which runs here: one thread for each of its
/// processes, in real time.
///
/// Stepped by its caller some hundred times a second. Built as a whole or refused with all reasons; that the
/// robot does not answer is no reason: the line is opened again and again, and link/status says how that
/// goes. One thread at a time; listeners are called in the processes' threads.
class PioneerRun {
 public:
  using Listeners = RobotHost::Listeners;

  /// `recorder`: is told all that a log may hold; it must outlive the run. Null: there is none.
  static tl::expected<std::unique_ptr<PioneerRun>, robotlink::Errors> create(
      PioneerOptions options, Listeners listeners, logplayer::Recorder* recorder = nullptr);
  ~PioneerRun();

  void step();
  /// Starts the program anew in another layout while the robot stays connected. If that is not possible, all
  /// goes on as before. What a person chose stays so where the layout has it.
  robotlink::Errors setLayout(const std::filesystem::path& file);
  /// What of the choices the program that runs now cannot fulfill, a sentence each.
  const std::vector<std::string>& lostChoices() const { return lostChoices_; }
  /// Hands a request to the program, or STOP and what concerns the base to the platform.
  robotlink::Result<void> request(const robotcontrol::Request& request);
  /// A connection that was lost is sought again at once; the program goes on.
  void connectNow() { platform_->connectNow(); }

  /// Stops the robot whatever the other threads do; not null.
  std::shared_ptr<StopSwitch> stopSwitch() const { return stopSwitch_; }

  const PioneerOptions& options() const { return options_; }
  /// The file of the layout in which the program runs.
  std::filesystem::path layout() const;
  const robotlink::Clock& clock() const { return clock_; }
  const PioneerPlatform& platform() const { return *platform_; }
  const HostedRobot& robot() const { return robot_->robot(); }
  ProgramOverrides overrides() const { return robot_->overrides(); }
  std::shared_ptr<const robotlink::GroundMap> map() const { return robot().map; }

 private:
  PioneerRun(PioneerOptions options, Listeners listeners, logplayer::Recorder* recorder);
  robotlink::Errors load();
  robotlink::Errors describeRobot();
  tl::expected<RobotHost::Candidate, robotlink::Errors> makeProgram(
      std::unique_ptr<robotlink::Platform> platform, const std::filesystem::path& file);
  void start(RobotHost::Candidate program);
  void stop();

  PioneerOptions options_;
  Listeners listeners_;
  robotlink::SteadyClock clock_;
  std::unique_ptr<RecordingTap> tap_;    // null: there is no recorder
  PioneerPlatform* platform_ = nullptr;  // the robot's
  std::unique_ptr<RobotHost> robot_;
  std::vector<std::string> lostChoices_;
  std::shared_ptr<StopSwitch> stopSwitch_;
  std::unique_ptr<ProgramExecutor> executor_;
};

}  // namespace app
