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

class MeasureTool;

/// Shows an ImagePicture, or two of them side by side (one above the other where that shows them
/// larger), of which both show the same part. The wheel zooms at the cursor, dragging with the left or middle
/// button and the arrow keys pan. Object name "imageCanvas". GUI thread.
class ImageCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit ImageCanvas(QWidget* parent = nullptr);

  /// `keep`: the messages that own the annotations of the picture's drawings.
  void setPicture(ImagePicture picture, std::vector<robotlink::PackagePtr> keep);
  /// The picture as it was set.
  const ImagePicture& picture() const { return picture_; }
  /// A picture next to the first one, scaled to its size; one without pixels: none was found there. Unset:
  /// there is one picture only.
  void setSecond(std::optional<ImagePicture> picture, std::vector<robotlink::PackagePtr> keep);
  const std::optional<ImagePicture>& second() const { return second_; }
  /// The texts over the first picture and over the second one; empty: none.
  void setCaptions(const QString& first, const QString& second);
  /// Paints what is measured over the picture; must outlive the canvas's last event.
  void setMeasure(const MeasureTool* measure) { measure_ = measure; }
  /// Text in the middle while there is no picture.
  void setHint(const QString& hint);
  const QString& hint() const { return hint_; }
  /// Whether the picture is frozen, which a frame shows.
  void setFrozen(bool frozen);

  const ImageViewport& viewport() const { return viewport_; }
  /// Emits viewportChanged() if it differs.
  void setViewport(const ImageViewport& viewport);
  /// Zooms around the middle.
  void zoomBy(double factor);
  /// Widget pixels per image pixel.
  double zoom() const;
  /// The pixel under the cursor; unset: none.
  std::optional<QPoint> pixelUnderCursor() const { return pixel_; }
  /// From the pixels of the first picture to the widget.
  QTransform transform() const;
  /// The point of the image at a position of the widget, in either picture; outside of both, what would be
  /// there if the first picture continued.
  QPointF imageAt(const QPointF& widget) const;
  /// The picture that is shown, without frame and hint.
  QImage rendered() const;

  QSize sizeHint() const override { return {352, 288}; }

 Q_SIGNALS:
  /// The user zoomed or panned, or the widget was resized.
  void viewportChanged();
  /// pixelUnderCursor() changed.
  void pixelChanged();

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
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Size of the image in pixels; empty without a picture.
  QSizeF imageSize() const { return picture_.pixels.size(); }
  /// Whether two pictures lie one above the other.
  bool isStacked() const;
  /// The place of a picture in the widget, 0 or 1.
  QRectF pane(int index) const;
  QSizeF paneSize() const { return pane(0).size(); }
  /// A position of the widget in the first picture's pane, that it has or corresponds to.
  QPointF inPane(const QPointF& widget) const;
  /// Paints all but frame and hint.
  void paintAll(QPainter& painter) const;
  /// Moves the image by widget pixels.
  void panBy(const QPointF& by);
  /// Finds the pixel under the cursor.
  void updatePixel();
  /// Emits pixelChanged() if it differs.
  void setPixel(std::optional<QPoint> pixel);
  /// Fills what the image does not cover.
  void paintBackground(QPainter& painter) const;

  ImagePicture picture_;
  /// Own the annotations of picture_.
  std::vector<robotlink::PackagePtr> keep_;
  std::optional<ImagePicture> second_;
  /// Own the annotations of second_.
  std::vector<robotlink::PackagePtr> keepSecond_;
  QString captions_[2];
  const MeasureTool* measure_ = nullptr;
  ImageViewport viewport_;
  QString hint_;
  bool frozen_ = false;
  /// Whether the cursor is in the widget.
  bool inside_ = false;
  /// Last position of the mouse while panning.
  std::optional<QPointF> pressed_;
  QPointF cursor_;
  std::optional<QPoint> pixel_;
};

}  // namespace widgets
