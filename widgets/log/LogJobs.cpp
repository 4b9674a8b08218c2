// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/LogJobs.h"

#include <QCoreApplication>
#include <QStringList>

#include "logplayer/base/OutputFile.h"
#include "logplayer/edit/LogCut.h"
#include "logplayer/export/LogExport.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/mcap/read/Reader.h"
#include "widgets/Counted.h"

namespace widgets {
namespace {

using Outcome = LogJob::Outcome;
using Progress = LogJob::Progress;

struct LogJobsText {
  Q_DECLARE_TR_FUNCTIONS(LogJobs)
};

QString fileNameOf(const std::filesystem::path& file) {
  return QString::fromStdString(file.filename().string());
}

Outcome failed(const robotlink::Error& error) {
  return {false, false, QString::fromStdString(error.describe()), {}};
}

QString withLines(QString text, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) text += QLatin1Char('\n') + QString::fromStdString(line);
  return text;
}

logplayer::ExportOptions exportOptions(const LogRange& range, const Progress& progress) {
  logplayer::ExportOptions options;
  if (range) {
    options.from = range->first;
    options.to = range->second;
  }
  options.overwrite = true;  // the file dialog has asked
  options.progress = progress;
  return options;
}

/// Opens the log, and exports from it with `what`.
template <typename What>
Outcome exported(const std::string& path, const Progress& progress, const char* text,
                 const std::filesystem::path& to, What what) {
  logplayer::LogFile::Options options;
  options.progress = [&progress](double) { return progress(0); };
  const auto log = logplayer::LogFile::open(path, options);
  if (!log) return failed(log.error());
  const auto report = what(*log);
  if (!report) return failed(report.error());
  return {true,
          false,
          withLines(LogJobsText::tr(text).arg(QString::fromStdString(to.string()),
                                              QString::number(report->written)),
                    report->losses),
          {}};
}

}  // namespace

LogJob::Work cutLogs(std::vector<std::pair<std::string, robotlink::Duration>> logs, LogRange range,
                     std::filesystem::path to, logplayer::StreamFilter streams) {
  return [logs = std::move(logs), range, to = std::move(to),
          streams = std::move(streams)](const Progress& progress) -> Outcome {
    logplayer::RewriteOptions options;
    options.streams = streams;
    for (const auto& [file, offset] : logs) options.inputs.push_back({file, offset});
    if (range) {
      options.from = range->first;
      options.to = range->second;
    }
    options.overwrite = true;
    options.progress = progress;
    const auto report = logplayer::rewriteLogs(options, to);
    if (!report) return failed(report.error());
    const QString text =
        LogJobsText::tr("%1: %2 in %3, %4")
            .arg(fileNameOf(to),
                 counted(report->messages, LogJobsText::tr("1 message"), LogJobsText::tr("%1 messages")),
                 counted(report->frames, LogJobsText::tr("1 frame"), LogJobsText::tr("%1 frames")),
                 bytesText(report->bytes));
    std::vector<std::string> lines;
    for (const auto& [robot, name] : report->renamed)
      lines.push_back(LogJobsText::tr("%1 is called %2")
                          .arg(QString::fromStdString(robot), QString::fromStdString(name))
                          .toStdString());
    lines.insert(lines.end(), report->notes.begin(), report->notes.end());
    return {true, false, withLines(withLines(text, lines), report->losses), to};
  };
}

LogJob::Work exportImagesOf(std::string log, std::string stream, LogRange range,
                            std::filesystem::path folder) {
  return [=](const Progress& progress) {
    return exported(
        log, progress, QT_TRANSLATE_NOOP("LogJobs", "%1: images written: %2"), folder, [&](const auto& file) {
          return logplayer::exportImages(file, {{stream}, {}}, folder, exportOptions(range, progress));
        });
  };
}

LogJob::Work exportTableOf(std::string log, std::string stream, LogRange range, std::filesystem::path to) {
  return [=](const Progress& progress) {
    return exported(log, progress, QT_TRANSLATE_NOOP("LogJobs", "%1: rows written: %2"), to,
                    [&](const auto& file) {
                      return logplayer::exportCsv(file, stream, to, exportOptions(range, progress));
                    });
  };
}

LogJob::Work exportTextsOf(std::string log, LogRange range, std::filesystem::path to) {
  return [=](const Progress& progress) {
    return exported(log, progress, QT_TRANSLATE_NOOP("LogJobs", "%1: texts written: %2"), to,
                    [&](const auto& file) {
                      return logplayer::exportTexts(file, {}, to, exportOptions(range, progress));
                    });
  };
}

LogJob::Work repairLog(std::string log, std::filesystem::path to) {
  return [log = std::move(log), to = std::move(to)](const Progress& progress) -> Outcome {
    std::error_code error;
    if (std::filesystem::equivalent(log, to, error)) {
      return {false, false, LogJobsText::tr("A log is not repaired in place; choose another name."), {}};
    }
    // The user was asked whether an old file may be replaced; it stays until the new one is complete.
    auto output = logplayer::OutputFile::create(to, true);
    if (!output) return failed(output.error());
    const auto report = logplayer::mcap::repair(log, output->temporary(), progress);
    if (!report) return failed(output->named(report.error()));
    if (const auto done = output->commit(); !done) return failed(done.error());
    return {true, false,
            LogJobsText::tr("%1: %2 saved; %3 and %4 were lost")
                .arg(fileNameOf(to),
                     counted(report->messages, LogJobsText::tr("1 message"), LogJobsText::tr("%1 messages")),
                     counted(report->chunksLost, LogJobsText::tr("1 chunk"), LogJobsText::tr("%1 chunks")),
                     bytesText(report->bytesLost)),
            to};
  };
}

}  // namespace widgets
