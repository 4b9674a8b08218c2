// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "logplayer/base/StreamFilter.h"
#include "logplayer/export/ExportOptions.h"
#include "logplayer/file/LogFile.h"
#include "robotlink/base/Error.h"

namespace logplayer {

// Export of logs to formats of other programs. Messages of unknown types are exported by means of their
// schemas. All functions fail with "log.given-up" if the progress callback returns false.

/// Exports the images of the selected streams as PNG files: "<robot>-<stream>-<time in s>-<frame>.png"
/// ("red1-camera-image-000012.340000-00309.png"; without a frame the index of the image). Creates the folder
/// if necessary. Fails if the streams contain no images.
robotlink::Result<ExportReport> exportImages(const std::shared_ptr<LogFile>& log, const StreamFilter& streams,
                                             const std::filesystem::path& folder,
                                             const ExportOptions& options);

/// Exports streams as a table (RFC 4180, UTF-8) with one row per message: its time in seconds, process and
/// frame, and one column per field that occurs, nested ones as "position.x", repeated ones as
/// "joints[0].position". Timestamps and durations are seconds, enumerations names, bytes base64, unset fields
/// empty. `streams` is a path, or a selection as in readSelection(); then each row names its stream, and each
/// stream has columns of its own, "red1/models/ball.position.x". Missing rows are losses.
robotlink::Result<ExportReport> exportCsv(const std::shared_ptr<LogFile>& log, const std::string& streams,
                                          const std::filesystem::path& file, const ExportOptions& options);
/// The same to a stream.
robotlink::Result<ExportReport> writeCsv(const std::shared_ptr<LogFile>& log, const std::string& streams,
                                         std::ostream& out, const ExportOptions& options);

/// Exports streams as JSON lines, one object per message in order of time: stream, log_time in seconds,
/// process, frame, type, and the message in Protobuf's JSON format with the original field names.
robotlink::Result<ExportReport> exportJsonLines(const std::shared_ptr<LogFile>& log,
                                                const std::string& streams, const std::filesystem::path& file,
                                                const ExportOptions& options);
/// The same to a stream.
robotlink::Result<ExportReport> writeJsonLines(const std::shared_ptr<LogFile>& log,
                                               const std::string& streams, std::ostream& out,
                                               const ExportOptions& options);

/// Exports the texts (foxglove.Log) of the selected streams, one per line with time, level and source;
/// further lines of a text are indented.
robotlink::Result<ExportReport> exportTexts(const std::shared_ptr<LogFile>& log, const StreamFilter& streams,
                                            const std::filesystem::path& file, const ExportOptions& options);
/// The same to a stream.
robotlink::Result<ExportReport> writeTexts(const std::shared_ptr<LogFile>& log, const StreamFilter& streams,
                                           std::ostream& out, const ExportOptions& options);

}  // namespace logplayer
