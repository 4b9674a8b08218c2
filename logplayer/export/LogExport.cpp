// SPDX-License-Identifier: GPL-3.0-or-later
// Export of texts, one per line.
#include "logplayer/export/LogExport.h"

#include <ostream>

#include "foxglove/Robot.pb.h"
#include "logplayer/export/ExportPass.h"
#include "logplayer/export/TextLine.h"

namespace logplayer {
namespace fs = std::filesystem;
using robotlink::Result;
using robotlink::StreamMessage;

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
                            " are in an unsupported encoding; left out");
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
