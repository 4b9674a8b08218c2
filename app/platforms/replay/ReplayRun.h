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

#include "app/platforms/replay/ReplayLogs.h"
#include "app/platforms/replay/ReplayOptions.h"
#include "robotlink/base/Error.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/session/StreamMessage.h"

namespace app {

/// Robot programs on logged data. The caller moves them along the logs' common timeline: by steps to the
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
  /// Functions that are called with what is published, in times of the timeline; each may be empty.
  struct Listeners {
    /// Called with the messages of the logs at each step. After a jump, called once with the newest message
    /// of every stream, including those of the programs.
    std::function<void(std::vector<robotlink::StreamMessage>)> logged;
    /// Called with the debug queues of programs, and after a jump with the results of requests.
    std::function<void(const std::string& robot, std::shared_ptr<const robotlink::SharedDebugQueue>)> queue;
    /// Called with a sentence if something is wrong with a process.
    std::function<void(const std::string& robot, const robotlink::Process& process, const std::string& text)>
        trouble;
    /// Called when it has changed where a robot's program runs, or whether it does; only for robots for which
    /// something is computed.
    std::function<void(const std::string& robot, robotlink::Instant time,
                       const robotcontrol::HostingStatus& status)>
        hosting = {};
  };
  /// Opens the logs at the beginning of the timeline. Fails with all reasons if a file cannot be read or a
  /// program cannot be made.
  static tl::expected<std::unique_ptr<ReplayRun>, robotlink::Errors> create(ReplayOptions options,
                                                                            Listeners listeners);
  ~ReplayRun();
  /// Ends the programs. Nothing else but hasEnded() may be called then. Otherwise the destructor waits for
  /// modules that do not return.
  void stop();
  /// Whether all modules of programs that were ended have returned. Any thread, after stop().
  bool hasEnded() const;

  /// The present instant; before the first step the beginning.
  robotlink::Instant now() const { return now_; }
  /// The first and the last instant of all logs.
  robotlink::Instant begin() const { return logs_.begin(); }
  robotlink::Instant end() const { return logs_.end(); }
  /// The instant of the next step; nothing at the end.
  std::optional<robotlink::Instant> nextTime() const { return logs_.nextTime(); }

  /// Steps to nextTime(). Returns false at the end.
  bool step();
  /// Jumps to `time`, or to the nearer end: restarts the programs, runs them over the preroll without
  /// publishing, and then publishes the newest message of every stream up to `time`, in order of time,
  /// including what was recomputed on the way. Of streams with a history (numbers, texts) the whole preroll
  /// is published, so that plots and lists do not start empty. If one of the programs cannot be made, nothing
  /// changes, and errors say why.
  robotlink::Errors jump(robotlink::Instant time);

  /// Sets the process whose frames are stepped and counted, "<robot>/<process>"; at first one that waits for
  /// images. Returns false if the logs have no frames of it.
  bool setStepProcess(const std::string& process);
  const std::string& stepProcess() const { return stepProcess_; }
  /// The time of the frame `count` frames after (negative: before) the present one of "<robot>/<process>";
  /// the last or first one if there are fewer. Nothing if the logs have no frames of it.
  std::optional<robotlink::Instant> frameTime(const std::string& process, int count) const;
  /// The time of a frame by the number that the process gave it; nothing if it is not in the logs.
  std::optional<robotlink::Instant> timeOfFrame(const std::string& process, std::uint64_t frame) const {
    return logs_.timeOfFrame(process, frame);
  }
  /// The time of the first message of a stream; nothing if there is no such stream.
  std::optional<robotlink::Instant> firstTime(const std::string& stream) const {
    return logs_.firstTime(stream);
  }
  /// Like frameTime(), for the messages of a stream; those of the same instant count as one.
  std::optional<robotlink::Instant> messageTime(const std::string& stream, int count) const;

