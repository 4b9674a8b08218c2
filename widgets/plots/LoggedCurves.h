// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <string>

#include "logplayer/search/NumberReader.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/plots/LoggedCurve.h"
#include "widgets/plots/PlotSource.h"

namespace widgets {

/// Fills curves from the open logs in the background, without playing them. All plots of a window share it,
/// so that a log is read once for all curves. Nothing is read for a curve that is no longer used. GUI
/// thread; owned by the logs.
class LoggedCurves final : public QObject {
  Q_OBJECT
 public:
  /// Bound of the memory for the points of all curves of all logs.
  static constexpr std::size_t kMaxBytes = 512U << 20U;

  /// The curves of a window, created on the first call.
  static LoggedCurves& of(OpenLogs& logs);

  /// The curve of a source, which is filled from now on; null if no open log has the stream, or all streams
  /// of its expression.
  std::shared_ptr<const LoggedCurve> curve(const PlotSource& source);
  /// Takes what was read. May be called by several views in each tick.
  void tick();
  /// "Reading game.mcap: 43 %", or why it cannot be read; empty if nothing is being read.
  QString stateText() const;

 private:
  /// An open log of which curves were requested.
  struct Log {
    std::unique_ptr<logplayer::NumberReader> reader;
    /// The offset that was added to the times of the curves.
    robotlink::Duration offset{0};
    std::map<logplayer::LogNumber, std::weak_ptr<LoggedCurve>> curves = {};
    /// The numbers that the reader reads.
    std::set<logplayer::LogNumber> read = {};
    double progress = 0;
    QString failure = {};
  };

  explicit LoggedCurves(OpenLogs& logs);
  /// The number in a log that is the source; empty if the log lacks something that is needed.
  static std::optional<logplayer::LogNumber> numberIn(const OpenLogs::Log& log, const PlotSource& source);
  /// The memory that each curve may take.
  std::size_t share() const;
  void follow(Log& log, robotlink::Duration offset);
  void take(Log& log);
  /// Tells the reader what is still wanted.
  static void read(Log& log);

  OpenLogs& logs_;
  /// Keyed by path.
  std::map<std::string, Log> readers_;
};

}  // namespace widgets
