// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <utility>

class QCPItemStraightLine;
class QCustomPlot;

namespace widgets {

class CurveModel;

/// Draws the curves of a CurveModel over time. The wheel zooms the time axis, with Shift (or over the value
/// axis) the values; dragging pans; both end following. Lines are one pixel wide and not antialiased:
/// anything else costs a hundred times as much.
class PlotCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit PlotCanvas(CurveModel& curves, QWidget* parent = nullptr);

  /// Takes new points over and draws. Following: the window [end - length, end] with all values in it.
  void refresh(bool follow, double end, double length);
  /// Everything that there is.
  void fit();
  /// The time that is shown as 0 s, in the curves' seconds.
  void setOrigin(double seconds);
  /// The instant that the time line shows; nothing: no line.
  void setMark(std::optional<double> time);
  /// A thin line at a time that the cursor points at; nothing: no line.
  void setCursorLine(std::optional<double> time);
  bool savePng(const QString& file);
  /// The first and the last second that are shown.
  std::pair<double, double> shownTimes() const;

 Q_SIGNALS:
  /// Somebody zoomed or panned.
  void touched();
  void sourcesDropped(const QStringList& sources);
  /// The cursor points at this time; nothing: it has left the curves.
  void cursorMoved(std::optional<double> time);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void applyTheme();
  void matchGraphs();
  void fitValues();

  CurveModel& curves_;
  QCustomPlot* plot_;
  QCPItemStraightLine* mark_;
  QCPItemStraightLine* cursor_;
};

}  // namespace widgets
