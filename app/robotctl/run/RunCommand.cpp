// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl run`: robot programs on logs; see RunRobotCommand.h for real robots.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/core/program/ShippedFiles.h"
#include "app/core/replay/ReplayRun.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/JsonOutput.h"
#include "app/robotctl/RobotName.h"
#include "app/robotctl/log/LogInput.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "app/robotctl/run/RunRobotCommand.h"
#include "logplayer/base/LogWriter.h"
#include "robotlink/base/UnfinishedFile.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/process/Process.h"
#include "robotlink/session/QueueMessages.h"

namespace app {
namespace {

using nlohmann::json;
using robotcontrol::ControlReplay;
using robotcontrol::ReplayStatus;

constexpr std::string_view kLogPlatform = "log:";
constexpr std::string_view kAllPackages = "all";

struct RunArguments {
  std::string platform;
  std::string layout;
  std::string record;
  std::string colorTable;
  std::string compression = "zstd";
  std::vector<std::string> solutions;
  std::vector<std::string> packages;
  std::vector<double> offsets;
  bool asJson = false;
  RunRobotArguments robot;
};

/// The log that is written during the replay, and its first error.
class Recording {
 public:
  /// Without a path nothing is written.
  robotlink::Result<void> open(const std::string& path, const std::string& compression) {
    if (path.empty()) return {};
    logplayer::mcap::Writer::Options options;
    options.compression = compression == "none"  ? logplayer::mcap::Compression::kNone
                          : compression == "lz4" ? logplayer::mcap::Compression::kLz4
                                                 : logplayer::mcap::Compression::kZstd;
    options.library = std::string("robotctl ") + ROBOTCONTROL_VERSION;
    options.clock = &still_;  // the end of chunks must not depend on real time
    auto writer = logplayer::LogWriter::create(path, std::move(options));
    if (!writer) return tl::unexpected(writer.error());
    writer_ = std::move(*writer);
    unfinished_.emplace(path);
    return {};
  }

  ReplayRun::Listeners listeners() {
    ReplayRun::Listeners listeners;
    listeners.logged = [this](const std::vector<robotlink::StreamMessage>& messages) { write(messages); };
    listeners.queue = [this](const std::string& robot, const auto& queue) {
      write(messagesOf(robot, *queue, {}, robotlink::QueueReader::kRecorder).messages);
    };
    listeners.trouble = [this](const std::string& robot, const robotlink::Process& process,
                               const std::string& text) {
      std::cerr << robot << ": " << text << "\n";
      failed_ = failed_ || !process.failure().empty();
    };
    return listeners;
  }

  robotlink::Result<void> close() {
    if (writer_ && result_) result_ = writer_->container().close();
    unfinished_.reset();
    return result_;
  }
  bool good() const { return result_.has_value(); }
  bool processFailed() const { return failed_; }

 private:
  void write(const std::vector<robotlink::StreamMessage>& messages) {
    if (writer_ && result_) result_ = writer_->write(messages);
  }

  robotlink::ManualClock still_;
  std::unique_ptr<logplayer::LogWriter> writer_;
  std::optional<robotlink::UnfinishedFile> unfinished_;
  robotlink::Result<void> result_;
  bool failed_ = false;
};

int usage(const std::string& text) {
  std::cerr << "robotctl run: " << text << "\n";
  return kUsage;
}

/// Splits "a=b"; returns false if there is no "=".
bool split(const std::string& text, std::pair<std::string, std::string>& halves) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) return false;
  halves = {text.substr(0, equals), text.substr(equals + 1)};
  return true;
}

