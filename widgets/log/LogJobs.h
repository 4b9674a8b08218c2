// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "logplayer/base/StreamFilter.h"
#include "robotlink/base/Clock.h"
#include "widgets/log/LogJob.h"

// Operations on logs. Each function returns the work for a LogJob; all arguments are copied into it. Errors
// become the outcome's text.
namespace widgets {

/// A closed range of times; unset: the whole log.
using LogRange = std::optional<std::pair<robotlink::Instant, robotlink::Instant>>;

/// Writes a part of one or several logs (path and offset each) into a new log. `range` is in times of the new
/// log, that is, with offsets added. Only streams that the filter has, by their paths in the logs.
LogJob::Work cutLogs(std::vector<std::pair<std::string, robotlink::Duration>> logs, LogRange range,
                     std::filesystem::path to, logplayer::StreamFilter streams = {});
/// Writes the images of a stream as files into a folder. Like the following ones it takes a range in the
/// log's own times.
LogJob::Work exportImagesOf(std::string log, std::string stream, LogRange range,
                            std::filesystem::path folder);
/// Writes the fields of a stream's messages as a table.
LogJob::Work exportTableOf(std::string log, std::string stream, LogRange range, std::filesystem::path file);
/// Writes the text messages of all robots.
LogJob::Work exportTextsOf(std::string log, LogRange range, std::filesystem::path file);
/// Writes what can be read of a damaged log into a new one.
LogJob::Work repairLog(std::string log, std::filesystem::path to);

}  // namespace widgets
