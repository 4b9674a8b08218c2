// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/robotctl/LogCommands.h"
#include "logplayer/LogExport.h"

namespace app {
namespace {

using logplayer::ExportReport;
using robotlink::Result;

struct ExportArguments {
  std::string file;
  std::string images;
  std::vector<std::string> csv;  ///< the stream and the file; "-" is stdout
  bool texts = false;
  std::string output = "-";
  TimeRange range;
  logplayer::StreamChoice streams;
  bool force = false;
};

constexpr char kStandardOutput[] = "-";

/// What was written where, and with which losses.
class ExportStatus {
 public:
  explicit ExportStatus(TerminalProgress& progress) : progress_(progress) {}
  void add(const Result<ExportReport>& report, const std::string& what, const std::string& to) {
    progress_.erase();
    if (!report) {
      status_ = printErrors({report.error()});
      return;
    }
    if (to != kStandardOutput) std::cout << to << ": " << report->written << " " << what << std::endl;
    const int here = printLosses(report->losses);
    if (status_ == kDone) status_ = here;
  }
  int value() const { return status_; }

 private:
  TerminalProgress& progress_;
  int status_ = kDone;
};

int exportFrom(const std::shared_ptr<logplayer::LogFile>& log, const ExportArguments& arguments,
               logplayer::ExportOptions options) {
  TerminalProgress progress;
  options.progress = progress.function();
  ExportStatus status(progress);
  if (!arguments.images.empty()) {
    status.add(exportImages(log, arguments.streams, arguments.images, options), "images", arguments.images);
  }
  if (!arguments.csv.empty()) {
    const std::string& to = arguments.csv[1];
    status.add(to == kStandardOutput ? writeCsv(log, arguments.csv[0], std::cout, options)
                                     : exportCsv(log, arguments.csv[0], to, options),
               "rows", to);
  }
  if (arguments.texts) {
    const std::string& to = arguments.output;
    status.add(to == kStandardOutput ? writeTexts(log, arguments.streams, std::cout, options)
                                     : exportTexts(log, arguments.streams, to, options),
               "texts", to);
  }
  std::cout.flush();
  if (std::cout) return status.value();
  std::cerr << "robotctl log export: cannot write to standard output\n";
  return kFailed;
}

Result<std::shared_ptr<logplayer::LogFile>> opened(const std::string& file) {
  TerminalProgress progress;
  logplayer::LogFile::Options options;
  options.progress = progress.function();
  return logplayer::LogFile::open(file, options);
}

int run(const ExportArguments& arguments) {
  if (arguments.images.empty() && arguments.csv.empty() && !arguments.texts) {
    std::cerr << "robotctl log export: say what: --images, --csv or --texts\n";
    return kUsage;
  }
  const auto range = arguments.range.of(arguments.file);
  if (!range) {
    printErrors({range.error()});
    return range.error().id == "usage" ? kUsage : kFailed;
  }
  const auto log = opened(arguments.file);
  if (!log) return printErrors({log.error()});
  return exportFrom(*log, arguments, {range->from, range->to, arguments.force});
}

}  // namespace

void addLogExportCommand(CLI::App& log, int& status) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = log.add_subcommand("export", "Writes images as PNG, streams as tables, texts");
  command->add_option("file", arguments->file, "A log file, of an older format, too")->required();
  command->add_option("--images", arguments->images,
                      "A folder for images, which are named by stream, time and frame");
  command
      ->add_option("--csv", arguments->csv,
                   "STREAM OUT: a stream and the file for its table; - is standard output")
      ->expected(2);
  command->add_flag("--texts", arguments->texts, "Texts, one a line with time, level and source");
  command->add_option("--output", arguments->output, "A file for the texts, instead of standard output");
  arguments->range.addTo(*command);
  command
      ->add_option("--streams", arguments->streams.include,
                   "Of images and texts only these; * stands for any text")
      ->allow_extra_args(false);
  command->add_option("--exclude", arguments->streams.exclude, "None of these")->allow_extra_args(false);
  command->add_flag("--force", arguments->force, "Overwrites files of these names");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace app
