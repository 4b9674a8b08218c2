// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "logplayer/base/ImportOptions.h"
#include "logplayer/base/ImportReport.h"
#include "logplayer/base/ImportSink.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// A format of logs that are not MCAP files. They are converted when they are opened, and by
/// `robotctl log import`. A plain value.
struct LogFormat {
  /// The robot in such logs.
  struct Robot {
    /// The name of the robot unless the user enters one.
    const char* name = nullptr;
    /// The resource that describes it, "robots/nao.yaml": the layout of the program that replays such logs,
    /// the packages in them, the field and the teams. Null: the robot is unknown, and no program runs on such
    /// logs.
    const char* description = nullptr;
  };

  /// "B-Human message queue".
  const char* name = nullptr;
  Robot (*robot)() = nullptr;
  /// Whether the file, or folder, has this format, judged by its contents. Any thread; must not throw.
  bool (*recognizes)(const std::filesystem::path& file) = nullptr;
  /// Passes all frames of a file to `sink`, with the streams of the robot `options.robot`. Messages that are
  /// not of this project's types name a process, so that they are known to be of a robot. Fails if nothing
  /// can be read, if the sink fails, or with "log.given-up" if `options.progress` returns false. Any thread.
  robotlink::Result<ImportReport> (*import)(const std::filesystem::path& from, const ImportSink& sink,
                                            const ImportOptions& options) = nullptr;
};

/// All log formats, ordered by name. A file that several formats recognize is read by the first of them.
const std::vector<LogFormat>& registeredLogFormats();

/// Registers a format when it is constructed: before main(), or while a plug-in is loaded.
class [[maybe_unused]] LogFormatRegistration {
 public:
  explicit LogFormatRegistration(const LogFormat& format);
};

}  // namespace logplayer
