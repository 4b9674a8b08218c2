// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/core/own/OwnProgram.h"
#include "app/core/own/SpareChild.h"
#include "app/core/program/LeftOverPrograms.h"
#include "app/core/program/RobotHost.h"
#include "app/platforms/replay/LoggedPaths.h"
#include "app/platforms/replay/PackageDifferences.h"
#include "app/platforms/replay/ReplayPlan.h"
#include "app/platforms/replay/ReplaySetup.h"
#include "app/platforms/replay/TurnEvents.h"
#include "logplayer/LogPlatform.h"
#include "logplayer/file/LogFile.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"

namespace app {

/// The options of running the program of a robot of a log. A plain value.
struct ReplayHosting {
  /// The time that a module may take before it counts as not returning, in real time; 0: forever.
  std::chrono::milliseconds patience{0};
  bool ownProcess = false;
  /// The options of running it in a process of its own.
  OwnProgram::Options own = {};
};

/// The user's choices for a robot of a log. They are kept when the program is made again. A plain value.
struct ReplayChoices {
  /// The file of the layout; empty: the log's.
  std::filesystem::path layout;
  /// Sources of packages, by package.
  std::map<std::string, robotcontrol::ControlReplay::PackageSource> packages;
  /// Whether all packages that `packages` does not name are recomputed if possible.
  bool recomputeAll = false;
  /// Whether the program publishes all packages that it yields, even if their debug keys are off.
  bool publishAllPackages = false;
  ReplayHosting hosting = {};
};

/// A robot of a log: chooses what runs for it on the logged data, passes that data to the platform of its
/// host, and compares what is computed with what was logged. All times are those of the log, so that an
/// offset on the timeline changes no bytes. One thread; listeners are called in it.
class ReplayRobot {
 public:
  /// A program that has not run yet, with all that it was made from, for begin().
  struct Start {
    robotlink::Instant time;
    ReplayChoices choices;
    /// The logged setup; nothing if the log has none.
    std::optional<robotcontrol::ProgramSetup> logged;
    ReplaySetup setup;
    ReplayPlan plan;
    /// Owned by `program`.
    logplayer::LogPlatform* platform = nullptr;
    RobotHost::Candidate program;
  };

  /// `logName` is the robot's name in the log, `name` that in the replay; `overrides` are the user's against
  /// the layout and the logged requests. There is no program before begin().
  ReplayRobot(std::shared_ptr<logplayer::LogFile> log, std::string logName, std::string name,
              ReplayChoices choices, ProgramOverrides overrides, RobotHost::Listeners listeners);
  ~ReplayRobot();

  const std::string& name() const { return host_.name(); }
  RobotHost& host() { return host_; }
  const RobotHost& host() const { return host_; }
  /// The setup that should run for it; valid after begin().
  const ReplaySetup& setup() const { return started_.setup; }
  /// The part of it that runs.
  const ReplayPlan& plan() const { return started_.plan; }
  /// The setup of the program that was begun, as a log of it would contain it. Before it runs.
  std::shared_ptr<const robotcontrol::ProgramSetup> ownSetup() const;
  const ReplayChoices& choices() const { return started_.choices; }
  /// The overrides that the program cannot fulfill, as a sentence each.
  std::vector<std::string> lostChoices() const;

  /// Makes a program as of a time, with these choices. Nothing changes before begin().
  tl::expected<Start, robotlink::Errors> prepare(robotlink::Instant time, ReplayChoices choices);
  /// Replaces the program, and gives the new one what the log contains before its time.
  void begin(Start start);

  /// Whether any task runs.
  bool computes() const;
  /// If a task that runs is done by another solution than this one, returns the reason; otherwise an empty
  /// text.
  std::string whyNotDoneBy(const std::string& task, const std::string& solution) const;
  /// The streams of the log that the program needs. While nothing is published, no others have to be read.
  std::vector<std::string> neededStreams() const;
  /// Advances to an instant. `messages` are all that the log has of this robot at that time, images decoded.
  void take(robotlink::Instant now, const std::vector<robotlink::StreamMessage>& messages);
  /// Runs the program on what was taken. A module that does not return is given up after the patience; then
  /// the program does not run until it returns or is replaced.
  void run();
  /// Ends the program; nothing else but hasEnded() may be called then.
  void end();
  /// Whether all modules of programs that were ended have returned. Any thread, after end().
  bool hasEnded() const { return leftOver_.haveEnded(); }
  /// Returns a message of the log as it is published along with this program: on its own path or on that of
  /// logged ones.
  robotlink::StreamMessage published(robotlink::StreamMessage message) const;

