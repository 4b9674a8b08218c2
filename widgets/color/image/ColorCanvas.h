// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/color/image/ColorGesture.h"
#include "widgets/color/image/ColorLayers.h"
#include "widgets/image/ImageViewport.h"

namespace widgets {

/// The layers of a canvas, lowest first. All images have the same size.
struct ColorLayers {
  /// Null: nothing is shown but the hint.
  QImage picture;
  /// Laid over the picture with `opacity`; null: nothing.
  QImage over;
  double opacity = 1;
  /// Laid over both with its own alpha; null: nothing.
  QImage shade;
  /// Outlines of strokes; null: none.
  std::shared_ptr<const std::vector<StrokeMark>> marks;
};

/// Shows one image of the color tool and reports the user's gestures in image coordinates (pixels, y down).
/// It changes no samples itself. The wheel zooms at the cursor, or with Ctrl changes the brush; the middle
/// button, or the left one with the tool kMove, pans; the arrow keys pan. Two canvases are kept on the same
/// part of the image by exchanging their viewports. GUI thread.
class ColorCanvas final : public QWidget {
  Q_OBJECT
 public:
  /// `name` is the object name.
  explicit ColorCanvas(const QString& name, QWidget* parent = nullptr);

  void setLayers(ColorLayers layers);
  const ColorLayers& layers() const { return layers_; }
  /// Text in the middle while there is no picture.
  void setHint(const QString& hint);
  /// Text in the upper left corner of the picture; empty: none.
  void setCaption(const QString& caption);
  /// `radius`: of the brush in image pixels.
  void setTool(ColorTool tool, double radius);
  /// Outline of what the gesture touches, in image coordinates; empty: none.
  void setPreview(QVector<QLineF> outline, const QColor& color);
  /// Position of the cursor in the other canvas, in image coordinates; unset: it is not there.
  void setOtherCursor(std::optional<QPointF> at);

  const ImageViewport& viewport() const { return viewport_; }
  /// Sets the viewport without emitting viewportChanged().
  void setViewport(const ImageViewport& viewport);
  /// Widget pixels per image pixel.
  double zoom() const;
  /// Zooms around the middle.
  void zoomBy(double factor);
  /// From widget to image coordinates, and back.
  QPointF toImage(const QPointF& widget) const;
  QPointF toWidget(const QPointF& image) const;
  /// The picture that is shown, without hint, caption and cursor.
  QImage rendered() const;

  QSize sizeHint() const override { return {352, 288}; }

 Q_SIGNALS:
  /// The user zoomed or panned, or the widget was resized.
  void viewportChanged(const ImageViewport& viewport);
  /// Position of the cursor in the image; unset: it has left the canvas.
  void cursorMoved(std::optional<QPointF> at);
  /// The left button was pressed, moved, or released with a tool; positions in the image.
  void gestureBegan(const QPointF& at);
  void gestureMoved(const QPointF& at);
  void gestureEnded();
  /// Emitted for Ctrl and wheel: the brush's radius is to change by this factor.
  void radiusWanted(double factor);
  /// The right button was pressed on a pixel; `global` is the position on the screen.
  void menuWanted(const QPoint& pixel, const QPoint& global);

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
  QSizeF imageSize() const { return layers_.picture.size(); }
  void paintLayers(QPainter& painter, const QSizeF& size) const;
  void paintOutline(QPainter& painter, const QVector<QLineF>& edges, const QColor& color, bool dashed) const;
  void paintCursor(QPainter& painter) const;
  /// Sets the viewport and emits viewportChanged().
  void moveView(const ImageViewport& viewport);
  /// Emits cursorMoved().
  void reportCursor();

  ColorLayers layers_;
  ImageViewport viewport_;
  QString hint_, caption_;
  ColorTool tool_ = ColorTool::kBrush;
  double radius_ = 3;
  QVector<QLineF> preview_;
  QColor previewColor_;
  /// See setOtherCursor().
  std::optional<QPointF> otherCursor_;
  /// Cursor in this canvas, in widget coordinates.
  std::optional<QPointF> cursor_;
  /// Last position of the mouse while panning.
  std::optional<QPointF> panning_;
  /// A gesture has begun and not ended.
  bool drawing_ = false;
};

}  // namespace widgets
