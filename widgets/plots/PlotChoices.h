// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "robotlink/session/StreamStore.h"
#include "widgets/plots/PlotSource.h"

namespace widgets {

/// A value that can be plotted, now or when it is published.
struct PlotChoice {
  PlotSource source;
  /// The reason why it is not published now, as a sentence; empty: it is.
  QString missing = {};
  /// Whether it can be plotted; else its stream is known, but its contents are not yet.
  bool isPlottable = true;
};

/// A stream of an open log, by its path in the session.
struct LoggedStream {
  std::string path, type;
};

/// Everything that can be plotted: plot values, numbers, states and texts of all streams of the session;
/// those of packages that the robots' processes exchange but do not publish; those behind debug keys that are
/// off; and those of the open logs that were not played yet. Images, drawings, texts of the program and
/// tables are left out. Streams are in natural order ("sonar 2" before "sonar 10"), fields in the order of
/// their messages.
std::vector<PlotChoice> plotChoices(const robotlink::StreamStore& store,
                                    const std::vector<LoggedStream>& logged = {});

/// The newest tables of debug keys of all robots: as long as they and the store's list of streams are the
/// same, so is what can be plotted.
std::vector<robotlink::PackagePtr> keyTables(const robotlink::StreamStore& store);

}  // namespace widgets
