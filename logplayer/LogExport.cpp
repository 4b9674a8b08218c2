// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/LogExport.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <ostream>

#include "foxglove/Robot.pb.h"
#include "logplayer/ExportPass.h"
#include "logplayer/MessageTable.h"

namespace logplayer {
namespace {

namespace fs = std::filesystem;
using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamMessage;

std::string timeText(Instant time) {
  const auto count = time.time_since_epoch().count();
  constexpr std::int64_t kSecond = 1'000'000'000;
  return secondsText(count / kSecond, count % kSecond);
}

const char* levelText(foxglove::Log::Level level) {
  switch (level) {
    case foxglove::Log::DEBUG:
      return "debug";
    case foxglove::Log::INFO:
      return "info";
    case foxglove::Log::WARNING:
      return "warning";
    case foxglove::Log::ERROR:
      return "error";
    case foxglove::Log::FATAL:
      return "fatal";
    default:
      return "-";
  }
}

/// Lines behind the first are indented, and what would act on a terminal is not printed.
std::string printable(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += "\n    ";
    } else {
      result += (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7F ? '?' : c;
    }
  }
  return result;
}

std::string textLine(const StreamMessage& message, const foxglove::Log& text) {
  std::array<char, 64> head{};
  std::snprintf(head.data(), head.size(), "%12.6f  %-7s  ", robotlink::seconds(message.time),
                levelText(text.level()));
  const std::string source =
      text.name().empty() ? message.path : message.path.substr(0, message.path.find('/')) + "/" + text.name();
  return head.data() + printable(source + ": " + text.message()) + "\n";
}

}  // namespace

Result<ExportReport> writeCsv(const std::shared_ptr<LogFile>& log, const std::string& stream,
                              std::ostream& out, const ExportOptions& options) {
  const auto paths = chosenStreams(*log, {{stream}, {}}, [](const std::string&) { return true; });
  if (std::find(paths.begin(), paths.end(), stream) == paths.end()) {
    return robotlink::failure("export.stream",
                              "there is no stream " + stream + " in it; 'robotctl log info' lists them",
                              {log->path().string(), 0, 0}, {stream});
  }
  MessageTable table;
  ExportReport report;
  std::uint64_t ofOtherTypes = 0;
  std::string type;
  const auto ofType = [&](const StreamMessage& message) {
    const std::string& name = message.value->GetDescriptor()->full_name();
    if (type.empty()) type = name;
    return type == name;
  };
  const auto learned =
      forEachMessage(log, {stream}, options, {0, 0.5}, [&](const StreamMessage& message) -> Result<void> {
        if (ofType(message)) table.learn(*message.value);
        return {};
      });
  if (!learned) return tl::unexpected(learned.error());
  std::vector<std::string> head{"log_time", "log_process", "log_frame"};
  const auto columns = table.columns();
  head.insert(head.end(), columns.begin(), columns.end());
  out << csvLine(head);
  const auto written =
      forEachMessage(log, {stream}, options, {0.5, 1}, [&](const StreamMessage& message) -> Result<void> {
        if (!ofType(message)) {
          ++ofOtherTypes;
          return {};
        }
        std::vector<std::string> cells{timeText(message.time), message.process,
                                       message.frame > 0 ? std::to_string(message.frame) : std::string()};
        auto values = table.row(*message.value);
        cells.insert(cells.end(), std::make_move_iterator(values.begin()),
                     std::make_move_iterator(values.end()));
        out << csvLine(cells);
        ++report.written;
        return {};
      });
  if (!written) return tl::unexpected(written.error());
  if (ofOtherTypes > 0) {
    report.losses.push_back(plural(ofOtherTypes, "message") + " of " + stream + " are of another type than " +
                            type + "; left out");
  }
  if (table.leftOut() > 0) {
    report.losses.push_back(plural(table.leftOut(), "value") + " left out, as a table has no more than " +
                            std::to_string(MessageTable::kMaxColumns) + " columns");
  }
  noteDamage(*log, report);
  return report;
}

Result<ExportReport> exportCsv(const std::shared_ptr<LogFile>& log, const std::string& stream,
                               const fs::path& file, const ExportOptions& options) {
  return exportTo(file, options.overwrite,
                  [&](std::ostream& out) { return writeCsv(log, stream, out, options); });
}

Result<ExportReport> writeTexts(const std::shared_ptr<LogFile>& log, const StreamChoice& streams,
                                std::ostream& out, const ExportOptions& options) {
  const auto paths = chosenStreams(*log, streams, [](const std::string& type) {
    return type == foxglove::Log::descriptor()->full_name();
  });
  ExportReport report;
  if (!paths.empty()) {
    const auto done =
        forEachMessage(log, paths, options, {}, [&](const StreamMessage& message) -> Result<void> {
          if (const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get())) {
            out << textLine(message, *text);
            ++report.written;
          }
          return {};
        });
    if (!done) return tl::unexpected(done.error());
  }
  noteDamage(*log, report);
  return report;
}

Result<ExportReport> exportTexts(const std::shared_ptr<LogFile>& log, const StreamChoice& streams,
                                 const fs::path& file, const ExportOptions& options) {
  return exportTo(file, options.overwrite,
                  [&](std::ostream& out) { return writeTexts(log, streams, out, options); });
}

}  // namespace logplayer
