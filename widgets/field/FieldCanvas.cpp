// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/FieldCanvas.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "widgets/Sentence.h"
#include "widgets/Theme.h"
#include "widgets/field/FieldPainter.h"
#include "widgets/field/GroundDrawing.h"
#include "widgets/field/GroundProbe.h"
#include "widgets/field/MapPainter.h"
#include "widgets/picture/MeasureTool.h"
#include "widgets/picture/PanKeys.h"
#include "widgets/picture/ViewPicture.h"

namespace widgets {
namespace {

using robotlink::Vector2;

constexpr double kGrabTolerance = 6;  // pixels around a figure that still grab it
constexpr double kPanStep = 30;       // pixels per press of an arrow key
constexpr double kPlaceTolerance = 9;
constexpr int kClickSlack = 4;  // pixels that a hand moves during a click
constexpr double kTurnStep = robotlink::radians(15);

}  // namespace

FieldCanvas::FieldCanvas(std::shared_ptr<const robotlink::FieldDescription> field, QWidget* parent)
    : QWidget(parent), field_(std::move(field)) {
  setObjectName(QStringLiteral("fieldCanvas"));
  setAccessibleName(tr("Field"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(120, 80);
  setToolTip(
      tr("Wheel: zoom; drag: move the picture; click a robot: select it; drag a robot or the ball (Shift: "
         "always): place it, wheel: "
         "turn it; Control+click: send the robot there; arrows: move; F: fit; R: turn"));
  setToolTipDuration(4000);
}

FieldCanvas::~FieldCanvas() = default;

void FieldCanvas::setMap(std::shared_ptr<const robotcontrol::GroundMap> map) {
  if (map.get() == this->map()) return;
  // The viewport of another building means nothing here.
  if (map_ && map) viewport_ = {};
  map_ = map ? std::make_unique<MapGround>(std::move(map)) : nullptr;
  place_ = -1;
  update();
  Q_EMIT viewportChanged();
}

const robotcontrol::GroundMap* FieldCanvas::map() const {
  return map_ ? &map_->map() : nullptr;
}

void FieldCanvas::setGoals(GoalFigures goals) {
  goals_ = std::move(goals);
  update();
}

void FieldCanvas::setAiming(bool possible, bool always) {
  aimPossible_ = possible;
  aimAlways_ = always;
  if (mode_ == Mode::kIdle && !measures() && !aimPossible_ && cursor().shape() == Qt::CrossCursor)
    unsetCursor();
}

void FieldCanvas::abandonAim() {
  if (mode_ == Mode::kAiming) mode_ = Mode::kIdle;
}

void FieldCanvas::setField(std::shared_ptr<const robotlink::FieldDescription> field) {
  if (field == field_) return;
  field_ = std::move(field);
  update();
  Q_EMIT viewportChanged();
}

void FieldCanvas::setContents(FieldFigures figures, std::vector<WorldDrawing> drawings) {
  figures.highlighted = figures_.highlighted;
  figures_ = std::move(figures);
  drawings_ = std::move(drawings);
  update();
}

void FieldCanvas::setWanted(std::optional<WantedPlace> place) {
  if (!place && !wanted_) return;
  wanted_ = std::move(place);
  update();
}

void FieldCanvas::setNotice(const QString& text) {
  if (text == notice_) return;
  notice_ = text;
  update();
}

void FieldCanvas::setMovable(std::vector<std::string> models, bool always) {
  movable_ = std::move(models);
  moveAlways_ = always;
}

void FieldCanvas::setViewport(const FieldViewport& viewport) {
  if (viewport == viewport_) return;
  viewport_ = viewport;
  Q_EMIT viewportChanged();
  update();
}

void FieldCanvas::zoomBy(double factor) {
  setViewport(zoomed(viewport_, extent(), size(), factor, QRectF(rect()).center()));
}

QTransform FieldCanvas::transform() const {
  return fieldToWidget(viewport_, extent(), size());
}

QRectF FieldCanvas::extent() const {
  if (map_) return map_->extent();
  const QSizeF size = field_ ? fieldExtent(*field_) : QSizeF(5, 3.5);
  return {QPointF(-size.width() / 2, -size.height() / 2), size};
}

QImage FieldCanvas::rendered() const {
  return paintedPicture(*this, [this](QPainter& painter) { paintContents(painter, devicePixelRatioF()); });
}

void FieldCanvas::paintGround(QPainter& painter, const QTransform& toWidget, double ratio) const {
  if (map_) return map_->paint(painter, size(), toWidget, palette(), ratio, place_);
  const QColor window = palette().color(QPalette::Window);
  painter.fillRect(rect(), isDark(palette()) ? window.darker(125) : window.darker(106));
  if (field_) return paintField(painter, *field_, toWidget);
  paintGroundGrid(painter, size(), toWidget, palette());
}

void FieldCanvas::paintContents(QPainter& painter, double ratio) const {
  const QTransform toWidget = transform();
  paintGround(painter, toWidget, ratio);
  // Figures first, so that the robots' drawings are on top of them.
  paintFigures(painter, figures_, toWidget, palette());
  paintFromAbove(painter, drawings_, toWidget);
  paintGoals(painter, goals_, toWidget, palette());
  if (wanted_) paintWanted(painter, *wanted_, figures_, toWidget, palette());
  paintLegend(painter, size(), palette());
  if (measure_ != nullptr) measure_->paint(painter);
}

bool FieldCanvas::measures() const {
  return measure_ != nullptr && measure_->isOn();
}

bool FieldCanvas::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto& help = static_cast<const QHelpEvent&>(*event);
  const auto hits = drawingsAt(drawings_, transform(), QPointF(help.pos()));
  return showDrawingTip(*this, help, hits) || QWidget::event(event);
}

void FieldCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintContents(painter, devicePixelRatioF());
  if (!notice_.isEmpty()) paintSentence(painter, *this, notice_, SentencePlace::kTop);
}

std::string FieldCanvas::modelAt(const QPointF& at, Qt::KeyboardModifiers modifiers) const {
  if (!moveAlways_ && !modifiers.testFlag(Qt::ShiftModifier)) return {};
  const QTransform toWidget = transform();
  const double tolerance = kGrabTolerance / shownScale(viewport_, extent(), size());
  std::string model = figureAt(figures_, groundAt(toWidget, at), tolerance);
  return std::ranges::find(movable_, model) != movable_.end() ? model : std::string();
}

void FieldCanvas::updateHighlight(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  const std::string model = modelAt(at, modifiers);
  if (model == figures_.highlighted) return;
  figures_.highlighted = model;
  model.empty() ? unsetCursor() : setCursor(Qt::OpenHandCursor);
  update();
}

bool FieldCanvas::aims(const QMouseEvent& event) const {
  return event.button() == Qt::LeftButton && aimPossible_ &&
         (aimAlways_ || event.modifiers().testFlag(Qt::ControlModifier));
}

void FieldCanvas::updatePlace(const QPointF& at) {
  const int place = map_ ? placeAt(map_->map(), transform(), at, kPlaceTolerance) : -1;
  if (place == place_) return;
  place_ = place;
  update();
}

void FieldCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton) return QWidget::mousePressEvent(event);
  last_ = pressed_ = event->localPos();
  moved_ = false;
  const std::string model =
      event->button() == Qt::LeftButton ? modelAt(last_, event->modifiers()) : std::string();
  const Vector2 ground = groundAt(transform(), last_);
  updatePlace(last_);
  if (model.empty() && aims(*event)) {
    mode_ = Mode::kAiming;
    setCursor(Qt::CrossCursor);
    Q_EMIT aimStarted(ground.x(), ground.y(), place_);
    return;
  }
  mode_ = model.empty() ? Mode::kPanning : Mode::kDragging;
  setCursor(Qt::ClosedHandCursor);
  if (model.empty()) return;
  Q_EMIT dragStarted(QString::fromStdString(model), ground.x(), ground.y());
}

void FieldCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->localPos();
  moved_ = moved_ || (at - pressed_).manhattanLength() >= kClickSlack;
  if (mode_ == Mode::kPanning) panBy(at - last_);
  last_ = at;
  const Vector2 ground = groundAt(transform(), at);
  // A click must not move what it selects.
  if (mode_ == Mode::kDragging && moved_) Q_EMIT dragMoved(ground.x(), ground.y());
  if (mode_ == Mode::kAiming) Q_EMIT aimMoved(ground.x(), ground.y());
  if (mode_ == Mode::kIdle && !measures()) {
    updateHighlight(at, event->modifiers());
    updatePlace(at);
    const bool aims = aimPossible_ && aimAlways_ && figures_.highlighted.empty();
    if (aims != (cursor().shape() == Qt::CrossCursor) && figures_.highlighted.empty())
      aims ? setCursor(Qt::CrossCursor) : unsetCursor();
  }
  Q_EMIT cursorMoved(ground.x(), ground.y(), true);
}

void FieldCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (mode_ == Mode::kDragging) Q_EMIT dragEnded();
  if (event->button() == Qt::LeftButton && mode_ != Mode::kAiming && !moved_) click(event->localPos());
  if (mode_ == Mode::kAiming) Q_EMIT aimEnded();
  mode_ = Mode::kIdle;
  figures_.highlighted.clear();
  if (measures()) return setCursor(Qt::CrossCursor);
  unsetCursor();
  updateHighlight(event->localPos(), event->modifiers());
}

void FieldCanvas::click(const QPointF& at) {
  const double tolerance = kGrabTolerance / shownScale(viewport_, extent(), size());
  const std::string robot = robotAt(figures_, groundAt(transform(), at), tolerance);
  if (!robot.empty()) Q_EMIT robotClicked(QString::fromStdString(robot));
}

void FieldCanvas::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (mode_ == Mode::kDragging) {
    Q_EMIT dragTurned(notches * kTurnStep);
  } else {
    setViewport(zoomed(viewport_, extent(), size(), std::pow(1.2, notches), event->position()));
  }
  event->accept();
}

void FieldCanvas::keyPressEvent(QKeyEvent* event) {
  const auto pan = panOfKey(*event, kPanStep);
  pan ? panBy(*pan) : QWidget::keyPressEvent(event);
}

void FieldCanvas::leaveEvent(QEvent*) {
  if (mode_ == Mode::kIdle && !figures_.highlighted.empty()) {
    figures_.highlighted.clear();
    update();
  }
  if (std::exchange(place_, -1) >= 0) update();
  Q_EMIT cursorMoved(0, 0, false);
}

void FieldCanvas::panBy(const QPointF& by) {
  setViewport(panned(viewport_, extent(), size(), by));
}

}  // namespace widgets
