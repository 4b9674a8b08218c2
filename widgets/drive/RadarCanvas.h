// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/drive/RadarPainter.h"
#include "widgets/drive/RadarReadings.h"
#include "widgets/world/WorldDrawings.h"

namespace widgets {

/// Paints a radar and what the robot's program drew relative to itself; wheel and keys zoom. It has no
/// session. Object name "radarCanvas". GUI thread.
class RadarCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit RadarCanvas(QWidget* parent = nullptr);
  /// `drawings` are in the robot's frame. `hint`: a sentence in the middle; empty: none.
  void show(RadarReadings readings, std::vector<WorldDrawing> drawings, const QString& hint);
  const RadarReadings& readings() const { return readings_; }
  /// The look for the current size of the widget.
  RadarLook look() const;
  /// Meters from the middle to the nearer edges; clamped to the limits of RadarLook.
  void zoomBy(double factor) { setRange(look_.range / factor); }
  void setRange(double meters);
  /// Whether up is the map's y axis instead of the robot's x axis.
  void setNorthUp(bool northUp);
  /// The picture that is shown, without the hint.
  QImage rendered() const;
  QSize sizeHint() const override { return {320, 320}; }

 Q_SIGNALS:
  /// The user zoomed.
  void lookChanged();
  /// Polar coordinates of the cursor from the robot: meters, and radians counterclockwise from its x axis;
  /// `inside` is false when the cursor has left.
  void cursorMoved(double distance, double angle, bool inside);

 protected:
  /// Shows what is drawn under the cursor as a tooltip.
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void paintContents(QPainter& painter) const;

  RadarReadings readings_;
  std::vector<WorldDrawing> drawings_;
  QString hint_;
  RadarLook look_;
};

}  // namespace widgets
