// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl log export`.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/robotctl/log/LogInput.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "logplayer/export/LogExport.h"

namespace app {
namespace {

using logplayer::ExportReport;
using robotlink::Result;

struct ExportArguments {
  std::string file;
  std::string images;
  std::vector<std::string> csv;   ///< streams and file; "-" is standard output
  std::vector<std::string> json;  ///< as csv
  bool texts = false;
  std::string output = "-";
  TimeRangeOptions range;
  logplayer::StreamFilter streams;
  bool force = false;
};

constexpr char kStandardOutput[] = "-";

/// Collects what was written to which file, and the losses.
class ExportStatus {
 public:
  explicit ExportStatus(TerminalProgress& progress) : progress_(progress) {}
  void add(const Result<ExportReport>& report, const std::string& what, const std::string& to) {
    progress_.erase();
    if (!report) {
      // Errors of standard output are reported at the end of the program.
      const bool said = report.error().id == "file.io" && report.error().where.file.empty();
      status_ = said ? kFailed : printErrors({report.error()});
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
  if (!arguments.json.empty()) {
    const std::string& to = arguments.json[1];
    status.add(to == kStandardOutput ? writeJsonLines(log, arguments.json[0], std::cout, options)
                                     : exportJsonLines(log, arguments.json[0], to, options),
               "lines", to);
  }
  if (arguments.texts) {
    const std::string& to = arguments.output;
    status.add(to == kStandardOutput ? writeTexts(log, arguments.streams, std::cout, options)
                                     : exportTexts(log, arguments.streams, to, options),
               "texts", to);
  }
  return status.value();
}

Result<std::shared_ptr<logplayer::LogFile>> opened(const std::filesystem::path& file) {
  TerminalProgress progress;
  logplayer::LogFile::Options options;
  options.progress = progress.function();
  return logplayer::LogFile::open(file, options);
}

int exportLog(const ExportArguments& arguments) {
  if (arguments.images.empty() && arguments.csv.empty() && arguments.json.empty() && !arguments.texts) {
    std::cerr << "robotctl log export: choose what to export: --images, --csv, --json or --texts\n";
    return kUsage;
  }
  const auto input = LogInput::of(arguments.file);
  if (!input) return printErrors({input.error()});
  const auto range = arguments.range.of(input->path());
  if (!range) return printRangeError(range.error());
  const auto log = opened(input->path());
  if (!log) return printErrors({log.error()});
  return exportFrom(*log, arguments, {range->from, range->to, arguments.force});
}

}  // namespace

void addLogExportCommand(CLI::App& log, int& status) {
  auto arguments = std::make_shared<ExportArguments>();
  CLI::App* command = log.add_subcommand("export", "Writes images as PNG, streams as tables or JSON, texts");
  command->add_option("file", arguments->file, "A log file (MCAP or an older format); - is standard input")
      ->required();
  command->add_option("--images", arguments->images,
                      "A folder for images, which are named by stream, time and frame");
  const std::string streams =
      "comma-separated streams, where * matches any text and - excludes ('red1/*,-*/camera/*'), and the "
      "file; - is standard output";
  command->add_option("--csv", arguments->csv, "STREAMS OUT, a table: " + streams)->expected(2);
  command
      ->add_option("--json", arguments->json, "STREAMS OUT, one JSON object per line and message: " + streams)
      ->expected(2);
  command->add_flag("--texts", arguments->texts, "Texts, one per line with time, level and source");
  command->add_option("--output", arguments->output, "A file for the texts, instead of standard output");
  arguments->range.addTo(*command);
  command
      ->add_option("--streams", arguments->streams.include,
                   "Only images and texts of these streams; * matches any text")
      ->allow_extra_args(false);
  command->add_option("--exclude", arguments->streams.exclude, "None of these")->allow_extra_args(false);
  command->add_flag("--force", arguments->force, "Overwrites existing files");
  command->callback([arguments, &status] { status = exportLog(*arguments); });
}

}  // namespace app
