// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/FieldCanvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "robotlink/config/FieldDescription.h"
#include "widgets/Sentence.h"
#include "widgets/field/FieldPainter.h"
#include "widgets/field/GroundDrawing.h"
#include "widgets/models/Theme.h"

namespace widgets {
namespace {

using robotlink::Vector2;

constexpr double kGrabTolerance = 6;  // pixels around a figure
constexpr double kPanStep = 30;       // pixels for an arrow key
constexpr double kTurnStep = robotlink::radians(15);

}  // namespace

FieldCanvas::FieldCanvas(std::shared_ptr<const robotlink::FieldDescription> field, QWidget* parent)
    : QWidget(parent), field_(std::move(field)) {
  setObjectName(QStringLiteral("fieldCanvas"));
  setAccessibleName(tr("Field"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(120, 80);
  setToolTip(
      tr("Wheel: zoom; drag: move the picture; drag a robot or the ball (Shift: always): place it, wheel: "
         "turn it; arrows: move; F: fit; R: turn"));
  setToolTipDuration(4000);
}

void FieldCanvas::setField(std::shared_ptr<const robotlink::FieldDescription> field) {
  if (field == field_) return;
  field_ = std::move(field);
  update();
  Q_EMIT viewportChanged();
}

void FieldCanvas::setContents(FieldFigures figures, std::vector<WorldDrawing> drawings) {
  figures.highlighted = figures_.highlighted;
  figures_ = std::move(figures);
  drawings_ = std::move(drawings);
  update();
}

void FieldCanvas::setWanted(std::optional<WantedPlace> place) {
  if (!place && !wanted_) return;
  wanted_ = std::move(place);
  update();
}

void FieldCanvas::setNotice(const QString& text) {
  if (text == notice_) return;
  notice_ = text;
  update();
}

void FieldCanvas::setMovable(std::vector<std::string> models, bool always) {
  movable_ = std::move(models);
  moveAlways_ = always;
}

void FieldCanvas::setViewport(const FieldViewport& viewport) {
  if (viewport == viewport_) return;
  viewport_ = viewport;
  Q_EMIT viewportChanged();
  update();
}

void FieldCanvas::zoomBy(double factor) {
  setViewport(zoomed(viewport_, extent(), size(), factor, QRectF(rect()).center()));
}

QTransform FieldCanvas::transform() const {
  return fieldToWidget(viewport_, extent(), size());
}

QSizeF FieldCanvas::extent() const {
  return field_ ? fieldExtent(*field_) : QSizeF(5, 3.5);
}

QImage FieldCanvas::rendered() const {
  QImage image(size() * devicePixelRatioF(), QImage::Format_RGB32);
  image.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(&image);
  paintContents(painter);
  return image;
}

void FieldCanvas::paintContents(QPainter& painter) const {
  const QTransform toWidget = transform();
  const QColor window = palette().color(QPalette::Window);
  painter.fillRect(rect(), isDark(palette()) ? window.darker(125) : window.darker(106));
  if (field_) {
    paintField(painter, *field_, toWidget);
  } else {
    paintGroundGrid(painter, size(), toWidget, palette());
  }
  // Figures first: what robots drew lies on top of them.
  paintFigures(painter, figures_, toWidget, palette());
  for (const WorldDrawing& drawing : drawings_)
    paintFromAbove(painter, *drawing.entity, drawing.frameInField, toWidget);
  if (wanted_) paintWanted(painter, *wanted_, figures_.ballRadius, toWidget, palette());
  paintLegend(painter, size(), palette());
}

void FieldCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintContents(painter);
  if (!notice_.isEmpty()) paintSentence(painter, *this, notice_, SentencePlace::kTop);
}

std::string FieldCanvas::modelAt(const QPointF& at, Qt::KeyboardModifiers modifiers) const {
  if (!moveAlways_ && !modifiers.testFlag(Qt::ShiftModifier)) return {};
  const QTransform toWidget = transform();
  const double tolerance = kGrabTolerance / shownScale(viewport_, extent(), size());
  std::string model = figureAt(figures_, groundAt(toWidget, at), tolerance);
  return std::ranges::find(movable_, model) != movable_.end() ? model : std::string();
}

void FieldCanvas::updateHighlight(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  const std::string model = modelAt(at, modifiers);
  if (model == figures_.highlighted) return;
  figures_.highlighted = model;
  model.empty() ? unsetCursor() : setCursor(Qt::OpenHandCursor);
  update();
}

void FieldCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton) return QWidget::mousePressEvent(event);
  last_ = event->localPos();
  const std::string model =
      event->button() == Qt::LeftButton ? modelAt(last_, event->modifiers()) : std::string();
  mode_ = model.empty() ? Mode::kPanning : Mode::kDragging;
  setCursor(Qt::ClosedHandCursor);
  if (model.empty()) return;
  const Vector2 ground = groundAt(transform(), last_);
  Q_EMIT dragStarted(QString::fromStdString(model), ground.x(), ground.y());
}

void FieldCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->localPos();
  if (mode_ == Mode::kPanning) panBy(at - last_);
  last_ = at;
  const Vector2 ground = groundAt(transform(), at);
  if (mode_ == Mode::kDragging) Q_EMIT dragMoved(ground.x(), ground.y());
  if (mode_ == Mode::kIdle) updateHighlight(at, event->modifiers());
  Q_EMIT cursorMoved(ground.x(), ground.y(), true);
}

void FieldCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (mode_ == Mode::kDragging) Q_EMIT dragEnded();
  mode_ = Mode::kIdle;
  figures_.highlighted.clear();
  unsetCursor();
  updateHighlight(event->localPos(), event->modifiers());
}

void FieldCanvas::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (mode_ == Mode::kDragging) {
    Q_EMIT dragTurned(notches * kTurnStep);
  } else {
    setViewport(zoomed(viewport_, extent(), size(), std::pow(1.2, notches), event->position()));
  }
  event->accept();
}

void FieldCanvas::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return panBy({kPanStep, 0});
    case Qt::Key_Right:
      return panBy({-kPanStep, 0});
    case Qt::Key_Up:
      return panBy({0, kPanStep});
    case Qt::Key_Down:
      return panBy({0, -kPanStep});
    default:
      QWidget::keyPressEvent(event);
  }
}

void FieldCanvas::leaveEvent(QEvent*) {
  if (mode_ == Mode::kIdle && !figures_.highlighted.empty()) {
    figures_.highlighted.clear();
    update();
  }
  Q_EMIT cursorMoved(0, 0, false);
}

void FieldCanvas::panBy(const QPointF& by) {
  setViewport(panned(viewport_, extent(), size(), by));
}

}  // namespace widgets
