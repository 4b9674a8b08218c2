// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "widgets/field/FieldFigures.h"
#include "widgets/field/FieldViewport.h"
#include "widgets/field/GoalFigures.h"
#include "widgets/world/WorldDrawings.h"

namespace robotcontrol {
class GroundMap;
}
namespace robotlink {
struct FieldDescription;
}

namespace widgets {

class MapGround;
class MeasureTool;

/// Paints the field or the map of a building from above, with drawings and figures, and turns the mouse into
/// zooming, panning, dragging of figures and choosing of goals. It has no session: the view sets what is
/// shown and applies what the signals say. Coordinates in signals are meters in the field's frame. Object
/// name "fieldCanvas". GUI thread.
class FieldCanvas final : public QWidget {
  Q_OBJECT
 public:
  /// `field` as in setField().
  explicit FieldCanvas(std::shared_ptr<const robotlink::FieldDescription> field, QWidget* parent = nullptr);
  ~FieldCanvas() override;

  /// Null: none is known; a grid is painted instead.
  void setField(std::shared_ptr<const robotlink::FieldDescription> field);
  /// A map, which is painted instead of the field; null: none. Resets the viewport if it replaces another
  /// map.
  void setMap(std::shared_ptr<const robotcontrol::GroundMap> map);
  /// Null: there is none.
  const robotcontrol::GroundMap* map() const;
  /// Paths and goals to be painted.
  void setGoals(GoalFigures goals);
  const GoalFigures& goals() const { return goals_; }
  /// Robots, ball and trails, and the drawings on top of them, lowest first.
  void setContents(FieldFigures figures, std::vector<WorldDrawing> drawings);
  const FieldFigures& figures() const { return figures_; }
  /// The place to which a model is being dragged; unset: none.
  void setWanted(std::optional<WantedPlace> place);
  /// A sentence at the upper edge; empty: none.
  void setNotice(const QString& text);
  /// The models that can be dragged; without `always` only while Shift is held.
  void setMovable(std::vector<std::string> models, bool always);
  /// Whether pressing the left button begins to choose a goal; if `possible` without `always`, only while
  /// Control is held.
  void setAiming(bool possible, bool always);
  /// Paints what is measured over the field; while that tool is on, nothing is moved or chosen. It must
  /// outlive the canvas's last event.
  void setMeasure(const MeasureTool* measure) { measure_ = measure; }
  /// Ends the choice of a goal; no further aim signals follow until the next press.
  void abandonAim();

  const FieldViewport& viewport() const { return viewport_; }
  void setViewport(const FieldViewport& viewport);
  /// Zooms around the middle.
  void zoomBy(double factor);
  /// From the field's frame to the widget.
  QTransform transform() const;
  /// The picture that is shown, without the notice.
  QImage rendered() const;
  QSize sizeHint() const override { return {480, 320}; }

 Q_SIGNALS:
  /// The visible part of the ground changed, by the user or by a setter.
  void viewportChanged();
  /// `inside` is false when the cursor has left; the position is 0 then.
  void cursorMoved(double x, double y, bool inside);
  /// The user drags a model; turning is by the wheel, in rad, counterclockwise.
  void dragStarted(const QString& model, double x, double y);
  void dragMoved(double x, double y);
  void dragTurned(double angle);
  void dragEnded();
  /// The user pressed and released the left button on a robot without moving it.
  void robotClicked(const QString& robot);
  /// The user chooses a goal. `place`: index of the map's place that was pressed; -1: none.
  void aimStarted(double x, double y, int place);
  void aimMoved(double x, double y);
  void aimEnded();

 protected:
  /// Shows what is drawn under the cursor as a tooltip.
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  /// The action of the pressed button.
  enum class Mode : std::uint8_t { kIdle, kPanning, kDragging, kAiming };
  /// The area that a fitted viewport shows, m.
  QRectF extent() const;
  /// Paints map, field or grid. `ratio`: device pixels per logical pixel.
  void paintGround(QPainter& painter, const QTransform& toWidget, double ratio) const;
  /// Whether a press of a button chooses a goal.
  bool aims(const QMouseEvent& event) const;
  /// Updates the highlighted place of the map.
  void updatePlace(const QPointF& at);
  void paintContents(QPainter& painter, double ratio) const;
  /// The model that a drag from here would move; empty: none.
  std::string modelAt(const QPointF& at, Qt::KeyboardModifiers modifiers) const;
  /// Whether the left button measures.
  bool measures() const;
  /// Updates the highlighted model and the mouse cursor.
  void updateHighlight(const QPointF& at, Qt::KeyboardModifiers modifiers);
  void panBy(const QPointF& by);
  /// Emits robotClicked() if a robot is at the point.
  void click(const QPointF& at);

  std::shared_ptr<const robotlink::FieldDescription> field_;
  /// Null: there is no map.
  std::unique_ptr<MapGround> map_;
  GoalFigures goals_;
  /// Index of the map's place under the cursor; -1: none.
  int place_ = -1;
  bool aimPossible_ = false, aimAlways_ = false;
  FieldFigures figures_;
  std::vector<WorldDrawing> drawings_;
  const MeasureTool* measure_ = nullptr;
  std::optional<WantedPlace> wanted_;
  QString notice_;
  std::vector<std::string> movable_;
  bool moveAlways_ = true;
  FieldViewport viewport_;
  Mode mode_ = Mode::kIdle;
  QPointF last_, pressed_;
  /// Whether the mouse has moved since the press by more than a hand does during a click.
  bool moved_ = false;
};

}  // namespace widgets
