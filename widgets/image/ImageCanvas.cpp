// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImageCanvas.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/Theme.h"
#include "widgets/image/ImageProbe.h"
#include "widgets/picture/MeasureTool.h"
#include "widgets/picture/PanKeys.h"
#include "widgets/picture/ViewPicture.h"

namespace widgets {
namespace {

constexpr double kPaneGap = 4;  // pixels between two pictures

}  // namespace

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

void ImageCanvas::setSecond(std::optional<ImagePicture> picture, std::vector<robotlink::PackagePtr> keep) {
  if (!picture && !second_) return;
  const bool isOther = picture.has_value() != second_.has_value();
  second_ = std::move(picture);
  keepSecond_ = std::move(keep);
  if (isOther) Q_EMIT viewportChanged();
  update();
}

void ImageCanvas::setCaptions(const QString& first, const QString& second) {
  if (first == captions_[0] && second == captions_[1]) return;
  captions_[0] = first;
  captions_[1] = second;
  update();
}

bool ImageCanvas::isStacked() const {
  const QSizeF image = imageSize().isEmpty() ? QSizeF(4, 3) : imageSize();
  const double beside = std::min(width() / 2.0 / image.width(), height() / image.height());
  const double above = std::min(width() / image.width(), height() / 2.0 / image.height());
  return above > beside;
}

QRectF ImageCanvas::pane(int index) const {
  if (!second_) return rect();
  const bool stacked = isStacked();
  const double w = stacked ? width() : (width() - kPaneGap) / 2;
  const double h = stacked ? (height() - kPaneGap) / 2 : height();
  return {stacked ? 0 : index * (w + kPaneGap), stacked ? index * (h + kPaneGap) : 0, w, h};
}

QPointF ImageCanvas::inPane(const QPointF& widget) const {
  return second_ && pane(1).contains(widget) ? widget - pane(1).topLeft() : widget;
}

QTransform ImageCanvas::transform() const {
  return imageToWidget(viewport_, imageSize(), paneSize());
}

QPointF ImageCanvas::imageAt(const QPointF& widget) const {
  return transform().inverted().map(inPane(widget));
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
  setViewport(zoomed(viewport_, imageSize(), paneSize(), factor, pane(0).center()));
}

double ImageCanvas::zoom() const {
  return shownZoom(viewport_, imageSize(), paneSize());
}

QImage ImageCanvas::rendered() const {
  return paintedPicture(*this, [this](QPainter& painter) { paintAll(painter); });
}

void ImageCanvas::paintAll(QPainter& painter) const {
  paintPicture(painter, paneSize(), picture_, viewport_);
  if (second_) {
    painter.save();
    painter.translate(pane(1).topLeft());
    paintPicture(painter, paneSize(), *second_, viewport_);
    painter.restore();
  }
  paintCaption(painter, pane(0), captions_[0]);
  paintCaption(painter, pane(1), captions_[1]);
  if (measure_ != nullptr) measure_->paint(painter);
}

void ImageCanvas::paintBackground(QPainter& painter) const {
  const QColor base = palette().color(QPalette::Window);
  painter.fillRect(rect(), isDark(palette()) ? base.darker(135) : base.darker(112));
}

bool ImageCanvas::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto& help = static_cast<const QHelpEvent&>(*event);
  const bool isSecond = second_ && pane(1).contains(help.pos());
  const auto hits =
      drawingsAt(isSecond ? *second_ : picture_, viewport_, paneSize(), inPane(QPointF(help.pos())));
  return showDrawingTip(*this, help, hits) || QWidget::event(event);
}

void ImageCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintBackground(painter);
  paintAll(painter);
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
  measure_ != nullptr && measure_->isOn() ? setCursor(Qt::CrossCursor) : unsetCursor();
}

void ImageCanvas::wheelEvent(QWheelEvent* event) {
  const double factor = std::pow(2.0, event->angleDelta().y() / 240.0);
  setViewport(zoomed(viewport_, imageSize(), paneSize(), factor, inPane(event->position())));
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
  setViewport(panned(viewport_, imageSize(), paneSize(), by));
}

void ImageCanvas::updatePixel() {
  if (!inside_ || picture_.pixels.isNull()) return setPixel({});
  const QPointF at = imageAt(cursor_);
  const QPoint pixel(static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())));
  setPixel(picture_.pixels.rect().contains(pixel) ? std::optional(pixel) : std::nullopt);
}

void ImageCanvas::setPixel(std::optional<QPoint> pixel) {
  if (pixel == pixel_) return;
  pixel_ = pixel;
  Q_EMIT pixelChanged();
}

}  // namespace widgets
