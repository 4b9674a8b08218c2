// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "widgets/field/FieldFigures.h"
#include "widgets/field/FieldViewport.h"
#include "widgets/models/WorldDrawings.h"

namespace robotlink {
struct FieldDescription;
}

namespace widgets {

/// Paints the field, drawings and figures from above, and turns the mouse into zooming, panning and dragging
/// of figures. It knows no session: the view sets what is shown and does what is wanted. Object name
/// "fieldCanvas".
class FieldCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit FieldCanvas(std::shared_ptr<const robotlink::FieldDescription> field, QWidget* parent = nullptr);

  /// Null: none is known, and nothing is painted below the figures.
  void setField(std::shared_ptr<const robotlink::FieldDescription> field);
  void setContents(FieldFigures figures, std::vector<WorldDrawing> drawings);
  const FieldFigures& figures() const { return figures_; }
  void setWanted(std::optional<WantedPlace> place);
  /// A sentence at the upper edge; empty: none.
  void setNotice(const QString& text);
  /// The models that dragging moves; without `always` only with the Shift key.
  void setMovable(std::vector<std::string> models, bool always);

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

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  enum class Mode : std::uint8_t { kIdle, kPanning, kDragging };
  QSizeF extent() const;
  void paintContents(QPainter& painter) const;
  /// The model that a drag would move from here; empty: none.
  std::string modelAt(const QPointF& at, Qt::KeyboardModifiers modifiers) const;
  void updateHighlight(const QPointF& at, Qt::KeyboardModifiers modifiers);
  void panBy(const QPointF& by);

  std::shared_ptr<const robotlink::FieldDescription> field_;
  FieldFigures figures_;
  std::vector<WorldDrawing> drawings_;
  std::optional<WantedPlace> wanted_;
  QString notice_;
  std::vector<std::string> movable_;
  bool moveAlways_ = true;
  FieldViewport viewport_;
  Mode mode_ = Mode::kIdle;
  QPointF last_;
};

}  // namespace widgets
