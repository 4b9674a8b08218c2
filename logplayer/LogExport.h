// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "logplayer/LogFile.h"
#include "logplayer/StreamChoice.h"
#include "robotlink/base/Error.h"

namespace logplayer {

// What a log holds in formats of other programs. All of it takes messages of unknown types, too, by their
// schemas.

struct ExportOptions {
  /// What lies in [from, to]; unset: from the start, to the end.
  std::optional<robotlink::Instant> from = {}, to = {};
  bool overwrite = false;  ///< files of the same names; else they must not exist
  LogFile::Progress progress = {};
};

struct ExportReport {
  std::uint64_t written = 0;        ///< images, rows or texts
  std::vector<std::string> losses;  ///< a sentence each; empty if all was written
};

/// Images of the streams chosen as PNG: "<robot>-<stream>-<time in s>-<frame>.png"
/// ("red1-camera-image-000012.340000-00309.png"; without a frame the number among the images). The folder is
/// made if need be. Fails if the streams hold no images.
robotlink::Result<ExportReport> exportImages(const std::shared_ptr<LogFile>& log, const StreamChoice& streams,
                                             const std::filesystem::path& folder,
                                             const ExportOptions& options);

/// Streams as a table (RFC 4180, UTF-8) with a row for each message: its time in seconds, the process that
/// told it and its frame, and all fields that occur, nested ones as "position.x", repeated ones as
/// "joints[0].position". Time stamps and durations are seconds, enumerations names, bytes base64, what is
/// unset is empty. `streams` is a path, or several as in readSelection(): then a row says of which stream it
/// is, and each stream has columns of its own, "red1/models/ball.position.x". Rows that are left out are
/// losses.
robotlink::Result<ExportReport> exportCsv(const std::shared_ptr<LogFile>& log, const std::string& streams,
                                          const std::filesystem::path& file, const ExportOptions& options);
robotlink::Result<ExportReport> writeCsv(const std::shared_ptr<LogFile>& log, const std::string& streams,
                                         std::ostream& out, const ExportOptions& options);

/// Streams as lines of JSON, one object a message in order of time: stream, log_time in seconds, process,
/// frame, type, and the message as Protobuf's JSON has it, with the fields' own names.
robotlink::Result<ExportReport> exportJsonLines(const std::shared_ptr<LogFile>& log,
                                                const std::string& streams, const std::filesystem::path& file,
                                                const ExportOptions& options);
robotlink::Result<ExportReport> writeJsonLines(const std::shared_ptr<LogFile>& log,
                                               const std::string& streams, std::ostream& out,
                                               const ExportOptions& options);

/// Texts (foxglove.Log) of the streams chosen, one a line with time, level and who said it; further lines of
/// a text are indented.
robotlink::Result<ExportReport> exportTexts(const std::shared_ptr<LogFile>& log, const StreamChoice& streams,
                                            const std::filesystem::path& file, const ExportOptions& options);
robotlink::Result<ExportReport> writeTexts(const std::shared_ptr<LogFile>& log, const StreamChoice& streams,
                                           std::ostream& out, const ExportOptions& options);

}  // namespace logplayer
