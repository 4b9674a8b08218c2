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
#include "widgets/models/WorldDrawings.h"

namespace robotcontrol {
class GroundMap;
}
namespace robotlink {
struct FieldDescription;
}

namespace widgets {

class MapGround;

/// Paints the field or the map of a building, drawings and figures from above, and turns the mouse into
/// zooming, panning, dragging of figures and aiming at goals. It knows no session: the view sets what is
/// shown and does what is wanted. Object name "fieldCanvas".
class FieldCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit FieldCanvas(std::shared_ptr<const robotlink::FieldDescription> field, QWidget* parent = nullptr);
  ~FieldCanvas() override;

  /// Null: none is known, and nothing is painted below the figures.
  void setField(std::shared_ptr<const robotlink::FieldDescription> field);
  /// Is painted instead of the field; null: there is none.
  void setMap(std::shared_ptr<const robotcontrol::GroundMap> map);
  const robotcontrol::GroundMap* map() const;
  void setGoals(GoalFigures goals);
  void setContents(FieldFigures figures, std::vector<WorldDrawing> drawings);
  const FieldFigures& figures() const { return figures_; }
  void setWanted(std::optional<WantedPlace> place);
  /// A sentence at the upper edge; empty: none.
  void setNotice(const QString& text);
  /// The models that dragging moves; without `always` only with the Shift key.
  void setMovable(std::vector<std::string> models, bool always);
  /// Whether a press of the left button aims at a goal; `possible` without `always`: only with the Control
  /// key.
  void setAiming(bool possible, bool always);
  bool aiming() const { return mode_ == Mode::kAiming; }
  /// The press that aims now will say nothing more.
  void abandonAim();

  const FieldViewport& viewport() const { return viewport_; }
  void setViewport(const FieldViewport& viewport);
  void zoomBy(double factor);
  QTransform transform() const;
  QImage rendered() const;
  QSize sizeHint() const override { return {480, 320}; }

 Q_SIGNALS:
  void viewportChanged();
  /// Metres in the field's frame; `inside` is false when the cursor has left.
  void cursorMoved(double x, double y, bool inside);
  void dragStarted(const QString& model, double x, double y);
  void dragMoved(double x, double y);
  void dragTurned(double angle);
  void dragEnded();
  /// Pressed and released without being moved.
  void robotClicked(const QString& robot);
  /// `place`: the one of the map that was pressed; -1: none.
  void aimStarted(double x, double y, int place);
  void aimMoved(double x, double y);
  void aimEnded();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  enum class Mode : std::uint8_t { kIdle, kPanning, kDragging, kAiming };
  QRectF extent() const;
  void paintGround(QPainter& painter, const QTransform& toWidget, double ratio) const;
  bool aims(const QMouseEvent& event) const;
  void updatePlace(const QPointF& at);
  void paintContents(QPainter& painter, double ratio) const;
  /// The model that a drag would move from here; empty: none.
  std::string modelAt(const QPointF& at, Qt::KeyboardModifiers modifiers) const;
  void updateHighlight(const QPointF& at, Qt::KeyboardModifiers modifiers);
  void panBy(const QPointF& by);
  void click(const QPointF& at);

  std::shared_ptr<const robotlink::FieldDescription> field_;
  std::unique_ptr<MapGround> map_;
  GoalFigures goals_;
  int place_ = -1;  // of the map, under the cursor
  bool aimPossible_ = false, aimAlways_ = false;
  FieldFigures figures_;
  std::vector<WorldDrawing> drawings_;
  std::optional<WantedPlace> wanted_;
  QString notice_;
  std::vector<std::string> movable_;
  bool moveAlways_ = true;
  FieldViewport viewport_;
  Mode mode_ = Mode::kIdle;
  QPointF last_, pressed_;
  bool moved_ = false;  // since the press, and farther than a hand moves while it clicks
};

}  // namespace widgets
