// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/core/program/ProgramOverrides.h"
#include "logplayer/file/LogFile.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Error.h"
#include "robotlink/session/StreamMessage.h"

namespace robotcontrol {
class Request;
}
namespace robotlink {
class Process;
struct FieldDescription;
struct RobotDescription;
struct SharedDebugQueue;
}  // namespace robotlink

namespace app {

/// One of the logs of a replay. A plain value.
struct ReplayLog {
  std::filesystem::path file;
  /// Added to the times of the log.
  robotlink::Duration offset{0};
  /// Whether the user chose the offset. Otherwise a log that does not overlap with the first one is shifted
  /// to begin with it, since the clocks of different computers do not agree.
  bool offsetChosen = false;
};

/// What is replayed, and how. A plain value.
struct ReplayOptions {
  /// Robots of equal names in several logs get "-2", "-3" and so on behind their names.
  std::vector<ReplayLog> logs;
  /// The layout of the programs that run on the logged data; empty: the one in each robot's log or, without
  /// one, that of the robot's kind.
  std::filesystem::path layout;
  /// Maps tasks to solutions, instead of the layout's.
  std::map<std::string, std::string> solutions;
  /// What the user chose for the robots before, by name.
  std::map<std::string, ProgramOverrides> overrides;
  /// Sources of packages, by "<robot>/<package>" or, for all robots, "*/<package>". For others the contents
  /// of the logs decide.
  std::map<std::string, robotcontrol::ControlReplay::PackageSource> packages;
  /// Whether all packages that `packages` does not name are recomputed if possible.
  bool recomputeAll = false;
  /// A color table (.c64) for all robots; empty: the one in the log.
  std::filesystem::path colorTable;
  /// Whether the programs publish all packages that they yield, even if their debug keys are off.
  bool publishAllPackages = false;
  /// How much of the log before the aim of a jump the programs run on, so that their models settle.
  robotlink::Duration preroll = std::chrono::seconds(2);
  /// Called while the logs are opened; can cancel that.
  logplayer::LogFile::Progress progress;
};

/// Robot programs on logged data. The caller moves them along the logs' common time line: by steps to the
/// next instant at which a log has messages, or by jumps. They run in lockstep, so the same logs, choices and
/// programs give the same bytes.
///
/// A logged package replaces the task that yields it, unless the user chooses to recompute it; the logged one
/// is then published as "<robot>/logged/<package>". Tasks that lack inputs do not run; describe() reports
/// what they lack. Logged requests are made again at their times if their task is recomputed.
///
/// One thread at a time; listeners are called in that thread.
class ReplayRun {
 public:
  /// Functions that are called with what is published, in times of the time line; each may be empty.
  struct Listeners {
    /// Called with the messages of the logs at each step. After a jump, called once with the newest message
    /// of every stream, including those of the programs.
    std::function<void(std::vector<robotlink::StreamMessage>)> logged;
    /// Called with the debug queues of programs, and after a jump with the results of requests.
    std::function<void(const std::string& robot, std::shared_ptr<const robotlink::SharedDebugQueue>)> queue;
    /// Called with a sentence if something is wrong with a process.
    std::function<void(const std::string& robot, const robotlink::Process& process, const std::string& text)>
        trouble;
  };
  /// Opens the logs at the beginning of the time line. Fails with all reasons if a file cannot be read or a
  /// program cannot be made.
  static tl::expected<std::unique_ptr<ReplayRun>, robotlink::Errors> create(ReplayOptions options,
                                                                            Listeners listeners);
  ~ReplayRun();

  /// The present instant; before the first step the beginning.
  robotlink::Instant now() const;
  /// The first and the last instant of all logs.
  robotlink::Instant begin() const;
  robotlink::Instant end() const;
  /// The instant of the next step; nothing at the end.
  std::optional<robotlink::Instant> nextTime() const;

  /// Steps to nextTime(). Returns false at the end.
  bool step();
  /// Jumps to `time`, or to the nearer end: restarts the programs, runs them over the preroll without
  /// publishing, and then publishes the newest message of every stream up to `time`, in order of time,
  /// including what was recomputed on the way. Of streams with a history (numbers, texts) the whole preroll
  /// is published, so that plots and lists do not start empty. Where a program cannot be made, errors say
  /// why, and its previous one stays.
  robotlink::Errors jump(robotlink::Instant time);

  /// Sets the process whose frames are stepped and counted, "<robot>/<process>"; at first one that waits for
  /// images. Returns false if the logs have no frames of it.
  bool setStepProcess(const std::string& process);
  const std::string& stepProcess() const;
  /// The time of the frame `count` frames after (negative: before) the present one of "<robot>/<process>";
  /// the last or first one if there are fewer. Nothing if the logs have no frames of it.
  std::optional<robotlink::Instant> frameTime(const std::string& process, int count) const;
  /// The time of a frame by the number that the process gave it; nothing if it is not in the logs.
  std::optional<robotlink::Instant> timeOfFrame(const std::string& process, std::uint64_t frame) const;
  /// Like frameTime(), for the messages of a stream; those of the same instant count as one.
  std::optional<robotlink::Instant> messageTime(const std::string& stream, int count) const;

  /// Chooses the sources of packages, by "<robot>/<package>", and restarts the programs at now(). If that is
  /// impossible, the previous choices stay.
  robotlink::Errors choosePackages(
      const std::map<std::string, robotcontrol::ControlReplay::PackageSource>& packages);
  /// Restarts the programs in another layout at now(). If that is impossible, the previous layouts stay.
  robotlink::Errors setLayout(const std::filesystem::path& file);
  /// Shifts a log on the time line; jumps to now(), or to the nearer end.
  void setOffset(const std::filesystem::path& log, robotlink::Duration offset);
  /// Passes a request to a robot's program; overrides are kept over jumps. Call jump(now()) to see its effect
  /// at once.
  robotlink::Result<void> request(const robotcontrol::Request& request);
  /// What the programs will answer in their next frames to what they were asked, if they have not answered
  /// yet, with the tables and parameters that follow from it; by robot.
  using Answers = std::pair<std::string, std::shared_ptr<const robotlink::SharedDebugQueue>>;
  std::vector<Answers> answersToCome();

  /// The solutions of the options that have no effect because their tasks do not run, as a sentence each,
  /// with the reason.
  std::vector<std::string> unusedSolutions() const;
  /// Fills in logs, processes, packages, differences, tasks, beginning, end, time, and the frames of the step
  /// process. ReplayFeed fills in the state of playback.
  void describe(robotcontrol::ReplayStatus& status) const;
  /// The options with the present layout and offsets.
  const ReplayOptions& options() const;
  /// What the user chose so far, by robot.
  std::map<std::string, ProgramOverrides> overrides() const;
  /// The overrides that the present programs cannot fulfill, as a sentence each.
  std::vector<std::string> lostChoices() const;
  /// The names of the robots in the replay.
  std::vector<std::string> robots() const;
  /// Returns null if there is no such robot.
  std::shared_ptr<const robotlink::RobotDescription> description(const std::string& robot) const;
  /// The field of the first robot; null without robots.
  std::shared_ptr<const robotlink::FieldDescription> field() const;

 private:
  struct Implementation;
  explicit ReplayRun(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace app
