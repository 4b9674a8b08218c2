// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "logplayer/base/StreamFilter.h"
#include "logplayer/export/ExportOptions.h"
#include "logplayer/file/LogFile.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

// The common part of all exports of a log.

/// The part of the whole progress of an export, in [0, 1], that one pass over the log accounts for.
struct PassShare {
  double from = 0, to = 1;
};

/// Numbers of messages that could not be read, by stream.
using Unread = std::map<std::string, std::uint64_t>;

/// Calls `visit` for each message of some streams (at least one) in the range of the options, in order of
/// time. Fails as soon as `visit` fails, or with "log.given-up" if the progress callback returns false.
robotlink::Result<Unread> forEachMessage(
    const std::shared_ptr<LogFile>& log, const std::vector<std::string>& streams,
    const ExportOptions& options, PassShare share,
    const std::function<robotlink::Result<void>(const robotlink::StreamMessage&)>& visit);

/// The paths of those selected streams of a log for which `fitting` returns true.
std::vector<std::string> chosenStreams(const LogFile& log, const StreamFilter& streams,
                                       const std::function<bool(const LogFile::Stream&)>& fitting);

/// Returns the streams that a text selects: one by its path, or several by patterns as in readSelection()
/// ("red1/models/*,-*/pose"). Streams in unsupported encodings are left out and added to the losses of
/// `report`. Fails if no stream is left.
robotlink::Result<std::vector<std::string>> namedStreams(const LogFile& log, const std::string& text,
                                                         ExportReport& report);

/// Writes a file by calling `write`; the file gets its name when it is complete, see OutputFile.
robotlink::Result<ExportReport> exportTo(
    const std::filesystem::path& file, bool overwrite,
    const std::function<robotlink::Result<ExportReport>(std::ostream&)>& write);

/// Writes at the end of a stream. Fails as soon as the system does not take it, since more would be in vain.
robotlink::Result<void> put(std::ostream& out, const std::string& text);

/// Adds the damage of the log itself to the losses of an export.
void noteDamage(const LogFile& log, ExportReport& report);
/// Adds messages that could not be read to the losses of an export.
void noteUnread(const Unread& unread, ExportReport& report);
/// Whether a message is an undecoded copy of its bytes because of its encoding.
bool isUndecoded(const LogFile& log, const robotlink::StreamMessage& message);

}  // namespace logplayer
