// SPDX-License-Identifier: GPL-3.0-or-later
// Export of texts, one per line.
#include "logplayer/export/LogExport.h"

#include <array>
#include <cstdio>
#include <ostream>

#include "foxglove/Robot.pb.h"
#include "logplayer/base/LogDates.h"
#include "logplayer/export/ExportPass.h"

namespace logplayer {
namespace {

namespace fs = std::filesystem;
using robotlink::Result;
using robotlink::StreamMessage;

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

/// Indents further lines, and replaces control characters that would affect a terminal.
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
  std::snprintf(head.data(), head.size(), "%12.6f", robotlink::seconds(message.time));
  const std::string time = isDate(message.time) ? dateText(message.time) : head.data();
  std::snprintf(head.data(), head.size(), "  %-7s  ", levelText(text.level()));
  const std::string source =
      text.name().empty() ? message.path : message.path.substr(0, message.path.find('/')) + "/" + text.name();
  return time + head.data() + printable(source + ": " + text.message()) + "\n";
}

}  // namespace

Result<ExportReport> writeTexts(const std::shared_ptr<LogFile>& log, const StreamFilter& streams,
                                std::ostream& out, const ExportOptions& options) {
  const auto paths = chosenStreams(*log, streams, [](const LogFile::Stream& stream) {
    return stream.holds(foxglove::Log::descriptor()->full_name());
  });
  ExportReport report;
  const auto undecoded = chosenStreams(*log, streams, [](const LogFile::Stream& stream) {
    return stream.type == foxglove::Log::descriptor()->full_name() && !stream.isDecoded();
  });
  for (const std::string& path : undecoded) {
    report.losses.push_back(log->path().string() + ": the texts of " + path +
                            " are in an encoding that is not read; left out");
  }
  if (!paths.empty()) {
    const auto done =
        forEachMessage(log, paths, options, {}, [&](const StreamMessage& message) -> Result<void> {
          const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get());
          if (text == nullptr) return {};
          ++report.written;
          return logplayer::put(out, textLine(message, *text));
        });
    if (!done) return tl::unexpected(done.error());
    noteUnread(*done, report);
  }
  noteDamage(*log, report);
  return report;
}

Result<ExportReport> exportTexts(const std::shared_ptr<LogFile>& log, const StreamFilter& streams,
                                 const fs::path& file, const ExportOptions& options) {
  return exportTo(file, options.overwrite,
                  [&](std::ostream& out) { return writeTexts(log, streams, out, options); });
}

}  // namespace logplayer
