// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <map>
#include <memory>
#include <set>

#include "logplayer/search/NumberReader.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/plots/LoggedCurve.h"
#include "widgets/plots/PlotSource.h"

namespace robotlink {
class Session;
}

namespace widgets {

/// Reads the values of curves that the history of live robots has on disk, in the background. All plots and
/// the timeline of a window share it: what is wanted while something is read waits, and is then read in one
/// pass. Nothing is read for a curve that is no longer used. GUI thread; owned by the logs.
class HistoryCurves final : public QObject {
  Q_OBJECT
 public:
  /// Bound of the memory for the values of all curves while they are read; the newest ones stay.
  static constexpr std::size_t kMaxBytes = 256U << 20U;

  /// The curves of a window, created on the first call.
  static HistoryCurves& of(OpenLogs& logs);

  /// The values of a source that are on disk, which are read from one of the next ticks on. What is added to
  /// the history later is not among them.
  std::shared_ptr<const LoggedCurve> curve(const PlotSource& source);
  /// Takes what was read. May be called by several views in each tick.
  void tick(robotlink::Session& session);
  /// "Reading the history: 43 %"; empty if nothing is being read.
  QString stateText() const;

 private:
  using Curves = std::map<logplayer::LogNumber, std::weak_ptr<LoggedCurve>>;

  explicit HistoryCurves(OpenLogs& logs) : QObject(&logs) {}
  /// Begins to read what waits.
  void begin(robotlink::Session& session);
  void take();

  Curves waiting_;
  /// The curves that the reader reads together; null if nothing is read.
  Curves curves_;
  std::unique_ptr<logplayer::NumberReader> reader_;
  std::set<logplayer::LogNumber> read_;
  double progress_ = 0;
  /// The store's restarts when the reader began.
  std::uint64_t generation_ = 0;
};

}  // namespace widgets
