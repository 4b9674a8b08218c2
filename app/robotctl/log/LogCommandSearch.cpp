// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl log search`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/core/platform/JsonOutput.h"
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
};

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

int searchIn(const SearchArguments& arguments) {
  const auto input = LogInput::of(arguments.file);
  if (!input) return printErrors({input.error()});
  const auto range = arguments.range.of(input->path());
  if (!range) return printRangeError(range.error());
  TerminalProgress progress;
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
                                     {range->from, range->to, false, progress.function()}, found);
  progress.erase();
  if (!report) {
    const bool isExpression =
        report.error().id.starts_with("expression.") || report.error().id.starts_with("path.");
    if (isExpression) report.error().where = {"expression", 1, report.error().where.column};
    const int status = printErrors({report.error()});
    return isExpression ? kUsage : status;
  }
  if (report->hits >= arguments.limit) {
    report->losses.push_back("only the first " + logplayer::plural(arguments.limit, "hit") +
                             " were looked for; --limit takes more");
  }
  if (arguments.asJson) {
    std::cout << jsonOutput(json{{"file", arguments.file},
                                 {"expression", arguments.expression},
                                 {"hits", std::move(hits)},
                                 {"losses", report->losses}});
  } else {
    std::cout << logplayer::plural(report->hits, "hit") << "\n";
  }
  return printLosses(report->losses);
}

}  // namespace

void addLogSearchCommand(CLI::App& log, int& status) {
  auto arguments = std::make_shared<SearchArguments>();
  CLI::App* command =
      log.add_subcommand("search", "Finds where a condition becomes true, without playing the log");
  command->add_option("file", arguments->file, "A log file, of an older format, too; - is standard input")
      ->required();
  command
      ->add_option("expression", arguments->expression,
                   "The condition, over values of streams: 'models/ball.position.x > 1', "
                   "'log.message =~ \"(?i)lost\"'")
      ->required();
  command->add_flag("--json", arguments->asJson, "Prints one JSON object");
  command->add_option("--limit", arguments->limit, "Ends the search after so many hits")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  arguments->range.addTo(*command);
  command->callback([arguments, &status] { status = searchIn(*arguments); });
}

}  // namespace app
