// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "robotlink/series/Series.h"
#include "widgets/plots/PlotSource.h"

namespace widgets {

/// The values of a whole log for a curve, as far as they have been read.
struct LoggedCurve {
  /// Times are seconds on the session's timeline.
  robotlink::Series series = {};
  /// Set for values that are states.
  StateNames names = {};
  /// The reason why there are no values; empty if there are.
  QString problem = {};
  bool isComplete = false;
  /// The log has more points than there is memory for.
  bool isCut = false;
};

}  // namespace widgets
