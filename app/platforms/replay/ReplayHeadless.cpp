// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayHeadless.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/PlatformAdapter.h"
#include "app/core/program/Abandoned.h"
#include "app/core/program/ShippedFiles.h"
#include "app/core/program/SolutionChoices.h"
#include "app/core/truth/ErrorFigures.h"
#include "app/platforms/replay/ReplayFeed.h"
#include "app/platforms/replay/ReplayRun.h"
#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/base/UnfinishedFile.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/process/Process.h"
#include "robotlink/session/QueueMessages.h"
#include "robotlink/truth/TruthErrors.h"

namespace app {
namespace {

using nlohmann::json;
using robotcontrol::ControlReplay;
using robotcontrol::ReplayStatus;
using robotlink::Errors;
using robotlink::Result;
using robotlink::TruthErrors;
using Kind = PlatformField::Kind;

constexpr std::string_view kLogPlatform = "log:";
constexpr std::string_view kAllPackages = "all";
constexpr char kOffset[] = "offset", kPackage[] = "package", kColorTable[] = "color-table",
               kPatience[] = "patience", kErrors[] = "errors";
/// Seconds; longer than any module takes on a machine that is busy.
constexpr double kUsualPatience = 30;
constexpr std::chrono::hours kNoEnd{24 * 365};

/// The log that is written during the replay, and its first error.
class HeadlessRecording {
 public:
  explicit HeadlessRecording(std::ostream& errors) : errors_(errors) {}

  /// Opens the file; without one, nothing is written.
  Result<void> open(const RecordOptions& record) {
    if (record.file.empty()) return {};
    logplayer::mcap::Writer::Options options;
    options.compression = record.compression == "none"  ? logplayer::mcap::Compression::kNone
                          : record.compression == "lz4" ? logplayer::mcap::Compression::kLz4
                                                        : logplayer::mcap::Compression::kZstd;
    options.library = std::string("robotctl ") + ROBOTCONTROL_VERSION;
    options.clock = &still_;  // the end of chunks must not depend on real time
    auto writer = logplayer::LogWriter::create(record.file, std::move(options));
    if (!writer) return tl::unexpected(writer.error());
    writer_ = std::move(*writer);
    unfinished_.emplace(record.file);
    return {};
  }

  ReplayRun::Listeners listeners() {
    ReplayRun::Listeners listeners;
    listeners.logged = [this](const std::vector<robotlink::StreamMessage>& messages) {
      write(messages);
      compare(messages);
    };
    listeners.queue = [this](const std::string& robot, const auto& queue) {
      if (errorsWanted_) truthErrors_.add(robot, *queue);
      write(messagesOf(robot, *queue, {}, robotlink::QueueReader::kRecorder).messages);
    };
    listeners.hosting = [this](const std::string&, robotlink::Instant,
                               const robotcontrol::HostingStatus& status) {
      if (!status.text().empty()) errors_ << status.text() << "\n" << status.stack();
      isStuck_ = isStuck_ || status.state() == robotcontrol::HostingStatus::NOT_ANSWERING;
      failed_ = failed_ || isStuck_ || status.state() == robotcontrol::HostingStatus::ENDED;
    };
    listeners.trouble = [this](const std::string& robot, const robotlink::Process& process,
                               const std::string& text) {
      errors_ << robot << ": " << text << "\n";
      failed_ = failed_ || !process.failure().empty();
    };
    return listeners;
  }

  /// From now on what is played is compared with the truth that the log has.
  void measureErrors(std::shared_ptr<const robotlink::FieldDescription> field) {
    errorsWanted_ = true;
    truthErrors_.setField(std::move(field));
  }
  /// Null if they are not measured.
  const TruthErrors* truthErrors() const { return errorsWanted_ ? &truthErrors_ : nullptr; }

  Result<void> close() {
    if (writer_ && result_) result_ = writer_->container().close();
    unfinished_.reset();
    return result_;
  }
  bool good() const { return result_.has_value(); }
  bool processFailed() const { return failed_; }
  /// Whether a module does not return.
  bool isStuck() const { return isStuck_; }

 private:
  void write(const std::vector<robotlink::StreamMessage>& messages) {
    if (writer_ && result_) result_ = writer_->write(messages);
  }

