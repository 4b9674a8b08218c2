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

#include "app/core/program/ProgramRequests.h"
#include "app/core/replay/LoggedPaths.h"
#include "app/core/replay/PackageDifferences.h"
#include "app/core/replay/ReplayPlan.h"
#include "app/core/replay/ReplaySetup.h"
#include "logplayer/LogPlatform.h"
#include "logplayer/file/LogFile.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/process/LockstepExecutor.h"

namespace app {

/// What the user chose for a robot of a log. It is kept when the program is made again. A plain value.
struct ReplayChoices {
  /// The file of the layout; empty: the log's.
  std::filesystem::path layout;
  /// Sources of packages, by package.
  std::map<std::string, robotcontrol::ControlReplay::PackageSource> packages;
  /// Whether all packages that `packages` does not name are recomputed if possible.
  bool recomputeAll = false;
  /// Whether the program publishes all packages that it yields, even if their debug keys are off.
  bool publishAllPackages = false;
};

/// One robot of a log and the program that runs on the logged data. All times are those of the log, so that
/// an offset on the time line changes no bytes. One thread; listeners are called in it.
class ReplayRobot {
 public:
  /// Functions that are called with what the program publishes; must not be empty.
  struct Listeners {
    /// Called with each debug queue.
    std::function<void(std::shared_ptr<const robotlink::SharedDebugQueue>)> queue;
    /// Called with the rest of a sentence about a process: "waits for ...".
    std::function<void(const robotlink::Process&, const std::string&)> trouble;
  };
  /// `logName` is the robot's name in the log, `name` that in the replay; `overrides` are the user's against
  /// the layout and the logged requests. There is no program before start().
  ReplayRobot(std::shared_ptr<logplayer::LogFile> log, std::string logName, std::string name,
              ReplayChoices choices, ProgramOverrides overrides, Listeners listeners);
  ~ReplayRobot();

  const std::string& name() const { return name_; }
  /// What the robot is and what should run for it; valid after start().
  const ReplaySetup& setup() const { return *setup_; }
  /// What runs of it.
  const ReplayPlan& plan() const { return plan_; }
  /// The setup of the program that runs here, as a log of it would contain it.
  std::shared_ptr<const robotcontrol::ProgramSetup> ownSetup() const { return ownSetup_; }
  const ReplayChoices& choices() const { return choices_; }
  /// A copy of the user's overrides so far.
  ProgramOverrides overrides() const { return requests_.overrides(); }
  /// The overrides that the program cannot fulfill, as a sentence each.
  std::vector<std::string> lostChoices() const;

  /// Makes a new program as of a time, and gives it what the log contains before. If that is impossible, the
  /// previous program stays.
  robotlink::Errors start(robotlink::Instant time);
  /// The same with other choices; if that is impossible, the previous ones stay, too.
  robotlink::Errors start(robotlink::Instant time, ReplayChoices choices);

  /// Whether any task runs.
  bool computes() const;
  /// If a task that runs is done by another solution than this one, returns the reason; otherwise an empty
  /// text.
  std::string whyNotDoneBy(const std::string& task, const std::string& solution) const;
  /// The streams of the log that the program needs. While nothing is published, no others have to be read.
  std::vector<std::string> neededStreams() const;
  /// Advances to an instant. `messages` are all that the log has of this robot at that time, images decoded.
  void take(robotlink::Instant now, const std::vector<robotlink::StreamMessage>& messages);
  /// Runs the program on what was taken.
  void run();
  /// Returns a message of the log as it is published beside this program: on its own path or on that of
  /// logged ones.
  robotlink::StreamMessage published(robotlink::StreamMessage message) const;

  /// Passes a request to the program when that runs next; overrides are kept for later programs. Fails for
  /// STOP and if too many requests are waiting.
  robotlink::Result<void> request(const robotcontrol::Request& request);
  /// As RobotHost::answersToCome().
  std::shared_ptr<const robotlink::SharedDebugQueue> answersToCome();

  /// How recomputed packages differ from logged ones.
  PackageDifferences& differences() { return differences_; }
  const PackageDifferences& differences() const { return differences_; }
  /// Whether run() counts differences; not done while a jump runs over earlier data.
  void countDifferences(bool count) { countsDifferences_ = count; }

