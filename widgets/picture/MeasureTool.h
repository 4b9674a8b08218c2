// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QTransform>
#include <functional>
#include <optional>
#include <vector>

#include "widgets/picture/Measurement.h"

class QAction;
class QLabel;
class QMouseEvent;
class QPainter;
class QWidget;

namespace widgets {

/// Measures in a picture: while the tool is on, a click sets a point, a drag two; a third click measures an
/// angle, the next one starts over. Esc removes the points, and then ends the tool. The result is painted
/// over the picture and written below it, from where it can be copied.
///
/// Object names begin with the view's name: "image" gives imageMeasure, imageMeasureCopy, imageMeasureText,
/// imageMeasureBar. It takes the left button of the mouse from the canvas while it is on. GUI thread; a child
/// of the view, which together with the canvas must outlive it.
class MeasureTool final : public QObject {
  Q_OBJECT
 public:
  /// The scale with which a view measures.
  struct Scale {
    /// From the picture's coordinates to the canvas's pixels.
    std::function<QTransform()> toCanvas;
    /// The position of a canvas point in the picture; unset outside. Rounds to pixels where there are some.
    std::function<std::optional<QPointF>(const QPointF& canvas)> place;
    /// The measurement of one to three points in words.
    std::function<MeasureText(const std::vector<QPointF>& points)> describe;
  };

  MeasureTool(QWidget& view, QWidget& canvas, const char* name, Scale scale);

  /// L: switches it on and off.
  QAction* toggle() const { return toggle_; }
  /// Ctrl+Alt+C: copies the result; disabled without one.
  QAction* copy() const { return copy_; }
  bool isOn() const;
  /// The row with the result, to be placed below the picture; hidden while the tool is off.
  QWidget* bar() const { return bar_; }
  /// Points that were set, at most three.
  const std::vector<QPointF>& points() const { return points_; }
  /// Removes all points.
  void clear();
  /// Describes the points again, since what is below them changed.
  void refresh();
  /// Paints the measurement over the canvas, up to the cursor while points are missing.
  void paint(QPainter& painter) const;

 Q_SIGNALS:
  /// Emitted when the tool is switched on or off.
  void toggled(bool on);

 protected:
  /// Takes mouse and Esc from the canvas.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createBar(const QByteArray& name);
  void press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  /// Removes the points or ends the tool.
  void escape();
  /// The points with the one under the cursor, if one is to be set next.
  std::vector<QPointF> shownPoints() const;

  QWidget& view_;
  QWidget& canvas_;
  const Scale scale_;
  QAction *toggle_ = nullptr, *copy_ = nullptr;
  QWidget* bar_ = nullptr;
  QLabel* text_ = nullptr;
  std::vector<QPointF> points_;
  /// The place under the cursor; unset outside of the picture.
  std::optional<QPointF> hover_;
  /// The point of the canvas where the button was pressed; unset while it is not.
  std::optional<QPointF> pressed_;
};

}  // namespace widgets
