// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl log` cut, merge, filter and convert.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "app/robotctl/log/LogInput.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "logplayer/base/Plural.h"
#include "logplayer/edit/LogCut.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/base/Printable.h"

namespace app {
namespace {

struct CutArguments {
  std::vector<std::string> files;  ///< the last one is the output
  std::string from, to;
  TimeRangeOptions range;
  logplayer::RewriteOptions options;
  std::vector<std::string> offsets;
};

const std::map<std::string, logplayer::mcap::Compression> kCompressions{
    {"none", logplayer::mcap::Compression::kNone},
    {"lz4", logplayer::mcap::Compression::kLz4},
    {"zstd", logplayer::mcap::Compression::kZstd},
};

robotlink::Result<logplayer::RewriteReport> rewrite(logplayer::RewriteOptions& options,
                                                    const std::string& to) {
  TerminalProgress progress;
  options.progress = progress.function();
  return rewriteLogs(options, to);
}

int writeLog(logplayer::RewriteOptions& options, const std::string& to) {
  const auto report = rewrite(options, to);
  if (!report) return printErrors({report.error()});
  for (const auto& [from, name] : report->renamed)
    std::cout << robotlink::printable(from + " is called " + name) << "\n";
  if (report->concatenated) std::cout << "the logs were joined one after another, as parts of one\n";
  for (const std::string& note : report->notes) std::cout << robotlink::printable(note) << "\n";
  std::printf("%s: %s, %s, %s, %.3f s, %.2f MB\n", to.c_str(),
              logplayer::plural(report->messages, "message").c_str(),
              logplayer::plural(report->frames, "frame").c_str(),
              logplayer::plural(report->bookmarks, "bookmark").c_str(),
              robotlink::seconds(report->end - report->begin), static_cast<double>(report->bytes) * 1e-6);
  std::fflush(stdout);
  return printLosses(report->losses);
}

int cut(CutArguments& arguments) {
  const auto input = LogInput::of(arguments.from);
  if (!input) return printErrors({input.error()});
  const auto range = arguments.range.of(input->path());
  if (!range) return printRangeError(range.error());
  arguments.options.from = range->from;
  arguments.options.to = range->to;
  arguments.options.inputs = {{input->path()}};
  return writeLog(arguments.options, arguments.to);
}

/// Assigns "FILE=SECONDS" to the input with this name; prints an error and returns false if there is none.
bool takeOffset(const std::string& text, std::vector<logplayer::RewriteInput>& inputs) {
  const auto equals = text.rfind('=');
  const double seconds = equals == std::string::npos
                             ? NAN
                             : robotlink::parsedNumber<double>(text.substr(equals + 1)).value_or(NAN);
  bool taken = false;
  for (auto& input : inputs) {
    if (!(std::abs(seconds) < 4e9) || input.file != text.substr(0, equals)) continue;
    input.offset = robotlink::fromSeconds(seconds);
    taken = true;
  }
  if (!taken)
    std::cerr << "robotctl log merge: --offset takes FILE=SECONDS with one of the logs, not '" << text
              << "'\n";
  return taken;
}

int merge(CutArguments& arguments) {
  for (std::size_t i = 0; i + 1 < arguments.files.size(); ++i)
    arguments.options.inputs.push_back({arguments.files[i]});
  for (const std::string& offset : arguments.offsets) {
    if (!takeOffset(offset, arguments.options.inputs)) return kUsage;
  }
  std::vector<LogInput> opened;
  for (auto& named : arguments.options.inputs) {
    auto input = LogInput::of(named.file.string());
    if (!input) return printErrors({input.error()});
    named.file = opened.emplace_back(std::move(*input)).path();
  }
  return writeLog(arguments.options, arguments.files.back());
}

void addStreams(CLI::App& command, CutArguments& arguments) {
  command
      .add_option("--streams", arguments.options.streams.include, "Only these; * matches any text: 'red1/*'")
      ->allow_extra_args(false);
  command.add_option("--exclude", arguments.options.streams.exclude, "None of these")
      ->allow_extra_args(false);
}

void addFiles(CLI::App& command, CutArguments& arguments) {
  command.add_option("from", arguments.from, "The log to read; - is standard input")->required();
  command.add_option("to", arguments.to, "The MCAP file to write")->required();
}

void addOutput(CLI::App& command, CutArguments& arguments) {
  command
      .add_option("--compression", arguments.options.compression,
                  "Compression of the new file: none, lz4 or zstd (default)")
      ->transform(CLI::CheckedTransformer(kCompressions).description("{none,lz4,zstd}"))
      ->type_name("TEXT");
  command.add_flag("--force", arguments.options.overwrite, "Overwrites an existing file");
}

}  // namespace

void addLogCutCommands(CLI::App& log, int& status) {
  auto arguments = std::make_shared<CutArguments>();
  CLI::App* command = log.add_subcommand(
      "cut", "Copies a time range: whole frames, bookmarks, and messages latched at its start");
  addFiles(*command, *arguments);
  arguments->range.addTo(*command);
  addStreams(*command, *arguments);
  addOutput(*command, *arguments);
  command->callback([arguments, &status] { status = cut(*arguments); });

  arguments = std::make_shared<CutArguments>();
  command = log.add_subcommand("merge",
                               "Merges several logs: parts of one log one after another, others in parallel, "
                               "where robots with equal names get -2, -3 appended");
  command->add_option("files", arguments->files, "The logs to read, and last the MCAP file to write")
      ->required()
      ->expected(2, -1);
  auto& joining = arguments->options.joining;
  auto* concatenate = command->add_flag_callback(
      "--concatenate", [&joining] { joining = logplayer::Joining::kConcatenate; },
      "Joins the logs one after another, or fails; the default if their times do not overlap and robots with "
      "equal names run the same program");
  command
      ->add_flag_callback(
          "--separate", [&joining] { joining = logplayer::Joining::kSeparate; },
          "Always in parallel: robots with equal names get -2, -3 appended")
      ->excludes(concatenate);
  command->add_option("--offset", arguments->offsets, "FILE=SECONDS, added to the times of one of the logs")
      ->allow_extra_args(false);
  addOutput(*command, *arguments);
  command->callback([arguments, &status] { status = merge(*arguments); });

  arguments = std::make_shared<CutArguments>();
  command = log.add_subcommand("filter", "Copies some of the streams, with the ends of their frames");
  addFiles(*command, *arguments);
  addStreams(*command, *arguments);
  addOutput(*command, *arguments);
  command->callback([arguments, &status] { status = cut(*arguments); });

  arguments = std::make_shared<CutArguments>();
  command = log.add_subcommand("convert", "Rewrites a log with other chunks or another compression");
  addFiles(*command, *arguments);
  command
      ->add_option("--chunk-size", arguments->options.chunkBytes,
                   "Size of chunks in bytes, with k, M or G for units of 1024; frames stay whole")
      ->transform(CLI::AsSizeValue(false))
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 30U).description("1 to 1G"));
  addOutput(*command, *arguments);
  command->callback([arguments, &status] { status = cut(*arguments); });
}

}  // namespace app
