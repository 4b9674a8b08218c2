// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <memory>
#include <optional>

#include "widgets/color/space/ColorSpaceThread.h"

namespace widgets {

/// The way in which a lasso changes the selection.
enum class SelectionChange : std::uint8_t { kReplace, kAdd, kTakeAway };

/// Shows pictures of a color space, and turns mouse and keys into turns of the space and selections in it. It
/// does not know the bench: the view sets what is shown and applies what the signals say. Pictures are drawn
/// by a ColorSpaceThread whenever something changed. Object name "colorSpaceCanvas". GUI thread.
///
/// Mouse: drag to turn, right or middle button to pan, wheel to zoom, double click to reset; Shift and drag
/// selects by a lasso (with Control: add, with Alt: remove).
class ColorSpaceCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit ColorSpaceCanvas(QWidget* parent = nullptr);
  /// Waits for the picture that is being drawn.
  ~ColorSpaceCanvas() override;

  void setContents(std::shared_ptr<const ColorSpaceContents> contents);
  void setLook(const ColorSpaceLook& look);
  /// The cell of a color to which the cursor points in another view; its edges are drawn.
  void setMarkedCell(std::optional<std::size_t> cell);
  /// Call this 30 times a second while the canvas is visible. After six ticks without a change a smooth
  /// picture is requested.
  void tick();

  const ColorSpaceCamera& camera() const { return camera_; }
  void setCamera(const ColorSpaceCamera& camera);
  void zoomBy(double factor);

  /// The picture that is shown; empty before the first one.
  const ColorSpacePicture& picture() const { return shown_; }
  /// The picture that the widget shows.
  QImage rendered();
  /// Whether the picture shows everything that was set.
  bool upToDate() const { return shown_.request != nullptr && shown_.request == requested_; }
  /// The cell that is visible within three pixels of the cursor, the nearest if there are several; unset if
  /// there is none.
  std::optional<std::size_t> pointedCell() const;
  /// The position of the center of a cell, in widget pixels; unset before the first picture.
  std::optional<QPointF> pointOf(std::size_t cell) const;
  QSize sizeHint() const override { return {480, 420}; }

 Q_SIGNALS:
  /// A new picture is shown.
  void pictureShown();
  void pointedCellChanged();
  /// The user chose these of the cells that are shown; there may be none.
  void cellsChosen(const colortool::CellSet& cells, widgets::SelectionChange change);
  /// The user pressed Escape.
  void clearWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  /// The action of the pressed button.
  enum class Mode : std::uint8_t { kIdle, kTurning, kMoving, kLasso };

  /// Requests a picture of everything that was set; `smooth`: with smooth edges.
  void request(bool smooth = false);
  /// Takes the thread's newest picture; called in the GUI thread.
  void takePicture();
  void paint(QPainter& painter) const;
  void paintLasso(QPainter& painter) const;
  /// In widget pixels; unset: the cursor has left.
  void setCursorAt(std::optional<QPointF> at);
  /// Emits the selection; a click without a movement selects the cell under the cursor.
  void endLasso(Qt::KeyboardModifiers modifiers);
  /// The cells that are shown and whose centers are inside of the lasso.
  colortool::CellSet cellsInLasso() const;
  /// Colors for the palette in use.
  ColorSpaceColors colors() const;

  std::shared_ptr<const ColorSpaceContents> contents_;
  ColorSpaceLook look_;
  ColorSpaceCamera camera_;
  std::optional<std::size_t> marked_;
  /// Ticks since the last change.
  int ticks_ = 0;
  Mode mode_ = Mode::kIdle;
  /// Last position of the mouse during a drag.
  QPointF last_;
  std::optional<QPointF> cursor_;
  QPolygonF lasso_;
  /// The newest request, and the picture that is shown.
  std::shared_ptr<const ColorSpaceRequest> requested_;
  ColorSpacePicture shown_;
  std::unique_ptr<ColorSpaceThread> thread_;
};

}  // namespace widgets
