// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/image/ColorCanvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "widgets/Theme.h"
#include "widgets/image/ImagePainter.h"
#include "widgets/picture/PanKeys.h"
#include "widgets/picture/ViewPicture.h"

namespace widgets {
namespace {

bool usesBrush(ColorTool tool) {
  return tool == ColorTool::kBrush || tool == ColorTool::kEraser;
}

}  // namespace

ColorCanvas::ColorCanvas(const QString& name, QWidget* parent) : QWidget(parent) {
  setObjectName(name);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(80, 60);
}

void ColorCanvas::setLayers(ColorLayers layers) {
  layers_ = std::move(layers);
  update();
}

void ColorCanvas::setHint(const QString& hint) {
  if (hint == hint_) return;
  hint_ = hint;
  update();
}

void ColorCanvas::setCaption(const QString& caption) {
  if (caption == caption_) return;
  caption_ = caption;
  update();
}

void ColorCanvas::setTool(ColorTool tool, double radius) {
  tool_ = tool;
  radius_ = radius;
  setCursor(tool == ColorTool::kMove ? Qt::OpenHandCursor
            : usesBrush(tool)        ? Qt::BlankCursor
                                     : Qt::CrossCursor);
  update();
}

void ColorCanvas::setPreview(QVector<QLineF> outline, const QColor& color) {
  if (preview_.isEmpty() && outline.isEmpty()) return;
  preview_ = std::move(outline);
  previewColor_ = color;
  update();
}

void ColorCanvas::setOtherCursor(std::optional<QPointF> at) {
  if (at == otherCursor_) return;
  otherCursor_ = at;
  update();
}

void ColorCanvas::setViewport(const ImageViewport& viewport) {
  if (viewport == viewport_) return;
  viewport_ = viewport;
  update();
}

void ColorCanvas::moveView(const ImageViewport& viewport) {
  setViewport(viewport);
  Q_EMIT viewportChanged(viewport_);
}

double ColorCanvas::zoom() const {
  return shownZoom(viewport_, imageSize(), size());
}

void ColorCanvas::zoomBy(double factor) {
  moveView(zoomed(viewport_, imageSize(), size(), factor, rect().center()));
}

QPointF ColorCanvas::toImage(const QPointF& widget) const {
  return imageToWidget(viewport_, imageSize(), size()).inverted().map(widget);
}

QPointF ColorCanvas::toWidget(const QPointF& image) const {
  return imageToWidget(viewport_, imageSize(), size()).map(image);
}

void ColorCanvas::paintOutline(QPainter& painter, const QVector<QLineF>& edges, const QColor& color,
                               bool dashed) const {
  QPen pen(QColor(0, 0, 0, 170), 3);
  pen.setCosmetic(true);
  // A dark line below a bright one is visible on any color. Where pixels are smaller than the line there is
  // no room for both, and there may be hundreds of strokes.
  if (painter.transform().m11() >= 1) {
    painter.setPen(pen);
    painter.drawLines(edges);
  }
  // Lighter than the class's color, in which the outline would vanish in the segmented image.
  pen.setColor(mixed(color, Qt::white, 0.5));
  pen.setWidthF(1.4);
  if (dashed) pen.setStyle(Qt::DotLine);
  painter.setPen(pen);
  painter.drawLines(edges);
}

void ColorCanvas::paintLayers(QPainter& painter, const QSizeF& size) const {
  if (layers_.picture.isNull()) return;
  paintPicture(painter, size, {layers_.picture, {}}, viewport_);
  if (!layers_.over.isNull() && layers_.opacity > 0) {
    painter.setOpacity(layers_.opacity);
    paintPicture(painter, size, {layers_.over, {}}, viewport_);
    painter.setOpacity(1);
  }
  if (!layers_.shade.isNull()) paintPicture(painter, size, {layers_.shade, {}}, viewport_);
  if (!layers_.marks) return;
  painter.save();
  painter.setTransform(imageToWidget(viewport_, imageSize(), size), true);
  for (const StrokeMark& mark : *layers_.marks) paintOutline(painter, mark.edges, mark.color, mark.mustNotBe);
  painter.restore();
}

void ColorCanvas::paintCursor(QPainter& painter) const {
  const auto at = cursor_ ? cursor_ : otherCursor_ ? std::optional(toWidget(*otherCursor_)) : std::nullopt;
  if (!at || layers_.picture.isNull()) return;
  const double radius = usesBrush(tool_) ? (radius_ + 0.5) * zoom() : 4;
  if (cursor_ && !usesBrush(tool_)) return;  // the mouse cursor is visible
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(0, 0, 0, 180), 3));
  painter.drawEllipse(*at, radius, radius);
  painter.setPen(QPen(cursor_ ? QColor(255, 255, 255) : QColor(255, 255, 255, 170), 1.2));
  painter.drawEllipse(*at, radius, radius);
}

void ColorCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QColor base = palette().color(QPalette::Window);
  painter.fillRect(rect(), isDark(palette()) ? base.darker(135) : base.darker(112));
  paintLayers(painter, size());
  if (layers_.picture.isNull()) {
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, hint_);
    return;
  }
  if (!preview_.isEmpty()) {
    painter.save();
    painter.setTransform(imageToWidget(viewport_, imageSize(), size()), true);
    paintOutline(painter, preview_, previewColor_, false);
    painter.restore();
  }
  paintCursor(painter);
  paintCaption(painter, rect(), caption_);
}

QImage ColorCanvas::rendered() const {
  return paintedPicture(*this, [this](QPainter& painter) { paintLayers(painter, size()); });
}

void ColorCanvas::reportCursor() {
  Q_EMIT cursorMoved(cursor_ ? std::optional(toImage(*cursor_)) : std::nullopt);
  if (usesBrush(tool_)) update();
}

void ColorCanvas::mousePressEvent(QMouseEvent* event) {
  if (layers_.picture.isNull()) return;
  const QPointF at = toImage(event->localPos());
  const bool moves = event->button() == Qt::MiddleButton || tool_ == ColorTool::kMove;
  if (event->button() == Qt::RightButton) {
    const QPoint pixel(static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())));
    if (layers_.picture.rect().contains(pixel)) Q_EMIT menuWanted(pixel, event->globalPos());
  } else if (moves) {
    panning_ = event->localPos();
    setCursor(Qt::ClosedHandCursor);
  } else if (event->button() == Qt::LeftButton) {
    drawing_ = true;
    Q_EMIT gestureBegan(at);
  }
}

void ColorCanvas::mouseMoveEvent(QMouseEvent* event) {
  cursor_ = event->localPos();
  if (panning_) {
    moveView(panned(viewport_, imageSize(), size(), event->localPos() - *panning_));
    panning_ = event->localPos();
  }
  if (drawing_) Q_EMIT gestureMoved(toImage(event->localPos()));
  reportCursor();
}

void ColorCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (panning_) {
    panning_.reset();
    setTool(tool_, radius_);
  }
  if (!drawing_ || event->button() != Qt::LeftButton) return;
  drawing_ = false;
  Q_EMIT gestureEnded();
}

void ColorCanvas::wheelEvent(QWheelEvent* event) {
  const double steps = event->angleDelta().y() / 120.0;
  if (event->modifiers().testFlag(Qt::ControlModifier))
    Q_EMIT radiusWanted(std::pow(1.25, steps));
  else
    moveView(zoomed(viewport_, imageSize(), size(), std::pow(2.0, steps / 2), event->position()));
  event->accept();
}

void ColorCanvas::keyPressEvent(QKeyEvent* event) {
  const auto pan = panOfKey(*event, 24);
  pan ? moveView(panned(viewport_, imageSize(), size(), *pan)) : QWidget::keyPressEvent(event);
}

void ColorCanvas::leaveEvent(QEvent*) {
  cursor_.reset();
  reportCursor();
  update();
}

void ColorCanvas::resizeEvent(QResizeEvent*) {
  Q_EMIT viewportChanged(viewport_);
}

}  // namespace widgets
