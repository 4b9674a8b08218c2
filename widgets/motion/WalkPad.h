// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QWidget>
#include <optional>

#include "widgets/motion/MeasuredSpeed.h"
#include "widgets/motion/MotionCommander.h"

namespace widgets {

/// A pad for walking: press and drag for a direction (up is forward), or hold W/A/S/D or the arrow keys, Q
/// and E to turn; Shift halves the speed. Robots on wheels cannot move sideways: for them left and right
/// turn. All axes return to zero when button or keys are released, the focus leaves, or the pad is hidden.
/// The pad paints the commanded vector (filled) and the measured one (outlined). It sends nothing; MotionView
/// reads axes() in every tick. GUI thread.
class WalkPad final : public QWidget {
  Q_OBJECT
 public:
  /// All that paint() needs.
  struct Picture {
    /// The commanded deflection, -1 to 1.
    WalkAxes asked;
    /// The measured speed as a share of the limits; may exceed 1, and is then drawn at the border.
    std::optional<WalkAxes> measured;
    /// Whether the user has manual control.
    bool enabled = false;
    /// Whether the pad is that of a robot on wheels, a square.
    bool wheels = false;
    /// Shown in the middle while the pad is not enabled.
    QString hint;
  };

  explicit WalkPad(QWidget* parent = nullptr);
  /// The current deflection by mouse and keys, -1 to 1.
  const WalkAxes& axes() const { return axes_; }
  /// Whether left and right turn instead of moving sideways. Releases everything if it changes.
  void setWheels(bool wheels);
  /// Returns all axes to zero, as if button and keys were released.
  void release();
  void show(Picture picture);
  /// Pure; the pad is centered in `rect`.
  static void paint(QPainter& painter, const QRectF& rect, const Picture& picture, const QPalette& palette);

  QSize sizeHint() const override { return {200, 200}; }
  QSize minimumSizeHint() const override { return {120, 120}; }

 Q_SIGNALS:
  /// axes() changed.
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
  /// Sets the axes from a position of the mouse.
  void follow(const QPointF& position);
  /// Sets the axes from the keys that are held.
  void useKeys(bool halved);
  void setAxes(const WalkAxes& axes);
  /// Sets the tooltip and the accessible name.
  void describeUse();

  WalkAxes axes_;
  Picture picture_;
  bool wheels_ = false;
  /// The keys that are held down (Qt::Key).
  QSet<int> keys_;
};

}  // namespace widgets