  /// Chooses the sources of packages, by "<robot>/<package>", and restarts the programs at now(). If that is
  /// impossible, the previous choices stay.
  robotlink::Errors choosePackages(
      const std::map<std::string, robotcontrol::ControlReplay::PackageSource>& packages);
  /// Restarts the programs in another layout at now(). If that is impossible, the previous layouts stay.
  robotlink::Errors setLayout(const std::filesystem::path& file);
  /// Chooses where the program of a robot runs, or of all if the name is empty, and starts all programs again
  /// at now(). If that is impossible, those that run continue.
  robotlink::Errors hostProgram(const std::string& robot, const robotcontrol::HostProgram& choice);
  /// Shifts logs on the timeline, by their files; jumps to now(), or to the nearer end. If that is
  /// impossible, the previous offsets stay.
  robotlink::Errors setOffsets(const std::map<std::filesystem::path, robotlink::Duration>& offsets);
  /// Passes a request to a robot's program; overrides are kept over jumps. Call jump(now()) to see its effect
  /// at once.
  robotlink::Result<void> request(const robotcontrol::Request& request);
  /// Lets solutions run in the shadow of those that are used, in all programs that can. Fails with a reason
  /// if none can. Call jump() to see their effect.
  robotlink::Result<void> runShadows(const std::vector<robotlink::ShadowName>& shadows);
  /// The answers to requests that the programs will give in their next frames, if they have not answered
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
  const ReplayOptions& options() const { return options_; }
  /// The user's choices so far, by robot.
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
  /// Changes what the user chose for a robot.
  using Change = std::function<void(const std::string& robot, ReplayChoices&)>;

  ReplayRun(ReplayOptions options, Listeners listeners);
  /// Opens all logs and makes their robots; call this once.
  robotlink::Errors open();
  /// The offset of a log that is opened after the present ones.
  robotlink::Duration offsetOf(const ReplayLog& log, const logplayer::LogFile& file) const;
  /// Makes the robots of a log and starts their programs at its beginning.
  robotlink::Errors addRobots(ReplayLogs::Source& source);
  /// The choices in the options for a robot.
  ReplayChoices choicesOf(const std::string& robot) const;
  ProgramOverrides overridesOf(const std::string& robot) const;
  /// Checks the solutions of the options. A comparison with another solution than the requested one would be
  /// wrong.
  robotlink::Errors checkChosenSolutions() const;

  /// Jumps with other choices; `change` may be empty.
  robotlink::Errors jump(robotlink::Instant time, const Change& change);
  /// Jumps with other choices to now(), if programs can be made with them there, too.
  robotlink::Errors change(const Change& change);
  /// The log time at which the programs start for a jump.
  robotlink::Instant startOf(const ReplayLogs::Source& source, robotlink::Instant time) const;
  /// Runs the programs of a log over a range of log times while nothing is published. Only the last instant
  /// counts for differences.
  void runQuietly(ReplayLogs::Source& source, robotlink::Instant from, robotlink::Instant to);
  /// Publishes what a jump has collected, with what the logs contain.
  void publishCollected();
  /// Adds the setup of a program that was started for a jump, and what is to be said about it, to notes_.
  void noteStart(const ReplayLogs::Source& source, const ReplayRobot& robot, robotlink::Instant time);
  /// Passes the messages of an instant to the robots of a log. All of them advance to it.
  static void give(ReplayLogs::Source& source, robotlink::Instant logTime,
                   const std::vector<robotlink::StreamMessage>& messages);
  /// Publishes the messages of an instant, after waiting notes.
  void publish(ReplayLogs::Source& source, const std::vector<robotlink::StreamMessage>& messages);
  /// Returns a queue with an offset added to all times; the same one if that is 0.
  static std::shared_ptr<const robotlink::SharedDebugQueue> onLine(
      const std::shared_ptr<const robotlink::SharedDebugQueue>& queue, robotlink::Duration offset);
  /// Publishes a debug queue, or collects its messages during a jump.
  void hear(const ReplayLogs::Source& source, const std::string& robot,
            const std::shared_ptr<const robotlink::SharedDebugQueue>& queue);
  /// Adds a text to notes_. `level` is a foxglove::Log::Level.
  void note(const ReplayLogs::Source& source, const std::string& robot, robotlink::Instant logTime, int level,
            const std::string& text);

  ReplayOptions options_;
  const Listeners listeners_;
  /// The color table of the options; null if they have none.
  std::shared_ptr<const robotcontrol::ColorTable> colorTable_;
  ReplayLogs logs_;
  robotlink::Instant now_;
  std::string stepProcess_;

  // During a jump, nothing is published. What the programs send meanwhile is collected in the members below
  // and published at its end.
  /// Whether a jump is in progress.
  bool quiet_ = false;
  /// All messages of streams with a history; see hasHistory().
  std::vector<robotlink::StreamMessage> history_;
  /// The newest message of each other stream, by path.
  std::map<std::string, robotlink::StreamMessage> newest_;
  /// Results of requests; null if there are none.
  std::shared_ptr<robotlink::SharedDebugQueue> answers_;
  /// Texts of the replay itself that were not published yet.
  std::vector<robotlink::StreamMessage> notes_;
};

}  // namespace app
