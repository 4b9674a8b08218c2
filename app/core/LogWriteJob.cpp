// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/LogWriteJob.h"

#include <utility>

#include "logplayer/base/RecordedStreams.h"
#include "logplayer/export/LogExport.h"
#include "logplayer/file/LogFile.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;

/// Converts a report to its outcome, which is also a failure if something could not be read.
template <typename Report>
Result<void> outcomeOf(const Result<Report>& report, const std::filesystem::path& to) {
  if (!report) return tl::unexpected(report.error());
  if (report->losses.empty()) return {};
  std::string text = to.string() + " was written, but not all could be read:";
  for (const std::string& loss : report->losses) text += " " + loss;
  return failure("log.losses", std::move(text), {to.string(), 0, 0});
}

Result<logplayer::ExportReport> exported(const std::shared_ptr<logplayer::LogFile>& log,
                                         const LogWriteJob::Export& what,
                                         const logplayer::ExportOptions& options) {
  using Kind = LogWriteJob::Export::Kind;
  if (what.kind == Kind::kCsv) return logplayer::exportCsv(log, what.streams, what.target, options);
  if (what.kind == Kind::kJson) return logplayer::exportJsonLines(log, what.streams, what.target, options);
  const auto selection = logplayer::readSelection(what.streams);
  if (!selection) return tl::unexpected(selection.error());
  const logplayer::StreamFilter streams{{selection->include().begin(), selection->include().end()},
                                        {selection->exclude().begin(), selection->exclude().end()}};
  return what.kind == Kind::kImages ? logplayer::exportImages(log, streams, what.target, options)
                                    : logplayer::exportTexts(log, streams, what.target, options);
}

}  // namespace

LogWriteJob::LogWriteJob()
    : worker_([this](const Work& work, const std::stop_token& stop) {
        worker_.publish(work([&stop](double) { return !stop.stop_requested(); }));
      }) {}

Result<void> LogWriteJob::begin(Work work) {
  if (isRunning_)
    return failure("log.writing", "another part of a log is being written; wait until it is done");
  isRunning_ = true;
  worker_.post(std::move(work));
  return {};
}

Result<void> LogWriteJob::cut(logplayer::RewriteOptions options, std::filesystem::path to) {
  return begin([options = std::move(options),
                to = std::move(to)](const logplayer::Progress& progress) mutable -> Result<void> {
    options.progress = progress;
    return outcomeOf(logplayer::rewriteLogs(options, to), to);
  });
}

Result<void> LogWriteJob::exportLog(Export what) {
  return begin([what = std::move(what)](const logplayer::Progress& progress) -> Result<void> {
    logplayer::LogFile::Options opening;
    opening.progress = progress;
    const auto log = logplayer::LogFile::open(what.log, opening);
    if (!log) return tl::unexpected(log.error());
    return outcomeOf(exported(*log, what, {.from = what.from, .to = what.to, .progress = progress}),
                     what.target);
  });
}

Result<bool> LogWriteJob::working() {
  if (auto done = worker_.take()) {
    isRunning_ = false;
    if (!*done) return tl::unexpected(done->error());
  }
  return isRunning_;
}

}  // namespace app
