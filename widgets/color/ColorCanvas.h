// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/color/ColorGesture.h"
#include "widgets/color/ColorLayers.h"
#include "widgets/image/ImageViewport.h"

namespace widgets {

/// What a canvas shows, lowest first. Images are of one size.
struct ColorLayers {
  QImage picture;
  QImage over;  ///< on the picture with `opacity`; null: nothing is
  double opacity = 1;
  QImage shade;  ///< with its own alpha on all of that; null: none
  std::shared_ptr<const std::vector<StrokeMark>> marks;
};

/// Shows one image of the colour tool and says what mouse and keys do in it, in coordinates of the image. It
/// draws nothing into samples itself. The wheel zooms to the cursor, with Ctrl it changes the brush; the
/// middle button, or the left one with the tool kMove, moves the image. Two canvases with the same viewport
/// show the same part.
class ColorCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit ColorCanvas(const QString& name, QWidget* parent = nullptr);

  void setLayers(ColorLayers layers);
  const ColorLayers& layers() const { return layers_; }
  /// What is said where no picture is, and at the upper left corner of one.
  void setHint(const QString& hint);
  void setCaption(const QString& caption);
  void setTool(ColorTool tool, double radius);
  /// The outline of what is touched just now; empty: none. And what the cursor is over in the other canvas.
  void setPreview(QVector<QLineF> outline, const QColor& color);
  void setOtherCursor(std::optional<QPointF> at);

  const ImageViewport& viewport() const { return viewport_; }
  /// Without telling it: see viewportChanged().
  void setViewport(const ImageViewport& viewport);
  double zoom() const;
  /// What is in the middle stays there.
  void zoomBy(double factor);
  QPointF toImage(const QPointF& widget) const;
  QPointF toWidget(const QPointF& image) const;
  /// What is seen, without hint and cursor.
  QImage rendered() const;

  QSize sizeHint() const override { return {352, 288}; }

 Q_SIGNALS:
  void viewportChanged(const ImageViewport& viewport);  ///< by the user
  /// In the image; nothing: the cursor left it.
  void cursorMoved(std::optional<QPointF> at);
  void gestureBegan(const QPointF& at);
  void gestureMoved(const QPointF& at);
  void gestureEnded();
  void radiusWanted(double factor);
  /// The right button, at a pixel.
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
  void moveView(const ImageViewport& viewport);
  void tellCursor();

  ColorLayers layers_;
  ImageViewport viewport_;
  QString hint_, caption_;
  ColorTool tool_ = ColorTool::kBrush;
  double radius_ = 3;
  QVector<QLineF> preview_;
  QColor previewColor_;
  std::optional<QPointF> otherCursor_;
  std::optional<QPointF> cursor_;   // of this canvas
  std::optional<QPointF> panning_;  // from where, while the image is moved
  bool drawing_ = false;
};

}  // namespace widgets
