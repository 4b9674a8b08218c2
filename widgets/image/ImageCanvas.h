// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "robotlink/process/Link.h"
#include "widgets/image/ImagePainter.h"
#include "widgets/image/ImageViewport.h"

namespace widgets {

/// Shows an ImagePicture, zooms it with the wheel to where the cursor is and pans it with the mouse, both
/// buttons but the right. Keys: arrows pan. Its object name is "imageCanvas".
class ImageCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit ImageCanvas(QWidget* parent = nullptr);

  /// `keep`: the messages that the drawings of the picture belong to.
  void setPicture(ImagePicture picture, std::vector<robotlink::PackagePtr> keep);
  const ImagePicture& picture() const { return picture_; }
  /// What is said where no picture is.
  void setHint(const QString& hint);
  void setFrozen(bool frozen);

  const ImageViewport& viewport() const { return viewport_; }
  void setViewport(const ImageViewport& viewport);
  /// By a key or button: what is in the middle stays there.
  void zoomBy(double factor);
  double zoom() const;
  /// The pixel under the cursor, if there is one.
  std::optional<QPoint> pixelUnderCursor() const { return pixel_; }
  /// What is seen, without frame and hints.
  QImage rendered() const;

  QSize sizeHint() const override { return {352, 288}; }

 Q_SIGNALS:
  void viewportChanged();
  void pixelChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QSizeF imageSize() const { return picture_.pixels.size(); }
  void panBy(const QPointF& by);
  void updatePixel();
  void setPixel(std::optional<QPoint> pixel);
  void paintBackground(QPainter& painter) const;

  ImagePicture picture_;
  std::vector<robotlink::PackagePtr> keep_;
  ImageViewport viewport_;
  QString hint_;
  bool frozen_ = false;
  bool inside_ = false;
  std::optional<QPointF> pressed_;
  QPointF cursor_;
  std::optional<QPoint> pixel_;
};

}  // namespace widgets
