// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "logplayer/base/Progress.h"
#include "logplayer/file/LogFile.h"

namespace logplayer {

/// A query for the next or previous change of a value in a log.
struct ChangeQuery {
  /// The value (robotlink/expressions/EXPRESSIONS.md); streams as in the log.
  std::string expression;
  /// The robot of streams that are named without one.
  std::string robot = {};
  /// Set: only changes count at which the value reaches this, or falls below it.
  std::optional<double> limit = {};
  /// The instant at which the search begins, in log time; a change at this very instant does not count.
  robotlink::Instant from = {};
  bool isForward = true;
};

/// Finds the nearest instant at which a value of a log changes, without playing the log: a value that appears
/// is a change, too. Messages of the same time count together. Empty if there is none. Fails if the
/// expression does not fit the log, or with "log.given-up" if `progress` returns false; it is asked now and
/// then, with 0.
robotlink::Result<std::optional<robotlink::Instant>> findChange(const std::shared_ptr<LogFile>& log,
                                                                const ChangeQuery& query,
                                                                const Progress& progress = {});

}  // namespace logplayer
