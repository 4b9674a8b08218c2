// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/base/Clock.h"
#include "widgets/log/LogJob.h"

namespace widgets {

// What can be done to logs beside looking at them. Each function returns work for a LogJob.

using LogRange = std::optional<std::pair<robotlink::Instant, robotlink::Instant>>;  ///< unset: all of it

/// A part of one or several logs (path and offset each) as a new one; the range is in times of the new one.
LogJob::Work cutLogs(std::vector<std::pair<std::string, robotlink::Duration>> logs, LogRange range,
                     std::filesystem::path to);
/// Ranges in times of the log.
LogJob::Work exportImagesOf(std::string log, std::string stream, LogRange range,
                            std::filesystem::path folder);
LogJob::Work exportTableOf(std::string log, std::string stream, LogRange range, std::filesystem::path file);
LogJob::Work exportTextsOf(std::string log, LogRange range, std::filesystem::path file);
LogJob::Work repairLog(std::string log, std::filesystem::path to);

}  // namespace widgets