  void compare(const std::vector<robotlink::StreamMessage>& messages) {
    if (!errorsWanted_) return;
    for (const robotlink::StreamMessage& message : messages) {
      const std::size_t slash = message.path.find('/');
      if (slash != std::string::npos)
        truthErrors_.add(message.path.substr(0, slash), message.path.substr(slash + 1), message.time,
                         message.value);
    }
  }

  std::ostream& errors_;
  TruthErrors truthErrors_;
  bool errorsWanted_ = false;
  robotlink::ManualClock still_;
  std::unique_ptr<logplayer::LogWriter> writer_;
  std::optional<robotlink::UnfinishedFile> unfinished_;
  Result<void> result_;
  bool failed_ = false, isStuck_ = false;
};

/// The run and what it writes to. Modules that never return keep it.
struct HeadlessReplay {
  explicit HeadlessReplay(std::ostream& errors) : recording(errors) {}

  HeadlessRecording recording;
  std::unique_ptr<ReplayRun> run;
};

/// Ends a run, whatever its modules do.
class HeadlessReplayEnd {
 public:
  explicit HeadlessReplayEnd(std::shared_ptr<HeadlessReplay> replay) : replay_(std::move(replay)) {}
  ~HeadlessReplayEnd() {
    if (!replay_->run) return;
    replay_->run->stop();
    if (replay_->run->hasEnded()) return;
    abandon(replay_, [run = replay_->run.get()] { return run->hasEnded(); });
  }
  HeadlessReplayEnd(const HeadlessReplayEnd&) = delete;
  HeadlessReplayEnd& operator=(const HeadlessReplayEnd&) = delete;

