// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <memory>
#include <optional>

#include "widgets/color/ColorSpaceThread.h"

namespace widgets {

/// How a lasso changes what is selected.
enum class SelectionChange : std::uint8_t { kReplace, kAdd, kTakeAway };

/// Shows pictures of a colour space and turns mouse and keys into turns of it and selections in it. It knows
/// no bench: the view sets what there is and does what is wanted. Pictures are drawn in another thread,
/// whenever something changed. Object name "colorSpaceCanvas". GUI thread.
class ColorSpaceCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit ColorSpaceCanvas(QWidget* parent = nullptr);
  ~ColorSpaceCanvas() override;

  void setContents(std::shared_ptr<const ColorSpaceContents> contents);
  void setLook(const ColorSpaceLook& look);
  /// A colour that somebody points to elsewhere; its cell is marked.
  void setMarkedCell(std::optional<std::size_t> cell);
  /// To be called 30 times a second while it is visible: what stands still gets smooth edges.
  void tick();

  const ColorSpaceCamera& camera() const { return camera_; }
  void setCamera(const ColorSpaceCamera& camera);
  void zoomBy(double factor);

  /// What is seen; empty until the first picture.
  const ColorSpacePicture& picture() const { return shown_; }
  QImage rendered();
  /// The newest picture shows everything that was set.
  bool upToDate() const { return shown_.request != nullptr && shown_.request == requested_; }
  /// The cell under the cursor that something is seen of.
  std::optional<std::size_t> pointedCell() const;
  /// Where the middle of a cell is seen; none before the first picture.
  std::optional<QPointF> pointOf(std::size_t cell) const;
  QSize sizeHint() const override { return {480, 420}; }

 Q_SIGNALS:
  void pictureShown();
  void cameraMoved();
  void pointedCellChanged();
  /// The user chose these of the cells that are shown; there may be none.
  void cellsChosen(const colortool::CellSet& cells, widgets::SelectionChange change);
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
  enum class Mode : std::uint8_t { kIdle, kTurning, kMoving, kLasso };

  void request(bool smooth = false);
  void takePicture();
  void paint(QPainter& painter) const;
  void paintLasso(QPainter& painter) const;
  void setCursorAt(std::optional<QPointF> at);
  void endLasso(Qt::KeyboardModifiers modifiers);
  /// The shown cells whose middles are inside of the lasso.
  colortool::CellSet cellsInLasso() const;
  ColorSpaceColors colors() const;

  std::shared_ptr<const ColorSpaceContents> contents_;
  ColorSpaceLook look_;
  ColorSpaceCamera camera_;
  std::optional<std::size_t> marked_;
  int ticks_ = 0;  ///< since something was set
  Mode mode_ = Mode::kIdle;
  QPointF last_;
  std::optional<QPointF> cursor_;
  QPolygonF lasso_;
  std::shared_ptr<const ColorSpaceRequest> requested_;
  ColorSpacePicture shown_;
  std::unique_ptr<ColorSpaceThread> thread_;
};

}  // namespace widgets
