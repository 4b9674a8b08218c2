// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
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

/// Messages that could not be read, by stream.
using Unread = std::map<std::string, std::uint64_t>;

/// Goes over the messages of some streams (at least one) in the range; `visit` may fail, and ends it.
robotlink::Result<Unread> forEachMessage(
    const std::shared_ptr<LogFile>& log, const std::vector<std::string>& streams,
    const ExportOptions& options, PassShare share,
    const std::function<robotlink::Result<void>(const robotlink::StreamMessage&)>& visit);

/// The chosen streams of a log that fit.
std::vector<std::string> chosenStreams(const LogFile& log, const StreamChoice& streams,
                                       const std::function<bool(const LogFile::Stream&)>& fitting);

/// The streams that a text names: one by its path, or several as in readSelection()
/// ("red1/models/*,-*/pose"). Those in encodings that are not read are left out, and reported as losses.
/// Fails if none is left.
robotlink::Result<std::vector<std::string>> namedStreams(const LogFile& log, const std::string& text,
                                                         ExportReport& report);

/// Writes a file by `write`; it gets its name when it is complete.
robotlink::Result<ExportReport> exportTo(
    const std::filesystem::path& file, bool overwrite,
    const std::function<robotlink::Result<ExportReport>(std::ostream&)>& write);

/// Writes at the end of a stream. Fails as soon as the system does not take it, since more would be in vain.
robotlink::Result<void> put(std::ostream& out, const std::string& text);

/// What of the log itself could not be read is a loss of the export, too.
void noteDamage(const LogFile& log, ExportReport& report);
void noteUnread(const Unread& unread, ExportReport& report);
/// Whether a message stayed bytes because of its encoding.
bool isUndecoded(const LogFile& log, const robotlink::StreamMessage& message);

}  // namespace logplayer
