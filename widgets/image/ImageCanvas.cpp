// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImageCanvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "widgets/Theme.h"
#include "widgets/picture/PanKeys.h"
#include "widgets/picture/ViewPicture.h"

namespace widgets {

ImageCanvas::ImageCanvas(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("imageCanvas"));
  setAccessibleName(tr("Image"));
  setToolTip(tr("Wheel: zoom; drag: move; arrows: move; F: fit; A: pixel by pixel"));
  setToolTipDuration(4000);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(80, 60);
}

void ImageCanvas::setPicture(ImagePicture picture, std::vector<robotlink::PackagePtr> keep) {
  picture_ = std::move(picture);
  keep_ = std::move(keep);
  updatePixel();
  Q_EMIT pixelChanged();  // the pixel may have another color now
  update();
}

void ImageCanvas::setHint(const QString& hint) {
  if (hint == hint_) return;
  hint_ = hint;
  update();
}

void ImageCanvas::setFrozen(bool frozen) {
  if (frozen == frozen_) return;
  frozen_ = frozen;
  update();
}

void ImageCanvas::setViewport(const ImageViewport& viewport) {
  if (viewport == viewport_) return;
  viewport_ = viewport;
  updatePixel();
  Q_EMIT viewportChanged();
  update();
}

void ImageCanvas::zoomBy(double factor) {
  setViewport(zoomed(viewport_, imageSize(), size(), factor, QRectF(rect()).center()));
}

double ImageCanvas::zoom() const {
  return shownZoom(viewport_, imageSize(), size());
}

QImage ImageCanvas::rendered() const {
  return paintedPicture(*this,
                        [this](QPainter& painter) { paintPicture(painter, size(), picture_, viewport_); });
}

void ImageCanvas::paintBackground(QPainter& painter) const {
  const QColor base = palette().color(QPalette::Window);
  painter.fillRect(rect(), isDark(palette()) ? base.darker(135) : base.darker(112));
}

void ImageCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintBackground(painter);
  paintPicture(painter, size(), picture_, viewport_);
  if (picture_.pixels.isNull()) {
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, hint_);
  }
  if (frozen_) {
    painter.setPen(QPen(colorOf(Meaning::kWarning, palette()), 3));
    painter.drawRect(rect().adjusted(1, 1, -2, -2));
  }
}

void ImageCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton) return QWidget::mousePressEvent(event);
  pressed_ = event->localPos();
  setCursor(Qt::ClosedHandCursor);
}

void ImageCanvas::mouseMoveEvent(QMouseEvent* event) {
  cursor_ = event->localPos();
  inside_ = true;
  if (pressed_) {
    panBy(cursor_ - *pressed_);
    pressed_ = cursor_;
  }
  updatePixel();
}

void ImageCanvas::mouseReleaseEvent(QMouseEvent*) {
  pressed_.reset();
  unsetCursor();
}

void ImageCanvas::wheelEvent(QWheelEvent* event) {
  const double factor = std::pow(2.0, event->angleDelta().y() / 240.0);
  setViewport(zoomed(viewport_, imageSize(), size(), factor, event->position()));
  event->accept();
}

void ImageCanvas::keyPressEvent(QKeyEvent* event) {
  const auto pan = panOfKey(*event, 24);
  pan ? panBy(*pan) : QWidget::keyPressEvent(event);
}

void ImageCanvas::leaveEvent(QEvent*) {
  inside_ = false;
  updatePixel();
}

void ImageCanvas::resizeEvent(QResizeEvent*) {
  updatePixel();
  Q_EMIT viewportChanged();
}

void ImageCanvas::panBy(const QPointF& by) {
  setViewport(panned(viewport_, imageSize(), size(), by));
}

void ImageCanvas::updatePixel() {
  if (!inside_ || picture_.pixels.isNull()) return setPixel({});
  const QPointF at = imageToWidget(viewport_, imageSize(), size()).inverted().map(cursor_);
  const QPoint pixel(static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())));
  setPixel(picture_.pixels.rect().contains(pixel) ? std::optional(pixel) : std::nullopt);
}

void ImageCanvas::setPixel(std::optional<QPoint> pixel) {
  if (pixel == pixel_) return;
  pixel_ = pixel;
  Q_EMIT pixelChanged();
}

}  // namespace widgets
