// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
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
}  // namespace robotlink

namespace app {

/// One log among those of a replay.
struct ReplayLog {
  std::filesystem::path file;
  robotlink::Duration offset{0};  ///< added to its times
  /// Whether a person chose the offset. Otherwise a log that does not overlap with the first one begins with
  /// it: the clocks of different machines do not agree.
  bool offsetChosen = false;
};

struct ReplayOptions {
  std::vector<ReplayLog> logs;  ///< robots of equal names get "-2", "-3" behind theirs
  /// The program that runs on the logged data; empty: the layout in each robot's log, or, without one, the
  /// shipped "compact".
  std::filesystem::path layout;
  std::map<std::string, std::string> solutions;       ///< task -> solution, instead of the layout's
  std::map<std::string, ProgramOverrides> overrides;  ///< what a person chose before for a robot, by its name
  /// By "<robot>/<package>", or "*/<package>" for all robots; what is not named is chosen by what the logs
  /// hold.
  std::map<std::string, robotcontrol::ControlReplay::PackageSource> packages;
  bool recomputeAll = false;         ///< of what `packages` does not name, whatever can be recomputed is
  std::filesystem::path colorTable;  ///< .c64; empty: the one in the log
  bool publishAllPackages =
      false;  ///< programs tell all packages that they yield, whether or not their keys are on
  /// How much of the log the program runs on before a jump's aim, so that its models are settled.
  robotlink::Duration preroll = std::chrono::seconds(2);
  logplayer::LogFile::Progress progress;
};

/// Robot programs on logged data, moved along the logs' common time line by its caller: in steps to the next
/// instant at which a platform told something, or by jumps. In lockstep, so the same logs, choices and
/// programs give the same bytes.
///
/// A logged package takes the place of the task that yields it, unless it is chosen to be recomputed; then
/// the logged one is told as "<robot>/logged/<package>". Tasks that lack inputs do not run; status() says
/// what they lack. Requests that were logged are handed in again at their times, where their task is
/// recomputed.
///
/// One thread at a time; listeners are called in that thread.
class ReplayRun {
 public:
  struct Listeners {
    /// What the logs hold, as time goes over it, complete frames; after a jump the newest message of every
    /// stream, also of what programs told on the way there.
    std::function<void(std::vector<robotlink::StreamMessage>)> logged;
    /// What a program tells.
    std::function<void(const std::string& robot, std::shared_ptr<const robotcontrol::DebugQueue>)> queue;
    std::function<void(const std::string& robot, const robotlink::Process& process, const std::string& text)>
        trouble;
  };
  static tl::expected<std::unique_ptr<ReplayRun>, robotlink::Errors> create(ReplayOptions options,
                                                                            Listeners listeners);
  ~ReplayRun();

  robotlink::Instant now() const;  ///< before the first step the time of the begin
  robotlink::Instant begin() const;
  robotlink::Instant end() const;
  /// When the next step will be; nothing at the end.
  std::optional<robotlink::Instant> nextTime() const;

  /// On to nextTime(); false at the end.
  bool step();
  /// Programs start anew, run over the preroll without being heard, and then over what is at `time` or last
  /// before it. Then the newest message of every stream up to `time` is told, in order of time, also of what
  /// was recomputed on the way; of numbers and texts all of the preroll, so that plots and lists do not begin
  /// with a jump.
  robotlink::Errors jump(robotlink::Instant time);

  /// The process by whose frames one steps: "<robot>/<process>"; at first the one that takes the images.
  /// False: there is none of that name.
  bool setStepProcess(const std::string& process);
  const std::string& stepProcess() const;
  /// When frame `count` frames on (negative: back) from now() of "<robot>/<process>" begins; the last or
  /// first if there are fewer.
  std::optional<robotlink::Instant> frameTime(const std::string& process, int count) const;
  std::optional<robotlink::Instant> timeOfFrame(const std::string& process, std::uint64_t frame) const;
  std::optional<robotlink::Instant> messageTime(const std::string& stream, int count) const;

  /// Both start the programs anew at now(), as a jump there does.
  robotlink::Errors choosePackages(
      const std::map<std::string, robotcontrol::ControlReplay::PackageSource>& packages);
  robotlink::Errors setLayout(const std::filesystem::path& file);
  void setOffset(const std::filesystem::path& log, robotlink::Duration offset);
  /// To a robot's program. A solution that is chosen stays so over jumps; keys do, too, and a color table.
  /// What it changed is seen at once after jump(now()).
  robotlink::Result<void> request(const robotcontrol::Request& request);

  /// Solutions among those of the options that change nothing, because their tasks do not run: a sentence
  /// each, with the reason.
  std::vector<std::string> unusedSolutions() const;
  /// What ReplayStatus says of logs, processes, packages, differences, tasks, begin, end, time, and frames of
  /// the step process.
  void describe(robotcontrol::ReplayStatus& status) const;
  const ReplayOptions& options() const;
  /// By the robot's name.
  std::map<std::string, ProgramOverrides> overrides() const;
  /// What of these the programs that run now cannot fulfill, a sentence each.
  std::vector<std::string> lostChoices() const;
  std::vector<std::string> robots() const;
  std::shared_ptr<const robotlink::RobotDescription> description(const std::string& robot) const;
  std::shared_ptr<const robotlink::FieldDescription> field() const;

 private:
  struct Implementation;
  explicit ReplayRun(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace app