/// Returns an error message, or an empty text.
std::string takeLogs(const RunArguments& arguments, ReplayOptions& options) {
  if (!arguments.platform.starts_with(kLogPlatform)) {
    return "--platform is log:FILE or log:FILE,log:FILE..., or a robot's address: tcp://HOST:PORT or "
           "serial://DEVICE?baud=RATE; 'robotctl sim' runs simulated robots";
  }
  std::string_view rest = arguments.platform;
  while (rest.starts_with(kLogPlatform)) {
    rest.remove_prefix(kLogPlatform.size());
    const std::size_t end = std::min(rest.find(",log:"), rest.size());
    if (end == 0) return "--platform names no file after 'log:'";
    ReplayLog log{std::string(rest.substr(0, end))};
    if (options.logs.size() < arguments.offsets.size()) {
      log.offset = robotlink::fromSeconds(arguments.offsets[options.logs.size()]);
      log.offsetChosen = true;
    }
    options.logs.push_back(std::move(log));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return arguments.offsets.size() > options.logs.size() ? "there are more --offset than logs" : "";
}

std::string takeChoices(const RunArguments& arguments, ReplayOptions& options) {
  std::pair<std::string, std::string> halves;
  for (const std::string& text : arguments.solutions) {
    if (!split(text, halves)) return "--solution takes TASK=SOLUTION, not '" + text + "'";
    options.solutions[halves.first] = halves.second;
  }
  for (const std::string& text : arguments.packages) {
    const bool good = split(text, halves) && (halves.second == "logged" || halves.second == "recomputed");
    if (!good) return "--package takes PACKAGE=logged or PACKAGE=recomputed, not '" + text + "'";
    const auto source = halves.second == "logged" ? ControlReplay::AS_LOGGED : ControlReplay::RECOMPUTED;
    if (halves.first == kAllPackages) {
      options.recomputeAll = source == ControlReplay::RECOMPUTED;
      continue;
    }
    // Packages have names like "models/ball"; a prefix selects a single robot.
    const bool ofOneRobot = std::count(halves.first.begin(), halves.first.end(), '/') > 1;
    options.packages[ofOneRobot ? halves.first : "*/" + halves.first] = source;
  }
  return {};
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

void printDifference(const ReplayStatus::Difference& difference) {
  std::cout << difference.package() << ": " << difference.different() << " of " << difference.compared()
            << " differ";
  if (difference.only_logged() > 0) std::cout << ", " << difference.only_logged() << " only logged";
  if (difference.only_recomputed() > 0)
    std::cout << ", " << difference.only_recomputed() << " only recomputed";
  if (difference.largest() > 0) {
    const double largest = difference.largest();
    std::cout << fmt::format("; largest: {} by {} at {:.3f} s", difference.largest_field(),
                             largest < 1000 ? fmt::format("{:.4g}", largest) : fmt::format("{:.0f}", largest),
                             1e-9 * static_cast<double>(difference.largest_time()));
  }
  std::cout << "\n";
}

void printSummary(const ReplayStatus& status, const json& summary) {
  std::cout << fmt::format("{:.1f} s in {:.1f} s ({:.1f} times real time), {} instants\n",
                           summary["seconds"].get<double>(), summary["real_seconds"].get<double>(),
                           summary["real_time_factor"].get<double>(),
                           summary["instants"].get<std::uint64_t>());
  for (const auto& log : status.logs()) {
    if (!log.damage().empty()) std::cout << log.path() << ": " << log.damage() << "\n";
  }
  for (const auto& task : status.unavailable_tasks()) std::cout << "not available: " << task << "\n";
  for (const auto& package : summary["packages"]) {
    if (package["source"] == "recomputed")
      std::cout << "recomputed: " << package["package"].get<std::string>() << "\n";
  }
  for (const auto& difference : status.differences()) printDifference(difference);
}

bool recomputesAnything(const ReplayRun& run) {
  ReplayStatus status;
  run.describe(status);
  return std::any_of(status.packages().begin(), status.packages().end(), [](const auto& package) {
    return package.source() == ControlReplay::RECOMPUTED && package.can_recompute();
  });
}

/// Reports options to stderr that have no effect, and what would have one.
void warnOfUnusedChoices(const ReplayRun& run, const RunArguments& arguments) {
  if (run.robots().empty()) {
    std::cerr << "warning: the log names no robot known here, so nothing runs on it; 'robotctl log info' "
                 "shows what it holds\n";
    return;
  }
  std::vector<std::string> unused = run.unusedSolutions();
  if ((!arguments.colorTable.empty() || !arguments.layout.empty()) && !recomputesAnything(run)) {
    unused.emplace_back("nothing is recomputed, so --color-table and --layout change nothing");
  }
  for (const std::string& sentence : unused) std::cerr << "warning: " << sentence << "\n";
  if (unused.empty()) return;
  std::cerr
      << "warning: a task runs if what it yields is recomputed: --package PACKAGE=recomputed, or --package "
         "all=recomputed\n";
}

/// Steps to the end; how many instants there were. A signal ends it before.
std::uint64_t playLog(ReplayRun& run, const Recording& recording, TerminalProgress& progress) {
  std::uint64_t instants = 1;
  const auto show = progress.function();
  const double length = robotlink::seconds(run.end() - run.begin());
  while (recording.good() && run.step()) {
    ++instants;
    if (!show(length > 0 ? robotlink::seconds(run.now() - run.begin()) / length : 1)) break;
  }
  return instants;
}

int replay(const RunArguments& arguments, ReplayOptions options) {
  TerminalProgress progress;
  options.progress = progress.function();
  Recording recording;
  auto run = ReplayRun::create(std::move(options), recording.listeners());
  if (!run) return printErrors(run.error());
  warnOfUnusedChoices(**run, arguments);
  if (auto opened = recording.open(arguments.record, arguments.compression); !opened) {
    return printErrors({opened.error()});
  }
  const auto start = std::chrono::steady_clock::now();
  // A jump to the beginning publishes the latched messages from before the log's first instant.
  if (const auto errors = (*run)->jump((*run)->begin()); !errors.empty()) return printErrors(errors);
  const std::uint64_t instants = playLog(**run, recording, progress);
  progress.erase();
  const double real = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (auto closed = recording.close(); !closed) return printErrors({closed.error()});
  ReplayStatus status;
  (*run)->describe(status);
  const json summary = summaryOf(status, instants, real);
  if (arguments.asJson) {
    std::cout << jsonOutput(summary);
  } else {
    printSummary(status, summary);
  }
  if (recording.processFailed() || Interrupt::noted()) return kFailed;
  const bool damaged = std::any_of(status.logs().begin(), status.logs().end(),
                                   [](const auto& log) { return !log.damage().empty(); });
  return damaged ? kDoneWithLosses : kDone;
}

int runOnRobot(const RunArguments& arguments) {
  RunRobotArguments robot = arguments.robot;
  if (!arguments.offsets.empty() || !arguments.packages.empty() || !arguments.colorTable.empty()) {
    return usage("--offset, --package and --color-table are for logs");
  }
  ReplayOptions choices;
  if (const std::string wrong = takeChoices(arguments, choices); !wrong.empty()) return usage(wrong);
  robot.url = arguments.platform;
  robot.layout = arguments.layout;
  robot.solutions = choices.solutions;
  robot.asJson = arguments.asJson;
  robot.record.file = arguments.record;
  robot.record.compression = arguments.compression;
  return runRobot(robot);
}

/// Replaces "-" by a copy of standard input, which is removed with `inputs`.
robotlink::Result<void> readInputs(ReplayOptions& options, std::vector<LogInput>& inputs) {
  for (ReplayLog& log : options.logs) {
    auto input = LogInput::of(log.file.string());
    if (!input) return tl::unexpected(input.error());
    log.file = inputs.emplace_back(std::move(*input)).path();
  }
  return {};
}

int replay(const RunArguments& arguments) {
  if (isRobotAddress(arguments.platform)) return runOnRobot(arguments);
  ReplayOptions options;
  if (const std::string wrong = takeLogs(arguments, options); !wrong.empty()) return usage(wrong);
  if (const std::string wrong = takeChoices(arguments, options); !wrong.empty()) return usage(wrong);
  if (!arguments.layout.empty()) options.layout = layoutNamed(arguments.layout);
  options.colorTable = arguments.colorTable;
  options.publishAllPackages = !arguments.record.empty();
  std::vector<LogInput> inputs;
  if (const auto read = readInputs(options, inputs); !read) return printErrors({read.error()});
  return replay(arguments, std::move(options));
}

}  // namespace

void addRunCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command =
      app.add_subcommand("run", "Runs robot programs on logs, as fast as possible, or on a real robot");
  command
      ->add_option("--platform", arguments->platform,
                   "log:FILE (log:- is standard input), or several logs: log:FILE,log:FILE...; or a Pioneer: "
                   "tcp://HOST[:PORT], "
                   "serial://DEVICE[?baud=RATE]")
      ->required();
  command
      ->add_option("--offset", arguments->offsets,
                   "Seconds added to the times of a log; one for each, in their order")
      ->check(CLI::Range(-robotlink::kMaxLogOffset, robotlink::kMaxLogOffset).description(""));
  command->add_option(
      "--layout", arguments->layout,
      "A process layout: a file, or the name of a shipped one; else that of the log or of the robot");
  command->add_option("--solution", arguments->solutions, "TASK=SOLUTION instead of the layout's");
  command->add_option("--package", arguments->packages,
                      "PACKAGE=logged or PACKAGE=recomputed (percepts/ball=recomputed for all robots, "
                      "red1/percepts/ball=recomputed for one, all=recomputed for whatever can be); else "
                      "everything logged is used as logged");
  command->add_option("--color-table", arguments->colorTable, "A color table (.c64) instead of the log's");
  command->add_option(
      "--record", arguments->record,
      "A new log (MCAP) of what was logged and what was recomputed, or of what happened on the robot");
  command->add_option("--compression", arguments->compression, "Compression of that log: none, lz4 or zstd")
      ->check(CLI::IsMember({"none", "lz4", "zstd"}))
      ->capture_default_str();
  command->add_flag("--json", arguments->asJson, "Prints the summary as one JSON object");
  RunRobotArguments& robot = arguments->robot;
  command->add_option("--map", robot.map, "Robots: a map (.map) of where it drives");
  command->add_option("--robot", robot.robot, "Robots: its name")->check(robotName)->capture_default_str();
  command->add_option("--seconds", robot.seconds, "Robots: how long it runs (until Ctrl-C)")
      ->check(CLI::Range(0.0, 1e6));
  command->add_flag("--motors", robot.motorsOn, "Robots: switches the motors on as soon as it is connected");
  command->add_flag("--texts", robot.texts, "Robots: prints the program's text messages on stderr");
  command->callback([arguments, &status] { status = withResources([&] { return replay(*arguments); }); });
}

}  // namespace app