 private:
  const std::shared_ptr<HeadlessReplay> replay_;
};

/// Whether a text names logs: "log:FILE", or a file that no other adapter opens.
bool namesLogs(const std::string& platform) {
  if (platform.starts_with(kLogPlatform)) return true;
  const PlatformAdapter* adapter = adapterFor(platform);
  if (adapter == nullptr || adapter->name != std::string_view(ReplayFeed::kAdapter)) return false;
  std::error_code ignored;
  return robotlink::fileSuffix(platform) == ".mcap" || std::filesystem::is_regular_file(platform, ignored);
}

/// Adds the logs that a text like "log:a.mcap,log:b.mcap" or "a.mcap" names. Returns what is wrong with it;
/// empty if nothing is.
std::string addLogs(const HeadlessChoices& choices, ReplayOptions& options) {
  std::vector<FormValue> offsets;
  if (const auto given = choices.options.lists.find(kOffset); given != choices.options.lists.end())
    offsets = given->second;
  for (const FormValue& offset : offsets) {
    if (!(std::abs(std::get<double>(offset)) <= robotlink::kMaxLogOffset))
      return "--offset takes a number of seconds, and at most 100 years";
  }
  const bool isPath = !choices.platform.starts_with(kLogPlatform);
  const std::string text = isPath ? std::string(kLogPlatform) + choices.platform : choices.platform;
  std::string_view rest = text;
  while (rest.starts_with(kLogPlatform)) {
    rest.remove_prefix(kLogPlatform.size());
    const std::size_t end = isPath ? rest.size() : std::min(rest.find(",log:"), rest.size());
    if (end == 0) return "--platform names no file after 'log:'";
    ReplayLog log{std::string(rest.substr(0, end))};
    if (options.logs.size() < offsets.size()) {
      log.offset = robotlink::fromSeconds(std::get<double>(offsets[options.logs.size()]));
      log.offsetChosen = true;
    }
    options.logs.push_back(std::move(log));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return offsets.size() > options.logs.size() ? "there are more --offset than logs" : "";
}

/// Adds the chosen source of a package, or of all of them; false if the text is no such choice.
bool addPackage(const std::string& text, ReplayOptions& options) {
  const auto choice = assignmentOf(text);
  if (!choice || (choice->second != "logged" && choice->second != "recomputed")) return false;
  const auto& [package, name] = *choice;
  const auto source = name == "logged" ? ControlReplay::AS_LOGGED : ControlReplay::RECOMPUTED;
  if (package == kAllPackages) {
    options.recomputeAll = source == ControlReplay::RECOMPUTED;
    return true;
  }
  // Packages have names like "models/ball"; a prefix selects a single robot.
  const bool ofOneRobot = std::ranges::count(package, '/') > 1;
  options.packages[ofOneRobot ? package : "*/" + package] = source;
  return true;
}

json differenceJson(const ReplayStatus::Difference& difference) {
  json row{{"package", difference.package()},
           {"compared", difference.compared()},
           {"different", difference.different()},
           {"only_logged", difference.only_logged()},
           {"only_recomputed", difference.only_recomputed()}};
  const bool differs = difference.different() + difference.only_logged() + difference.only_recomputed() > 0;
  row["first_s"] = differs ? json(1e-9 * static_cast<double>(difference.first_time())) : json();
  if (difference.largest() > 0) {
    row["largest"] = {{"field", difference.largest_field()},
                      {"difference", difference.largest()},
                      {"time_s", 1e-9 * static_cast<double>(difference.largest_time())}};
  }
  return row;
}

json summaryOf(const ReplayStatus& status, std::uint64_t instants, double realSeconds) {
  const double seconds = 1e-9 * static_cast<double>(status.end() - status.begin());
  json summary;
  for (const auto& log : status.logs()) {
    summary["logs"].push_back({{"path", log.path()},
                               {"robots", log.robots()},
                               {"offset_s", 1e-9 * static_cast<double>(log.offset())},
                               {"damage", log.damage()}});
  }
  summary["begin_s"] = 1e-9 * static_cast<double>(status.begin());
  summary["seconds"] = seconds;
  summary["instants"] = instants;
  summary["real_seconds"] = realSeconds;
  summary["real_time_factor"] = realSeconds > 0 ? seconds / realSeconds : 0;
  summary["packages"] = json::array();
  for (const auto& package : status.packages()) {
    const bool logged = package.source() == ControlReplay::AS_LOGGED;
    summary["packages"].push_back({{"package", package.package()},
                                   {"source", logged                    ? json("logged")
                                              : package.can_recompute() ? json("recomputed")
                                                                        : json()},
                                   {"why_not", package.why_not()}});
  }
  summary["differences"] = json::array();
  for (const auto& difference : status.differences())
    summary["differences"].push_back(differenceJson(difference));
  summary["unavailable_tasks"] = status.unavailable_tasks();
  return summary;
}

void printDifference(std::ostream& out, const ReplayStatus::Difference& difference) {
  out << difference.package() << ": " << difference.different() << " of " << difference.compared()
      << " differ";
  if (difference.only_logged() > 0) out << ", " << difference.only_logged() << " only logged";
  if (difference.only_recomputed() > 0) out << ", " << difference.only_recomputed() << " only recomputed";
  if (difference.largest() > 0) {
    const double largest = difference.largest();
    out << fmt::format("; largest: {} by {} at {:.3f} s", difference.largest_field(),
                       largest < 1000 ? fmt::format("{:.4g}", largest) : fmt::format("{:.0f}", largest),
                       1e-9 * static_cast<double>(difference.largest_time()));
  }
  out << "\n";
}

std::string summaryText(const ReplayStatus& status, const json& summary) {
  std::ostringstream out;
  out << fmt::format("{:.1f} s in {:.1f} s ({:.1f} times real time), {} instants\n",
                     summary["seconds"].get<double>(), summary["real_seconds"].get<double>(),
                     summary["real_time_factor"].get<double>(), summary["instants"].get<std::uint64_t>());
  for (const auto& log : status.logs()) {
    if (!log.damage().empty()) out << log.path() << ": " << log.damage() << "\n";
  }
  for (const auto& task : status.unavailable_tasks()) out << "not available: " << task << "\n";
  for (const auto& package : summary["packages"]) {
    if (package["source"] == "recomputed")
      out << "recomputed: " << package["package"].get<std::string>() << "\n";
  }
  for (const auto& difference : status.differences()) printDifference(out, difference);
  if (summary.contains("errors")) out << errorsText(summary["errors"]);
  return out.str();
}

bool recomputesAnything(const ReplayRun& run) {
  ReplayStatus status;
  run.describe(status);
  return std::ranges::any_of(status.packages(), [](const auto& package) {
    return package.source() == ControlReplay::RECOMPUTED && package.can_recompute();
  });
}

/// Reports options that have no effect, and what would have one.
void warnOfUnusedChoices(const ReplayRun& run, std::ostream& errors) {
  if (run.robots().empty()) {
    errors << "warning: the log contains no known robot, so no program runs on it; 'robotctl log info' shows "
              "its contents\n";
    return;
  }
  std::vector<std::string> unused = run.unusedSolutions();
  if ((!run.options().colorTable.empty() || !run.options().layout.empty()) && !recomputesAnything(run)) {
    unused.emplace_back(
        "nothing is recomputed, so --color-table and --layout have no effect; add --package "
        "PACKAGE=recomputed");
  }
  for (const std::string& sentence : unused) errors << "warning: " << sentence << "\n";
  if (unused.empty()) return;
  errors
      << "warning: a task only runs if its output is recomputed: --package PACKAGE=recomputed, or --package "
         "all=recomputed\n";
}

/// Steps to the end; how many instants there were. A signal ends it before.
std::uint64_t playLog(ReplayRun& run, const HeadlessRecording& recording, const HeadlessConsole& console) {
  std::uint64_t instants = 1;
  const double length = robotlink::seconds(run.end() - run.begin());
  while (recording.good() && !recording.isStuck() && run.step()) {
    ++instants;
    if (!console.progress(length > 0 ? robotlink::seconds(run.now() - run.begin()) / length : 1)) break;
  }
  return instants;
}

/// Replaces "-" by a copy of standard input.
Result<void> readInputs(ReplayOptions& options, const HeadlessConsole& console) {
  for (ReplayLog& log : options.logs) {
    auto file = console.input(log.file.string());
    if (!file) return tl::unexpected(file.error());
    log.file = std::move(*file);
  }
  return {};
}

ExitStatus statusOf(const HeadlessRecording& recording, const ReplayStatus& status, bool interrupted) {
  if (recording.processFailed() || interrupted) return kFailed;
  const bool damaged =
      std::ranges::any_of(status.logs(), [](const auto& log) { return !log.damage().empty(); });
  return damaged ? kDoneWithLosses : kDone;
}

/// The purposes of a replay.
struct HeadlessAims {
  RecordOptions record;
  std::vector<robotlink::ShadowName> shadows;
  bool errors = false;
};

tl::expected<HeadlessSummary, Errors> replay(ReplayOptions options, const HeadlessAims& aims,
                                             const HeadlessConsole& console) {
  if (const auto read = readInputs(options, console); !read) return tl::unexpected(Errors{read.error()});
  options.progress = console.progress;
  const auto both = std::make_shared<HeadlessReplay>(console.errors);
  HeadlessRecording& recording = both->recording;
  auto made = ReplayRun::create(std::move(options), recording.listeners());
  if (!made) return tl::unexpected(made.error());
  both->run = std::move(*made);
  ReplayRun& run = *both->run;
  const HeadlessReplayEnd end(both);
  warnOfUnusedChoices(run, console.errors);
  if (const auto done = run.runShadows(aims.shadows); !done) return tl::unexpected(Errors{done.error()});
  if (aims.errors) recording.measureErrors(run.field());
  if (const auto opened = recording.open(aims.record); !opened) return tl::unexpected(Errors{opened.error()});
  const auto start = std::chrono::steady_clock::now();
  // A jump to the beginning publishes the latched messages from before the log's first instant.
  if (Errors errors = run.jump(run.begin()); !errors.empty()) return tl::unexpected(std::move(errors));
  const std::uint64_t instants = playLog(run, recording, console);
  if (recording.isStuck())
    console.errors << "The replay ends here, because waiting would make its results depend on timing; "
                      "--patience allows more time.\n";
  const double real = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (const auto closed = recording.close(); !closed) return tl::unexpected(Errors{closed.error()});
  ReplayStatus status;
  run.describe(status);
  json summary = summaryOf(status, instants, real);
  if (recording.truthErrors() != nullptr) summary["errors"] = errorFigures(*recording.truthErrors());
  return HeadlessSummary{jsonOutput(summary), summaryText(status, summary),
                         statusOf(recording, status, console.interrupted())};
}

Result<ReplayOptions> replayOptionsOf(const HeadlessChoices& choices) {
  ReplayOptions options;
  if (choices.preset)
    return robotlink::failure(
        "usage",
        "--preset is for simulations and robots; the program on a log uses what was logged, or --solution");
  if (const std::string wrong = addLogs(choices, options); !wrong.empty())
    return robotlink::failure("usage", wrong);
  if (const auto packages = choices.options.lists.find(kPackage); packages != choices.options.lists.end()) {
    for (const FormValue& value : packages->second) {
      const auto& text = std::get<std::string>(value);
      if (!addPackage(text, options))
        return robotlink::failure("usage",
                                  "--package takes PACKAGE=logged or PACKAGE=recomputed, not '" + text + "'");
    }
  }
  if (!choices.layout.empty()) options.layout = layoutNamed(choices.layout);
  options.solutions = choices.solutions;
  options.colorTable = textOf(choices.options.values, kColorTable);
  options.hosting.ownProcesses = flagOf(choices.options.values, ownProcessField().name);
  return options;
}

Result<HeadlessPlatform::Run> prepareReplay(const HeadlessChoices& choices) {
  auto options = replayOptionsOf(choices);
  if (!options) return tl::unexpected(options.error());
  const bool errors = flagOf(choices.options.values, kErrors);
  options->publishAllPackages = errors || !choices.record.file.empty();
  const double patience = numberOf(choices.options.values, kPatience, kUsualPatience);
  options->patience = std::chrono::milliseconds(std::llround(1000 * patience));
  // A program in its own process may be halted in a debugger for any time.
  options->own.patience = patience > 0 ? options->patience : kNoEnd;
  const HeadlessAims aims{choices.record, choices.shadows, errors};
  return [options = std::move(*options), aims](const HeadlessConsole& console) {
    return replay(options, aims, console);
  };
}

Result<HeadlessServing> prepareServedReplay(const HeadlessChoices& choices, const HeadlessConsole& console) {
  auto options = replayOptionsOf(choices);
  if (!options) return tl::unexpected(options.error());
  if (!choices.shadows.empty())
    return robotlink::failure("usage",
                              "--shadow is not possible with --listen and a log; clients "
                              "can switch shadows on");
  if (auto read = readInputs(*options, console); !read) return tl::unexpected(read.error());
  return HeadlessServing{ReplayFeed::opening(std::move(*options))};
}

}  // namespace

HeadlessPlatform headlessReplay() {
  return {
      .help = "a log file (log:- is standard input), or several logs: log:FILE,log:FILE...",
      .usage = "a log file or log:FILE,log:FILE...",
      .runs = namesLogs,
      .options = {{.name = kOffset,
                   .kind = Kind::kNumber,
                   .help = "Seconds added to the times of a log; one for each, in their order",
                   .initial = 0.0,
                   .noun = "offset",
                   .decimals = 3,
                   .option = "--offset",
                   .several = true},
                  {.name = kPackage,
                   .help = "PACKAGE=logged or PACKAGE=recomputed (percepts/ball=recomputed for all robots, "
                           "red1/percepts/ball=recomputed for one, all=recomputed for whatever can be); else "
                           "everything logged is used as logged",
                   .option = "--package",
                   .several = true},
                  {.name = kColorTable,
                   .help = "A color table (.c64) instead of the log's",
                   .option = "--color-table"},
                  {.name = kErrors,
                   .kind = Kind::kFlag,
                   .help =
                       "Adds the errors of percepts and models against the ground truth, if the log has it",
                   .initial = false,
                   .option = "--errors"},
                  {.name = kPatience,
                   .kind = Kind::kNumber,
                   .help = "Seconds after which a module that does not return is reported, and the command "
                           "ends (30); 0: never. With --listen the log continues without it, after 2 s",
                   .initial = kUsualPatience,
                   .noun = "patience",
                   .max = 1e6,
                   .decimals = 3,
                   .option = "--patience"},
                  ownProcessField()},
      .optionsAreMine = "--offset, --package, --color-table and --patience are for logs",
      .prepare = prepareReplay,
      .prepareServing = prepareServedReplay};
}

}  // namespace app
