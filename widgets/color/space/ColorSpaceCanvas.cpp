// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSpaceCanvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/Theme.h"
#include "widgets/color/space/ColorSpaceOverlay.h"
#include "widgets/color/space/ColorSpaceRaster.h"

namespace widgets {
namespace {

constexpr double kTurnKeyStep = 24;  // pixels of a drag that an arrow key is worth
constexpr double kKeyZoom = 1.25;
constexpr int kStillTicks = 6;  // after which a picture is worth some effort
constexpr int kPickReach = 3;   // pixels around the cursor in which to look for a cell

}  // namespace

ColorSpaceCanvas::ColorSpaceCanvas(QWidget* parent)
    : QWidget(parent), contents_(std::make_shared<ColorSpaceContents>()) {
  setObjectName(QStringLiteral("colorSpaceCanvas"));
  setAccessibleName(tr("Color space"));
  setToolTip(
      tr("Drag: turn; right or middle button: move; wheel: zoom; double click: reset. Shift+drag: select "
         "what is inside (with Control: add, with Alt: remove); Escape: clear the selection"));
  setToolTipDuration(5000);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(120, 90);
  // A queued call into the GUI thread; it is dropped if this widget, which outlives the thread, is destroyed.
  const auto finished = [this] {
    QMetaObject::invokeMethod(
        this, [this] { takePicture(); }, Qt::QueuedConnection);
  };
  thread_ = std::make_unique<ColorSpaceThread>(finished);
}

ColorSpaceCanvas::~ColorSpaceCanvas() {
  thread_.reset();
}

void ColorSpaceCanvas::setContents(std::shared_ptr<const ColorSpaceContents> contents) {
  contents_ = std::move(contents);
  request();
}

void ColorSpaceCanvas::setLook(const ColorSpaceLook& look) {
  if (look == look_) return;
  look_ = look;
  request();
}

void ColorSpaceCanvas::setMarkedCell(std::optional<std::size_t> cell) {
  if (cell == marked_) return;
  marked_ = cell;
  update();
}

void ColorSpaceCanvas::tick() {
  const bool still = mode_ == Mode::kIdle || mode_ == Mode::kLasso;
  if (++ticks_ > kStillTicks && still && upToDate() && !shown_.request->smooth) request(true);
}

void ColorSpaceCanvas::setCamera(const ColorSpaceCamera& camera) {
  if (camera == camera_) return;
  camera_ = camera;
  request();
}

void ColorSpaceCanvas::zoomBy(double factor) {
  ColorSpaceCamera camera = camera_;
  camera.zoomBy(size(), factor, QPointF(width(), height()) / 2);
  setCamera(camera);
}

void ColorSpaceCanvas::request(bool smooth) {
  if (!isVisible()) return;
  auto wanted = std::make_shared<ColorSpaceRequest>();
  wanted->contents = contents_;
  wanted->look = look_;
  wanted->camera = camera_;
  wanted->colors = colors();
  wanted->widget = size();
  wanted->ratio = devicePixelRatioF();
  wanted->smooth = smooth;
  requested_ = wanted;
  if (!smooth) ticks_ = 0;
  thread_->request(std::move(wanted));
  update();
}

void ColorSpaceCanvas::takePicture() {
  auto picture = thread_->take();
  if (!picture) return;
  shown_ = std::move(*picture);
  shown_.image.setDevicePixelRatio(shown_.request->ratio);
  update();
  Q_EMIT pictureShown();
  Q_EMIT pointedCellChanged();
}

ColorSpaceColors ColorSpaceCanvas::colors() const {
  const bool dark = isDark(palette());
  // A little gray, so that neither black nor white pixels vanish in it.
  const QColor background = mixed(palette().color(QPalette::Base), QColor(128, 128, 128), dark ? 0.32 : 0.1);
  return {background, dark ? QColor(255, 90, 215) : QColor(215, 0, 160)};
}

QImage ColorSpaceCanvas::rendered() {
  return grab().toImage();
}

void ColorSpaceCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint(painter);
}

