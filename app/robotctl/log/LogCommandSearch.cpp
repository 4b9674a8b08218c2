// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl log search`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/core/platform/JsonOutput.h"
#include "app/core/program/ShippedFiles.h"
#include "app/core/program/SolutionChoices.h"
#include "app/platforms/replay/ReplayComputation.h"
#include "app/robotctl/log/LogInput.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/base/LogDates.h"
#include "logplayer/base/Plural.h"
#include "logplayer/export/TextLine.h"
#include "logplayer/search/LogSearch.h"

namespace app {
namespace {

using logplayer::SearchHit;
using nlohmann::json;
using robotlink::Instant;

struct SearchArguments {
  std::string file, expression;
  TimeRangeOptions range;
  std::uint64_t limit = 10'000;
  bool asJson = false;
  /// For programs that compute what the log lacks.
  std::string layout;
  std::vector<std::string> solutions;
};

/// The same limit as in `robotctl run`: longer than any module takes on a busy machine.
constexpr std::chrono::seconds kSearchPatience{30};

std::string listOf(const std::set<std::string>& streams) {
  return fmt::format("{}", fmt::join(streams, ", "));
}

/// Has the robots' programs compute what the log lacks, and says so. Fails if a solution is no TASK=SOLUTION.
robotlink::Result<logplayer::ComputedStreams> computedStreams(const SearchArguments& arguments,
                                                              TerminalProgress& progress) {
  auto solutions = solutionsOf(arguments.solutions);
  if (!solutions) return tl::unexpected(solutions.error());
  ComputationOptions options{.solutions = std::move(*solutions), .patience = kSearchPatience};
  if (!arguments.layout.empty()) options.layout = layoutNamed(arguments.layout);
  return logplayer::ComputedStreams{
      computationByReplay(std::move(options)), [&](const auto& streams) {
        progress.erase();
        std::cerr << "not in the log, so the robot's program computes it: " << listOf(streams) << "\n";
      }};
}

std::string beginText(Instant time) {
  return logplayer::isDate(time) ? logplayer::dateText(time)
                                 : fmt::format("{:12.6f} s", robotlink::seconds(time));
}

std::string lineOf(const SearchHit& hit, Instant begin) {
  if (hit.text) {
    if (const auto* text = dynamic_cast<const foxglove::Log*>(hit.text->value.get()))
      return logplayer::textLine(*hit.text, *text);
  }
  const std::string length = hit.until
                                 ? fmt::format("for {:.3f} s", robotlink::seconds(*hit.until - hit.from))
                                 : std::string("to the end");
  return fmt::format("{}  {:>10.3f} s from the start  {}{}\n", beginText(hit.from),
                     robotlink::seconds(hit.from - begin), hit.robot.empty() ? "" : hit.robot + "  ", length);
}

json objectOf(const SearchHit& hit, Instant begin) {
  json object{{"time", robotlink::seconds(hit.from)}, {"from_start", robotlink::seconds(hit.from - begin)}};
  if (!hit.robot.empty()) object["robot"] = hit.robot;
  if (hit.until) object["until"] = robotlink::seconds(*hit.until);
  if (hit.text) {
    if (const auto* text = dynamic_cast<const foxglove::Log*>(hit.text->value.get())) {
      object["source"] = text->name();
      object["message"] = text->message();
    }
  }
  return object;
}

int printWrongUsage(const robotlink::Error& error) {
  std::cerr << "robotctl log search: " << error.text << "\n";
  return kUsage;
}

/// An expression that is wrong is wrong usage.
int printSearchError(robotlink::Error error) {
  const bool isExpression = error.id.starts_with("expression.") || error.id.starts_with("path.");
  if (isExpression) error.where = {"expression", 1, error.where.column};
  const int status = printErrors({error});
  return isExpression ? kUsage : status;
}

/// Prints what was found, `hits` for --json only, and what could not be searched.
int printFound(logplayer::SearchReport report, const SearchArguments& arguments, json hits) {
  if (report.hits >= arguments.limit) {
    report.losses.push_back("only the first " + logplayer::plural(arguments.limit, "hit") +
                            " hits were searched for; --limit allows more");
  }
  if (arguments.asJson) {
    std::cout << jsonOutput(json{{"file", arguments.file},
                                 {"expression", arguments.expression},
                                 {"computed", report.computed},
                                 {"hits", std::move(hits)},
                                 {"losses", report.losses}});
  } else {
    const bool isComputed = !report.computed.empty();
    std::cout << logplayer::plural(report.hits, "hit")
              << (isComputed ? ", computed by the program: " + listOf(report.computed) : "") << "\n";
  }
  return printLosses(report.losses);
}

int searchIn(const SearchArguments& arguments) {
  const auto input = LogInput::of(arguments.file);
  if (!input) return printErrors({input.error()});
  const auto range = arguments.range.of(input->path());
  if (!range) return printRangeError(range.error());
  TerminalProgress progress;
  const auto computed = computedStreams(arguments, progress);
  if (!computed) return printWrongUsage(computed.error());
  logplayer::LogFile::Options opening;
  opening.progress = progress.function();
  const auto log = logplayer::LogFile::open(input->path(), opening);
  if (!log) return printErrors({log.error()});

  const Instant begin = (*log)->begin();
  json hits = json::array();
  std::uint64_t shown = 0;
  const auto found = [&](const SearchHit& hit) {
    if (arguments.asJson) {
      hits.push_back(objectOf(hit, begin));
    } else {
      progress.erase();
      std::cout << lineOf(hit, begin);
    }
    return ++shown < arguments.limit && std::cout.good();
  };
  auto report = logplayer::searchLog(*log, arguments.expression,
                                     {range->from, range->to, false, progress.function()}, found, *computed);
  progress.erase();
  if (!report) return printSearchError(report.error());
  return printFound(std::move(*report), arguments, std::move(hits));
}

}  // namespace

void addLogSearchCommand(CLI::App& log, int& status) {
  auto arguments = std::make_shared<SearchArguments>();
  CLI::App* command = log.add_subcommand(
      "search",
      "Finds where a condition becomes true, without playing the log; the programs of its robots compute "
      "what the log lacks");
  command->add_option("file", arguments->file, "A log file (MCAP or an older format); - is standard input")
      ->required();
  command
      ->add_option("expression", arguments->expression,
                   "The condition, over values of streams: 'models/ball.position.x > 1', "
                   "'log.message =~ \"(?i)lost\"'")
      ->required();
  command->add_option("--layout", arguments->layout,
                      "The process layout of the programs that compute what the log lacks: a file, or the "
                      "name of a shipped one; else that of the log or of the robot");
  command->add_option("--solution", arguments->solutions, "TASK=SOLUTION instead of that layout's");
  command->add_flag("--json", arguments->asJson, "Prints one JSON object");
  command->add_option("--limit", arguments->limit, "Ends the search after this many hits")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  arguments->range.addTo(*command);
  command->callback([arguments, &status] { status = searchIn(*arguments); });
}

}  // namespace app
