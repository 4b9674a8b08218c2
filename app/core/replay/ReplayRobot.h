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

#include "app/core/program/ProgramOverrides.h"
#include "app/core/replay/LoggedPaths.h"
#include "app/core/replay/PackageDifferences.h"
#include "app/core/replay/ReplayPlan.h"
#include "app/core/replay/ReplaySetup.h"
#include "logplayer/LogPlatform.h"
#include "logplayer/file/LogFile.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RobotProgram.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/process/LockstepExecutor.h"

namespace app {

/// What a person chose for a robot of a log; it outlives the programs that are made of it.
struct ReplayChoices {
  std::filesystem::path layout;  ///< empty: the log's
  ProgramOverrides overrides;    ///< against the layout and the log
  std::map<std::string, robotcontrol::ControlReplay::PackageSource> packages;
  bool recomputeAll = false;        ///< of what `packages` does not name
  bool publishAllPackages = false;  ///< all are told so
};

/// One robot of a log with the program that runs on what the log holds. All times are those of the log, so
/// that an offset changes no bytes. One thread; listeners are called in it.
class ReplayRobot {
 public:
  struct Listeners {
    std::function<void(std::shared_ptr<const robotcontrol::DebugQueue>)> queue;
    std::function<void(const robotlink::Process&, const std::string&)> trouble;
  };
  /// `logName` is the robot's name in the log, `name` that in the replay.
  ReplayRobot(std::shared_ptr<logplayer::LogFile> log, std::string logName, std::string name,
              ReplayChoices choices, Listeners listeners);
  ~ReplayRobot();

  const std::string& name() const { return name_; }
  const ReplaySetup& setup() const { return *setup_; }
  const ReplayPlan& plan() const { return plan_; }
  /// What the program here is made of, as a log of it would tell.
  std::shared_ptr<const robotcontrol::ProgramSetup> ownSetup() const { return ownSetup_; }
  const ReplayChoices& choices() const { return choices_; }
  /// What of them the program here cannot fulfill, a sentence each.
  std::vector<std::string> lostChoices() const;

  /// Makes a new program as it is to be at a time, and gives it what the log holds before. If that is not
  /// possible, the one before goes on.
  robotlink::Errors start(robotlink::Instant time);
  /// The same with other choices; if that is not possible, those before hold.
  robotlink::Errors start(robotlink::Instant time, ReplayChoices choices);

  /// A task runs.
  bool computes() const;
  /// Why a task that runs is done by another solution than this one that was chosen for it; empty if it is
  /// not.
  std::string whyNotDoneBy(const std::string& task, const std::string& solution) const;
  /// What the program must see of the log, so that nothing else need be read while nobody watches.
  std::vector<std::string> neededStreams() const;
  /// Goes on to an instant. `messages`: all that the log holds of this robot at that time, images decoded.
  void take(robotlink::Instant now, const std::vector<robotlink::StreamMessage>& messages);
  /// Runs the program over what was taken.
  void run();
  /// Where and as what a message of the log is told beside this program.
  robotlink::StreamMessage published(robotlink::StreamMessage message) const;

  robotlink::Result<void> request(const robotcontrol::Request& request);

  PackageDifferences& differences() { return differences_; }
  const PackageDifferences& differences() const { return differences_; }
  /// While nobody watches, differences are not counted.
  void countDifferences(bool count) { countsDifferences_ = count; }

 private:
  struct Program;  // everything that is made anew
  std::shared_ptr<const robotlink::GroundMap> loggedMapAt(robotlink::Instant time) const;
  std::optional<robotcontrol::ProgramSetup> loggedSetupAt(robotlink::Instant time) const;
  robotlink::Errors readSetupAt(robotlink::Instant time);
  robotlink::Errors makeProgram();
  robotlink::Errors playOnly(const robotlink::Errors& why);
  ReplaySelection overrides() const;
  tl::expected<std::unique_ptr<Program>, robotlink::Errors> programFor(const ReplayPlan& plan);
  std::vector<logplayer::LogPlatform::Package> platformPackages(const ReplayPlan& plan) const;
  void describeProgram(const Program& program);
  void listen(Program& program, const ReplayPlan& plan);
  robotlink::Errors startWith(robotlink::Instant time, ReplayChoices choices);
  void giveWhatIsBefore(robotlink::Instant time);
  std::string below(const std::string& path) const { return path.substr(logName_.size() + 1); }
  void takePackage(const std::string& package, const robotlink::StreamMessage& message);
  void takeRequest(const robotcontrol::Request& request);
  void takeRequest(const google::protobuf::Message& package);
  bool hasRequests() const { return streams_.contains(robotlink::streams::kRequests); }
  bool takeSetup(const robotcontrol::ProgramSetup& setup, robotlink::Instant now);
  bool debugProcessRan(const std::vector<robotlink::StreamMessage>& messages) const;
  bool isAvailable(const std::string& task, const std::string& solution) const;
  void remember(const robotcontrol::Request& request);
  void noticeAnswers(const robotcontrol::DebugQueue& queue);

  const std::shared_ptr<logplayer::LogFile> log_;
  const std::string logName_;
  const std::string name_;
  const Listeners listeners_;
  const std::map<std::string, const google::protobuf::Descriptor*> types_;  // of packages
  std::set<std::string> logged_;                                            // packages in the log
  std::map<std::string, robotlink::Instant> comparedUntil_;                 // by package
  std::set<std::string> streams_;                                           // of the robot, below its name
  ReplayChoices choices_;
  std::optional<robotcontrol::ProgramSetup> loggedSetup_;  // that setup_ was made of
  std::shared_ptr<const ReplaySetup> setup_;
  std::shared_ptr<const robotcontrol::ProgramSetup> ownSetup_;
  ReplayPlan plan_;
  LoggedPaths paths_;
  robotlink::ManualClock clock_;
  std::unique_ptr<Program> program_;
  std::vector<robotcontrol::Request> due_;  // logged requests that wait for the debug process
  std::map<std::uint64_t, robotcontrol::Request> unanswered_;  // by id
  PackageDifferences differences_;
  bool countsDifferences_ = true;
};

}  // namespace app
