// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "logplayer/base/Progress.h"
#include "robotlink/base/Clock.h"

namespace logplayer {

/// Options of all exports.
struct ExportOptions {
  /// The range [from, to] to export; unset: from the start, to the end.
  std::optional<robotlink::Instant> from = {}, to = {};
  /// Whether existing files are replaced; otherwise they must not exist.
  bool overwrite = false;
  Progress progress = {};
};

/// The result of an export.
struct ExportReport {
  /// Number of images, rows or texts.
  std::uint64_t written = 0;
  /// The data that is missing, one sentence each; empty if everything was exported.
  std::vector<std::string> losses;
};

}  // namespace logplayer
