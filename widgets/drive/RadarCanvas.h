// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/drive/RadarPainter.h"
#include "widgets/models/RadarReadings.h"
#include "widgets/models/WorldDrawings.h"

namespace widgets {

/// Paints a radar and what the robot's program drew relative to itself; wheel and keys zoom. It knows no
/// session. Object name "radarCanvas".
class RadarCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit RadarCanvas(QWidget* parent = nullptr);
  /// `drawings` are in the robot's frame. `hint`: a sentence in the middle; empty: none.
  void show(RadarReadings readings, std::vector<WorldDrawing> drawings, const QString& hint);
  const RadarReadings& readings() const { return readings_; }
  RadarLook look() const;
  void setRange(double metres);
  void setNorthUp(bool northUp);
  QImage rendered() const;
  QSize sizeHint() const override { return {320, 320}; }

 Q_SIGNALS:
  void lookChanged();
  /// Polar, from the robot: metres and radians to the left; `inside` is false when the cursor has left.
  void cursorMoved(double distance, double angle, bool inside);

 protected:
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