void ColorSpaceCanvas::paint(QPainter& painter) const {
  const ColorSpaceColors theme = colors();
  painter.fillRect(rect(), theme.background);
  if (shown_.image.isNull()) return;
  // The box belongs to the picture that is shown, not to the one that is being drawn.
  const ColorSpaceRequest& request = *shown_.request;
  const QColor text = palette().color(QPalette::Text);
  const ColorSpaceBox box{request.look.space, ColorSpaceProjection(request.camera, request.widget),
                          mixed(text, theme.background, 0.6), mixed(text, theme.background, 0.1)};
  paintBoxBehind(painter, box);
  painter.drawImage(QPointF(0, 0), shown_.image);
  paintBoxInFront(painter, box);
  paintCut(painter, box, request.look.cut, theme.highlight);
  const auto cell = mode_ == Mode::kIdle && cursor_ ? pointedCell() : std::nullopt;
  for (const auto& marked : {cell, marked_}) {
    if (!marked) continue;
    paintCell(painter, box.projection, shown_.lattice->cornersOf(*marked), QColor(255, 255, 255),
              QColor(0, 0, 0, 190));
  }
  if (mode_ == Mode::kLasso) paintLasso(painter);
}

void ColorSpaceCanvas::paintLasso(QPainter& painter) const {
  QColor inside = colors().highlight;
  inside.setAlpha(36);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colors().highlight, 1.5, Qt::DashLine));
  painter.setBrush(inside);
  painter.drawPolygon(lasso_);
  painter.restore();
}

void ColorSpaceCanvas::resizeEvent(QResizeEvent*) {
  request();
}

void ColorSpaceCanvas::showEvent(QShowEvent*) {
  request();
}

void ColorSpaceCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) request();
  QWidget::changeEvent(event);
}

std::optional<std::size_t> ColorSpaceCanvas::pointedCell() const {
  if (!cursor_ || shown_.image.isNull()) return std::nullopt;
  const double ratio = shown_.request->ratio;
  const int x = static_cast<int>(cursor_->x() * ratio), y = static_cast<int>(cursor_->y() * ratio);
  const int reach = static_cast<int>(std::lround(kPickReach * ratio));
  std::optional<std::size_t> nearest;
  int nearestSquare = reach * reach + 1;
  for (int atY = std::max(0, y - reach); atY <= std::min(shown_.image.height() - 1, y + reach); ++atY) {
    for (int atX = std::max(0, x - reach); atX <= std::min(shown_.image.width() - 1, x + reach); ++atX) {
      const std::uint32_t cell = shown_.cells[static_cast<std::size_t>(atY * shown_.image.width() + atX)];
      const int square = (atX - x) * (atX - x) + (atY - y) * (atY - y);
      if (cell == ColorSpaceRaster::kNoCell || square >= nearestSquare) continue;
      nearest = cell;
      nearestSquare = square;
    }
  }
  return nearest;
}

std::optional<QPointF> ColorSpaceCanvas::pointOf(std::size_t cell) const {
  if (shown_.lattice == nullptr) return std::nullopt;
  return ColorSpaceProjection(camera_, size()).point(shown_.lattice->center(cell));
}

void ColorSpaceCanvas::setCursorAt(std::optional<QPointF> at) {
  const auto before = pointedCell();
  cursor_ = at;
  if (pointedCell() == before) return;
  update();
  Q_EMIT pointedCellChanged();
}

void ColorSpaceCanvas::mousePressEvent(QMouseEvent* event) {
  if (mode_ != Mode::kIdle) return;
  last_ = event->localPos();
  if (event->button() != Qt::LeftButton) {
    mode_ = Mode::kMoving;
  } else if (event->modifiers().testFlag(Qt::ShiftModifier)) {
    mode_ = Mode::kLasso;
    lasso_ = QPolygonF({last_});
  } else {
    mode_ = Mode::kTurning;
  }
  setCursor(mode_ == Mode::kLasso ? Qt::CrossCursor : Qt::ClosedHandCursor);
}

void ColorSpaceCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->localPos() - last_;
  last_ = event->localPos();
  ColorSpaceCamera camera = camera_;
  switch (mode_) {
    case Mode::kIdle:
      return setCursorAt(last_);
    case Mode::kTurning:
      camera.turn(by);
      break;
    case Mode::kMoving:
      camera.move(size(), by);
      break;
    case Mode::kLasso:
      lasso_ << last_;
      return update();
  }
  setCamera(camera);
}

void ColorSpaceCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (mode_ == Mode::kIdle) return;
  const Mode ended = std::exchange(mode_, Mode::kIdle);
  unsetCursor();
  setCursorAt(event->localPos());
  if (ended == Mode::kLasso) endLasso(event->modifiers());
  update();
}

void ColorSpaceCanvas::endLasso(Qt::KeyboardModifiers modifiers) {
  auto change = SelectionChange::kReplace;
  if (modifiers.testFlag(Qt::ControlModifier)) change = SelectionChange::kAdd;
  if (modifiers.testFlag(Qt::AltModifier)) change = SelectionChange::kTakeAway;
  const QSizeF extent = lasso_.boundingRect().size();
  if (extent.width() + extent.height() > 2 * kPickReach) return Q_EMIT cellsChosen(cellsInLasso(), change);
  // A mere click takes the cell that is under it.
  colortool::CellSet cells;
  if (const auto cell = pointedCell()) cells.set(*cell);
  Q_EMIT cellsChosen(cells, change);
}

colortool::CellSet ColorSpaceCanvas::cellsInLasso() const {
  colortool::CellSet cells;
  if (shown_.lattice == nullptr) return cells;
  QImage mask(size(), QImage::Format_Grayscale8);
  mask.fill(0);
  QPainter painter(&mask);
  painter.setPen(Qt::NoPen);
  painter.setBrush(Qt::white);
  painter.drawPolygon(lasso_, Qt::OddEvenFill);
  painter.end();
  const ColorSpaceProjection projection(camera_, size());
  for (std::size_t cell = 0; cell < colortool::ColorTable::kCellCount; ++cell) {
    if (!shown_.shown->contains(cell)) continue;
    const QPoint at = projection.point(shown_.lattice->center(cell)).toPoint();
    if (mask.rect().contains(at) && mask.constScanLine(at.y())[at.x()] != 0) cells.set(cell);
  }
  return cells;
}

void ColorSpaceCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !event->modifiers().testFlag(Qt::ShiftModifier))
    return setCamera({});
  mousePressEvent(event);
}

void ColorSpaceCanvas::wheelEvent(QWheelEvent* event) {
  ColorSpaceCamera camera = camera_;
  camera.zoomBy(size(), std::pow(1.2, event->angleDelta().y() / 120.0), event->position());
  setCamera(camera);
  event->accept();
}

void ColorSpaceCanvas::keyPressEvent(QKeyEvent* event) {
  ColorSpaceCamera camera = camera_;
  switch (event->key()) {
    case Qt::Key_Left:
      camera.turn({-kTurnKeyStep, 0});
      break;
    case Qt::Key_Right:
      camera.turn({kTurnKeyStep, 0});
      break;
    case Qt::Key_Up:
      camera.turn({0, -kTurnKeyStep});
      break;
    case Qt::Key_Down:
      camera.turn({0, kTurnKeyStep});
      break;
    case Qt::Key_Plus:
    case Qt::Key_Minus:
      return zoomBy(event->key() == Qt::Key_Plus ? kKeyZoom : 1 / kKeyZoom);
    case Qt::Key_Home:
      return setCamera({});
    case Qt::Key_Escape:
      if (mode_ != Mode::kLasso) return Q_EMIT clearWanted();
      mode_ = Mode::kIdle;
      unsetCursor();
      return update();
    default:
      return QWidget::keyPressEvent(event);
  }
  setCamera(camera);
}

void ColorSpaceCanvas::leaveEvent(QEvent*) {
  setCursorAt(std::nullopt);
}

}  // namespace widgets
