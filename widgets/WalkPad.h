// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QWidget>
#include <optional>

#include "widgets/models/MeasuredSpeed.h"
#include "widgets/models/MotionCommander.h"

namespace widgets {

/// A pad to walk by: press and drag for a direction (up is forwards), or hold W/A/S/D or the arrows, Q and E
/// to turn; Shift halves. Robots on wheels cannot go sideways: for them left and right turn. All is zero as
/// soon as button or keys are released or the focus goes. Shows what is asked for (filled) and what is
/// measured (outlined).
class WalkPad final : public QWidget {
  Q_OBJECT
 public:
  /// What paint() needs.
  struct Picture {
    WalkAxes asked;                    ///< -1 to 1
    std::optional<WalkAxes> measured;  ///< as shares of the limits
    bool enabled = false;
    bool wheels = false;
    QString hint;  ///< in the middle, while not enabled
  };

  explicit WalkPad(QWidget* parent = nullptr);
  const WalkAxes& axes() const { return axes_; }
  /// For a robot on wheels.
  void setWheels(bool wheels);
  /// Lets go of everything.
  void release();
  void show(Picture picture);
  static void paint(QPainter& painter, const QRectF& rect, const Picture& picture, const QPalette& palette);

  QSize sizeHint() const override { return {200, 200}; }
  QSize minimumSizeHint() const override { return {120, 120}; }

 Q_SIGNALS:
  void moved();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void follow(const QPointF& position);
  void useKeys(bool halved);
  void setAxes(const WalkAxes& axes);
  void describeUse();

  WalkAxes axes_;
  Picture picture_;
  bool wheels_ = false;
  QSet<int> keys_;  // held down
};

}  // namespace widgets