 private:
  /// The program with its platform and executor, which are made together.
  struct Program;
  /// The logged map at a time, or the first one later; null if there is none.
  std::shared_ptr<const robotlink::GroundMap> loggedMapAt(robotlink::Instant time) const;
  /// The logged setup at a time, or the first one later.
  std::optional<robotcontrol::ProgramSetup> loggedSetupAt(robotlink::Instant time) const;
  /// Sets setup_ and loggedSetup_ to what holds at a time, with the user's overrides.
  robotlink::Errors readSetupAt(robotlink::Instant time);
  /// Makes plan and program from the setup. Solutions that cannot be constructed count as unavailable.
  robotlink::Errors makeProgram();
  /// Makes a program that computes nothing, because that of the log cannot run for these reasons.
  robotlink::Errors playOnly(const robotlink::Errors& why);
  /// The input of planReplay() from setup and choices.
  ReplaySelection selection() const;
  /// Makes a program for a plan, without replacing the present one.
  tl::expected<std::unique_ptr<Program>, robotlink::Errors> programFor(const ReplayPlan& plan);
  /// The packages that the platform sends, since they are as logged.
  std::vector<logplayer::LogPlatform::Package> platformPackages(const ReplayPlan& plan) const;
  /// Sets ownSetup_.
  void describeProgram(const Program& program);
  /// Connects listeners and taps to a program.
  void listen(Program& program, const ReplayPlan& plan);
  /// start() without the data before that time.
  robotlink::Errors startWith(robotlink::Instant time, ReplayChoices choices);
  /// Gives a new program the latest packages and requests before a time.
  void giveWhatIsBefore(robotlink::Instant time);
  /// The part of a logged path behind the robot's name.
  std::string below(const std::string& path) const { return path.substr(logName_.size() + 1); }
  /// Passes a logged package to the platform, or to the comparison if it is recomputed.
  void takePackage(const std::string& package, const robotlink::StreamMessage& message);
  /// Enqueues a logged request for the debug process, unless the user's overrides take precedence.
  void takeRequest(const robotcontrol::Request& request);
  /// The same for a package of the debug process, in logs without requests.
  void takeRequest(const google::protobuf::Message& package);
  /// Whether the log contains requests.
  bool hasRequests() const { return streams_.contains(robotlink::streams::kRequests); }
  /// Restarts the program if it was restarted at this point of the recording. Returns true if so.
  bool takeSetup(const robotcontrol::ProgramSetup& setup, robotlink::Instant now);
  /// Whether the debug process ran at this instant of the recording.
  bool debugProcessRan(const std::vector<robotlink::StreamMessage>& messages) const;
  /// Passes the requests that wait to the program.
  void handRequests();

  const std::shared_ptr<logplayer::LogFile> log_;
  const std::string logName_;
  const std::string name_;
  const Listeners listeners_;
  /// The types of all packages, by name.
  const std::map<std::string, const google::protobuf::Descriptor*> types_;
  /// Names of the packages in the log.
  std::set<std::string> logged_;
  /// The last instant of each logged package at which a recomputed one is compared.
  std::map<std::string, robotlink::Instant> comparedUntil_;
  /// Paths of the log below the robot's name.
  std::set<std::string> streams_;
  ReplayChoices choices_;
  /// The user's requests to all programs of the robot, and the overrides that follow from them.
  ProgramRequests requests_;
  /// The logged setup from which setup_ was made.
  std::optional<robotcontrol::ProgramSetup> loggedSetup_;
  std::shared_ptr<const ReplaySetup> setup_;
  std::shared_ptr<const robotcontrol::ProgramSetup> ownSetup_;
  ReplayPlan plan_;
  LoggedPaths paths_;
  /// The clock of the platform, in times of the log.
  robotlink::ManualClock clock_;
  std::unique_ptr<Program> program_;
  /// Logged requests that wait until the debug process ran in the recording.
  std::vector<robotcontrol::Request> due_;
  PackageDifferences differences_;
  bool countsDifferences_ = true;
};

}  // namespace app