  /// The differences between recomputed and logged packages.
  PackageDifferences& differences() { return differences_; }
  const PackageDifferences& differences() const { return differences_; }
  /// Whether run() counts differences; not done while a jump runs over earlier data.
  void countDifferences(bool count) { countsDifferences_ = count; }

 private:
  /// The logged map at a time, or the first one later; null if there is none.
  std::shared_ptr<const robotlink::GroundMap> loggedMapAt(robotlink::Instant time) const;
  /// The logged setup at a time, or the first one later.
  std::optional<robotcontrol::ProgramSetup> loggedSetupAt(robotlink::Instant time) const;
  /// Reads the setup that holds at a time, with the user's overrides.
  robotlink::Errors readSetup(Start& start) const;
  /// Makes plan and program from the setup, without any tasks if those of the log can no longer run.
  robotlink::Errors makeProgram(Start& start);
  /// The same for a layout. Solutions that cannot be constructed count as unavailable.
  robotlink::Errors makeAvailable(Start& start);
  /// Makes a program for the plan.
  robotlink::Errors makeProgramOfPlan(Start& start);
  /// The packages that the platform sends, since they are as logged.
  std::vector<logplayer::LogPlatform::Package> platformPackages(const ReplayPlan& plan) const;
  /// Adds to the listeners what affects the comparison.
  RobotHost::Listeners comparing(RobotHost::Listeners listeners);
  /// Has the listeners called in the thread of this object only.
  RobotHost::Listeners inTurns(RobotHost::Listeners listeners);
  /// Makes an executor for the program that was started.
  void makeExecutor();
  /// Returns the maker of the program of a start; empty: the program is one inside.
  HostedProgram::Maker makerOf(const Start& start);
  /// Taps what the program sends to compare it with what was logged.
  void compare();
  /// begin() without the data before that time.
  void adopt(Start start);
  /// Gives a new program the latest packages and requests before its time.
  void giveWhatIsBefore();
  /// The part of a logged path behind the robot's name.
  std::string below(const std::string& path) const { return path.substr(logName_.size() + 1); }
  /// Passes a logged package to the platform, or to the comparison if it is recomputed.
  void takePackage(const std::string& package, const robotlink::StreamMessage& message);
  /// Enqueues a logged request for the debug process, unless the user's overrides take precedence.
  void takeRequest(const robotcontrol::Request& request);
  /// Enqueues the request that a package of the debug process stands for, in logs without requests.
  void takeRequest(const google::protobuf::Message& package);
  /// Whether the log contains requests.
  bool hasRequests() const { return streams_.contains(robotlink::streams::kRequests); }
  /// Restarts the program if it was restarted at this point of the recording. Returns true if so.
  bool takeSetup(const robotcontrol::ProgramSetup& setup, robotlink::Instant now);
  /// Whether the debug process ran at this instant of the recording.
  bool debugProcessRan(const std::vector<robotlink::StreamMessage>& messages) const;

  const std::shared_ptr<logplayer::LogFile> log_;
  const std::string logName_;
  /// The types of all packages, by name.
  const std::map<std::string, const google::protobuf::Descriptor*> types_;
  /// Names of the packages in the log.
  std::set<std::string> logged_;
  /// The last instant of each logged package at which a recomputed one is compared.
  std::map<std::string, robotlink::Instant> comparedUntil_;
  /// Paths of the log below the robot's name.
  std::set<std::string> streams_;
  /// The start from which the present program was made.
  Start started_;
  LoggedPaths paths_;
  /// The clock of the platform, in times of the log.
  robotlink::ManualClock clock_;
  TurnEvents events_;
  /// For programs in processes of their own; null before the first one.
  std::shared_ptr<SpareChild> spare_;
  RobotHost host_;
  LeftOverPrograms leftOver_;
  /// Declared after the host, whose processes it executes.
  std::unique_ptr<ProgramExecutor> executor_;
  /// Logged requests that wait until the debug process ran in the recording.
  std::vector<robotcontrol::Request> due_;
  PackageDifferences differences_;
  bool countsDifferences_ = true;
};

}  // namespace app
