// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "robotlink/base/Clock.h"

namespace widgets {

class MotionBench;

/// The key frames of the motion that is edited over time, as wide as they take, with the curves of all
/// joints: a click selects a key frame, dragging its end changes how long it takes, and a mark moves along
/// while the motion is played. Arrow keys select, with Ctrl they change the duration. GUI thread; the bench
/// must outlive it.
class MotionTimeLine final : public QWidget {
  Q_OBJECT
 public:
  explicit MotionTimeLine(MotionBench& bench, QWidget* parent = nullptr);

  /// Sets the time for which the motion has been played; unset: it is not.
  void setPlayed(std::optional<robotlink::Duration> time);
  /// The index of the joint's column whose curve is highlighted; -1: none.
  void setColumn(int column);
  /// The position of a time, pixels.
  double placeOf(robotlink::Duration time) const;
  QSize sizeHint() const override { return {400, 90}; }
  QSize minimumSizeHint() const override { return {120, 48}; }

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  robotlink::Duration total() const;
  /// The height of the scale above the key frames.
  int timesHeight() const;
  robotlink::Duration timeAt(int x) const;
  /// Returns the time at which a key frame ends.
  robotlink::Duration endOf(int frame) const;
  /// The key frame whose end is near; -1: none.
  int endAt(int x) const;
  int frameAt(int x) const;
  void paintFrames(QPainter& painter) const;
  void paintCurves(QPainter& painter) const;
  void paintTimes(QPainter& painter) const;

  MotionBench& bench_;
  std::optional<robotlink::Duration> played_;
  int column_ = -1;
  /// The key frame whose end is dragged; -1: none. Meanwhile the scale stays.
  int dragged_ = -1;
  int drags_ = 0;
  robotlink::Duration scale_{};
};

}  // namespace widgets
