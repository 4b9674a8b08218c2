// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "widgets/timing/GanttPaint.h"

namespace robotlink {
class Session;
}

namespace widgets {

/// The Gantt chart of a robot's processes: a lane for each, in it a bar for each frame, and below this the
/// frame's tasks. A tooltip describes what is under the mouse; a click requests the time of a frame, or that
/// of the place; the wheel zooms, dragging moves the chart.
///
/// It follows the instant that the timeline shows, which is near its right edge then, until the user moves
/// it or clicks; then it stops, so that what was clicked stays in sight. It follows again when the
/// user wants it to or goes live, and moves when the timeline jumps out of it. GUI thread.
class GanttCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit GanttCanvas(QWidget* parent = nullptr);

  /// Shows what the session's history has of a robot. `periods`: see ganttLanes(). Returns early if nothing
  /// changed. Called in each tick.
  void refresh(robotlink::Session& session, const std::string& robot,
               const std::map<std::string, double>& periods);
  const GanttLook& look() const { return look_; }

  bool follows() const { return follows_; }
  void setFollow(bool follow);
  /// The time that the chart spans, s; clamped to [kMinSpan, kMaxSpan].
  double span() const { return span_; }
  void setSpan(double seconds);
  static constexpr double kMinSpan = 0.001, kMaxSpan = 120;
  /// Zooms in by `factor` (above 1) around the shown instant while the chart follows it, else its middle.
  void zoom(double factor);
  QSize sizeHint() const override { return {500, kGanttRuler + 3 * 44}; }
  QSize minimumSizeHint() const override { return {160, kGanttRuler + kMinGanttLane}; }

 Q_SIGNALS:
  /// The user clicked at this time.
  void jumpWanted(robotlink::Instant time);
  void followChanged(bool follows);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// The contents that decide whether the picture changed: the store's messages of these streams.
  struct Contents {
    std::string robot;
    std::uint64_t generation = 0, messages = 0;
    bool operator==(const Contents&) const = default;
  };
  /// Sets the axis: its zoom, and its begin while the chart follows.
  void place();
  /// Decides whether the chart continues standing still.
  void followTimeline(robotlink::Session& session);
  void zoomAt(double x, double factor);
  void moveBy(double pixels);
  /// Gives new tasks colors.
  void nameTasks();

  GanttLook look_;
  Contents contents_;
  double span_ = 2;
  bool follows_ = true;
  bool wasLive_ = true;
  /// The axis changed since the lanes were read.
  bool isMoved_ = true;
  /// The point at which the left button was pressed, or to which the chart was dragged; unset: not pressed.
  std::optional<QPoint> pressed_;
  bool isDragged_ = false;
  QPoint dragged_;
};

}  // namespace widgets
