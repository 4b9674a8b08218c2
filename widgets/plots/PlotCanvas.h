// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/session/RemoteRobot.h"

class QCPItemRect;
class QCPItemStraightLine;
class QCustomPlot;

namespace widgets {

class CurveModel;
class SeriesGraph;

/// Draws the curves of a CurveModel over time with QCustomPlot. The wheel zooms the time axis, or, with Shift
/// or over the value axis, the values; dragging pans; both emit touched(), upon which the view stops
/// following. Times are seconds on the session's timeline; the labels count from an origin. QCustomPlot gets
/// only the points that are seen, a few for each column of pixels. Lines are one pixel wide and not
/// antialiased, since anything else costs a hundred times as much. Where a program computes anew what a log
/// has, the curve of the log is drawn in a paler color behind. GUI thread.
class PlotCanvas final : public QWidget {
  Q_OBJECT
 public:
  /// How robots elsewhere are connected, by their names.
  using RemoteRobots = std::map<std::string, robotlink::RemoteRobot>;

  /// `curves` must outlive the canvas.
  explicit PlotCanvas(CurveModel& curves, QWidget* parent = nullptr);

  /// Draws what is in the model now. With `follow` the time axis shows [end - length, end] (in s), or all if
  /// `length` is 0, and the value axis all values therein. Where nothing was heard of a robot, no line is
  /// drawn.
  void refresh(bool follow, double end, double length, const RemoteRobots& robots = {});
  /// Shows all points of all curves.
  void fit();
  /// Sets the time that the axis labels as 0 s.
  void setOrigin(double seconds);
  /// Marks the instant that the timeline shows by a dashed line; empty: no line.
  void setMark(std::optional<double> time);
  /// Marks the time under the cursor by a thin line; empty: no line.
  void setCursorLine(std::optional<double> time);
  /// Writes what is shown, at twice the resolution of the screen. False if the file cannot be written.
  bool savePng(const QString& file);
  /// The ends of the time axis, in s.
  std::pair<double, double> shownTimes() const;

 Q_SIGNALS:
  /// The user zoomed or panned.
  void touched();
  /// The user dropped sources from the tree, as PlotSource::text().
  void sourcesDropped(const QStringList& sources);
  /// Time under the cursor in s; empty: the cursor has left the plot.
  void cursorMoved(std::optional<double> time);

 protected:
  /// Applies a new palette.
  void changeEvent(QEvent* event) override;
  /// Handles drag and drop, and the cursor leaving the plot.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showGaps();
  /// Colors axes, grid and lines by the palette.
  void applyTheme();
  /// Makes QCustomPlot's graphs match the model's curves in number and color: two for each, the one of the
  /// log first.
  void matchGraphs();
  /// Shows all times of all curves.
  void fitTimes();
  /// Fits the value axis to the values in the shown time range.
  void fitValues();

  CurveModel& curves_;
  QCustomPlot* plot_;
  QCPItemStraightLine* mark_;
  /// Two for each curve: of the log, and of what the session published.
  std::vector<SeriesGraph*> graphs_;
  RemoteRobots robots_;
  /// The times in which nothing was heard, from and to, and the items that shade them.
  std::vector<std::pair<double, double>> gaps_;
  std::vector<QCPItemRect*> shades_;
  QCPItemStraightLine* cursor_;
};

}  // namespace widgets
