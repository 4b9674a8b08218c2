// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/session/RemoteRobot.h"
#include "widgets/plots/PlotHistory.h"
#include "widgets/plots/items/PlotHatches.h"
#include "widgets/plots/items/PlotLine.h"
#include "widgets/plots/items/PlotMarkers.h"

class QCPAxis;
class QCPAxisRect;
class QCPItemRect;
class QCPItemText;
class QMouseEvent;
class QWheelEvent;
class QCustomPlot;

namespace widgets {

class CurveModel;
class SeriesGraph;
class StateStrip;

/// Draws the curves of a CurveModel over time with QCustomPlot; states are strips below them, in the same
/// time axis. Curves over other ones are left out. The wheel zooms the time axis, or, with Shift or over a
/// value axis, the values; dragging pans; dragging with the right button zooms to a box. All of this emits
/// touched(), upon which the view stops following, and can be undone. A click sets the first cursor, with
/// Shift the second one. Times are seconds on the session's timeline; the labels count from an origin.
/// QCustomPlot gets only the points that are seen, a few for each column of pixels. Lines are one pixel wide
/// and not antialiased, since anything else costs a hundred times as much. Where a program recomputes what
/// a log has, the curve of the log is drawn in a paler color behind. GUI thread.
class PlotCanvas final : public QWidget {
  Q_OBJECT
 public:
  /// The connections of remote robots, by their names.
  using RemoteRobots = std::map<std::string, robotlink::RemoteRobot>;

  /// `curves` must outlive the canvas.
  explicit PlotCanvas(CurveModel& curves, QWidget* parent = nullptr);

  /// Draws what is in the model now. With `follow` the time axis shows [end - length, end] (in s), or all if
  /// `length` is 0, and the value axis all values therein. Where a robot sent nothing, no line is
  /// drawn.
  void refresh(bool follow, double end, double length, const RemoteRobots& robots = {});
  /// Shows all points of all curves.
  void fit();
  /// Shows these times, without a step in the history.
  void showTimes(double from, double to);
  PlotHistory& history() { return history_; }
  /// Shows what was shown before or after; false: there is nothing.
  bool undo() { return showRanges(history_.undo(ranges())); }
  bool redo() { return showRanges(history_.redo(ranges())); }
  /// The ranges of the axes at present.
  PlotRanges ranges() const;
  /// Sets the time that the axis labels as 0 s.
  void setOrigin(double seconds);
  /// Marks the instant that the timeline shows by a dashed line; empty: no line.
  void setMark(std::optional<double> time);
  /// Marks the time under the cursor by a thin line; empty: no line.
  void setCursorLine(std::optional<double> time);
  /// Draws the two cursors at these times; empty: none.
  void setCursors(const std::optional<std::pair<double, double>>& times);
  /// Hatches where values are missing. Drawn by the next refresh().
  void setMissing(std::vector<MissingValues> missing);
  /// Marks what happened when.
  void setMarkers(std::vector<PlotMarker> markers);
  /// Marks where texts are, which tooltips say, in order of time.
  void setTextMarks(std::vector<PlotMarker> marks);
  /// The tooltip at a point: the texts there, or the state; empty: nothing.
  QString toolTipAt(const QPoint& point) const;
  /// The ends of the time axis, in s.
  std::pair<double, double> shownTimes() const;

 Q_SIGNALS:
  /// The user zoomed or panned, or went back to what was shown before.
  void touched();
  /// The same, and the times that are shown became others.
  void timesTouched(double from, double to);
  /// The user set a cursor, the second one or the first.
  void cursorSet(bool isSecond, double time);
  /// The user dropped sources from the tree, as PlotSource::text().
  void sourcesDropped(const QStringList& sources);
  /// Time under the cursor in s; empty: the cursor has left the plot.
  void cursorMoved(std::optional<double> time);

 protected:
  /// Applies a new palette.
  void changeEvent(QEvent* event) override;
  /// Handles drag and drop, presses, clicks, and the cursor leaving the plot.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showGaps();
  /// The times without messages of the robots of a curve, from and to, in s.
  std::vector<std::pair<double, double>> gapsOf(const std::vector<std::string>& streams) const;
  /// Colors axes, grid and lines by the palette.
  void applyTheme();
  /// Makes QCustomPlot's graphs match the model's curves in number and color: two for each, the one of the
  /// log first.
  void matchGraphs();
  /// The same for strips, one for each curve of states.
  void matchStrips();
  /// Gives the strips their room, with their names on the left.
  void layOutStrips(const QStringList& names);
  void createStrips();
  /// Whether a point is in the plot or its strips.
  bool isInside(const QPoint& point) const;
  void showToolTip(const QPoint& point, const QPoint& global);
  /// Shows all times of all curves.
  void fitTimes();
  /// Fits the value axes to the values in the shown time range.
  void fitValues();
  void fitValues(QCPAxis& axis);
  void createItems();
  void connectMouse();
  void pressed(const QMouseEvent& event);
  void released(const QMouseEvent& event);
  void prepareWheel(const QWheelEvent& event);
  /// Adds a step to the history if the user is about to change what is shown.
  void rangeChanged();
  bool showRanges(const std::optional<PlotRanges>& ranges);

  CurveModel& curves_;
  QCustomPlot* plot_;
  QCPAxisRect* strips_ = nullptr;
  /// Two for each curve: of the log, and of what the session published.
  std::vector<SeriesGraph*> graphs_;
  std::vector<StateStrip*> stripGraphs_;
  /// The names of the strips; unset: they must be written again.
  std::optional<QStringList> stripNames_;
  RemoteRobots robots_;
  /// The times without messages, from and to, and the items that shade them.
  std::vector<std::pair<double, double>> gaps_;
  std::vector<QCPItemRect*> shades_;
  std::optional<PlotHatches> hatches_;
  std::optional<PlotLine> mark_, cursor_;
  /// The two cursors, and their names.
  std::vector<PlotLine> lines_;
  std::array<QCPItemText*, 2> names_{};
  std::optional<PlotMarkers> markers_;
  PlotHistory history_;
  /// The ranges before the user pressed a button or turned the wheel; empty once they are in the history.
  std::optional<PlotRanges> before_;
  /// Whether the last change was by the wheel: its next notch belongs to the same step.
  bool isWheeling_ = false;
  QPoint pressedAt_;
};

}  // namespace widgets
