// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "logplayer/LogExport.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

// What all exports of a log have in common.

/// The part of an export that one pass over the log is.
struct PassShare {
  double from = 0, to = 1;
};

/// Goes over the messages of some streams (at least one) in the range; `visit` may fail, and ends it.
robotlink::Result<void> forEachMessage(
    const std::shared_ptr<LogFile>& log, const std::vector<std::string>& streams,
    const ExportOptions& options, PassShare share,
    const std::function<robotlink::Result<void>(const robotlink::StreamMessage&)>& visit);

/// The chosen streams of a log whose type fits.
std::vector<std::string> chosenStreams(const LogFile& log, const StreamChoice& streams,
                                       const std::function<bool(const std::string& type)>& fitting);

/// Writes a file by `write`; it gets its name when it is complete.
robotlink::Result<ExportReport> exportTo(
    const std::filesystem::path& file, bool overwrite,
    const std::function<robotlink::Result<ExportReport>(std::ostream&)>& write);

/// What of the log itself could not be read is a loss of the export, too.
void noteDamage(const LogFile& log, ExportReport& report);

/// "1 image", "2 images".
std::string plural(std::uint64_t count, const std::string& noun);

}  // namespace logplayer
