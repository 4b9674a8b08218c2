// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "logplayer/base/Progress.h"
#include "logplayer/edit/LogCut.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/Worker.h"

namespace app {

/// Writes parts of logs to new files, in a thread of its own. One job at a time; the destructor ends it, and
/// nothing is left of its file then. All functions in the thread of the owner.
class LogWriteJob {
 public:
  /// The export of one log.
  struct Export {
    enum class Kind : std::uint8_t { kImages, kCsv, kJson, kTexts };
    Kind kind = Kind::kTexts;
    std::filesystem::path log = {};
    /// A selection of streams: "red1/*,-*/camera/*".
    std::string streams = {};
    /// In the log's own times; unset: from its start, to its end.
    std::optional<robotlink::Instant> from = {}, to = {};
    /// A folder of images, otherwise a file. Existing files are not replaced.
    std::filesystem::path target = {};
  };

  LogWriteJob();
  /// Writes a new log; see rewriteLogs(). Like the next one fails if a job runs.
  robotlink::Result<void> cut(logplayer::RewriteOptions options, std::filesystem::path to);
  robotlink::Result<void> exportLog(Export what);
  /// Whether a job runs. Fails, once, with why it failed, or with what could not be read although the rest
  /// was written.
  robotlink::Result<bool> working();

 private:
  using Work = std::function<robotlink::Result<void>(const logplayer::Progress&)>;
  robotlink::Result<void> begin(Work work);

  bool isRunning_ = false;
  robotlink::Worker<Work, robotlink::Result<void>> worker_;
};

}  // namespace app
