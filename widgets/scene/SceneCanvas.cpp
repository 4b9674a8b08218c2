// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SceneCanvas.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/Sentence.h"
#include "widgets/Theme.h"
#include "widgets/scene/SceneAssembly.h"
#include "widgets/scene/SceneProbe.h"
#include "widgets/scene/render/SceneOverlay.h"

namespace widgets {
namespace {

constexpr double kKeyStep = 24;         // pixels that an arrow key is worth
constexpr int kSceneClickSlack = 4;     // pixels that a hand moves while it clicks
constexpr double kGroundHeight = 0.01;  // m; hits below are on the ground, or on what is flat on it
constexpr double kSceneTurnStep = robotlink::radians(15);

/// Whether a key may be meant for the scene. Those of the window stay what they are: Escape, with which
/// robots are stopped, function keys, and all with Ctrl or Alt. Modifiers alone are not.
bool isSent(const QKeyEvent& event) {
  const bool isModifier = event.key() >= Qt::Key_Shift && event.key() <= Qt::Key_ScrollLock;
  const bool isOfWindow = isModifier || event.key() == Qt::Key_Escape ||
                          (event.key() >= Qt::Key_F1 && event.key() <= Qt::Key_F35);
  return !isOfWindow && !event.modifiers().testFlag(Qt::ControlModifier) &&
         !event.modifiers().testFlag(Qt::AltModifier);
}

}  // namespace

SceneCanvas::SceneCanvas(RenderThread::MakeRenderer makeRenderer, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("sceneCanvas"));
  setAccessibleName(tr("Scene"));
  setToolTip(tr(
      "Drag: turn; right or middle button, or Shift: move; wheel: zoom; click an object: select it; double "
      "click: select the ground or a room, too; Esc: select nothing; drag a robot or the ball "
      "(Control: always): place it, wheel: turn it; R: reset"));
  setToolTipDuration(4000);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAcceptDrops(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(120, 90);
  // A queued call into the GUI thread; it is dropped if this widget, which outlives the thread, is destroyed.
  const auto finished = [this] {
    QMetaObject::invokeMethod(
        this, [this] { takePicture(); }, Qt::QueuedConnection);
  };
  thread_ = std::make_unique<RenderThread>(std::move(makeRenderer), finished);
}

SceneCanvas::~SceneCanvas() {
  thread_.reset();
}

void SceneCanvas::setContents(VisibleScene contents) {
  if (contents == contents_) return smoothen();
  if (contents.bodies.size() != contents_.bodies.size()) backgrounds_.clear();
  contents_ = std::move(contents);
  request();
}

void SceneCanvas::smoothen() {
  if (mode_ != Mode::kIdle || !upToDate() || shown_.frame->smooth) return;
  request(true);
}

void SceneCanvas::setMovable(std::vector<std::string> models, bool always) {
  movable_ = std::move(models);
  moveAlways_ = always;
}

void SceneCanvas::setNotice(const QString& text) {
  if (text == notice_) return;
  notice_ = text;
  update();
}

void SceneCanvas::setHint(const QString& text) {
  if (text == hint_) return;
  hint_ = text;
  update();
}

void SceneCanvas::setCamera(const SceneCamera& camera) {
  if (camera == camera_) return;
  camera_ = camera;
  overview_.reset();
  request();
}

void SceneCanvas::setOverview(const SceneBox& box) {
  setCamera(SceneCamera::overview(size(), box));
  overview_ = box;
}

void SceneCanvas::zoomBy(double factor) {
  SceneCamera camera = camera_;
  camera.zoom(size(), factor, QRectF(rect()).center());
  setCamera(camera);
}

void SceneCanvas::setGrid(bool grid) {
  grid_ = grid;
  request();
}

void SceneCanvas::setLabels(bool labels) {
  labels_ = labels;
  update();
}

SceneFrame::Colors SceneCanvas::colors() const {
  const QColor ink = palette().color(QPalette::WindowText);
  SceneFrame::Colors colors{QColor(196, 212, 226),
                            QColor(240, 243, 246),
                            QColor(90, 105, 120),
                            ink,
                            Qt::white,
                            QColor(255, 140, 0),
                            QColor(90, 170, 255),
                            colorOf(Meaning::kBad, palette())};
  if (isDark(palette())) {
    colors.skyTop = QColor(66, 76, 88);
    colors.skyBottom = QColor(30, 34, 39);
    colors.grid = QColor(150, 165, 180);
  }
  return colors;
}

void SceneCanvas::request(bool smooth) {
  if (width() < 2 || height() < 2) return;
  auto frame = std::make_shared<SceneFrame>();
  frame->pixelRatio = devicePixelRatioF();
  frame->pixels = (QSizeF(size()) * frame->pixelRatio).toSize();
  frame->camera = camera_;
  frame->colors = colors();
  frame->grid = grid_;
  frame->contents = contents_;
  frame->highlighted = highlighted_.empty() ? selected_ : highlighted_;
  frame->hurry = mode_ != Mode::kIdle;
  frame->smooth = smooth;
  requested_ = frame;
  thread_->request(std::move(frame));
}

void SceneCanvas::takePicture() {
  auto picture = thread_->take();
  if (picture) shown_ = std::move(*picture);
  update();
}

QImage SceneCanvas::rendered() const {
  if (shown_.image.isNull()) return {};
  QImage picture = shown_.image;
  QPainter painter(&picture);
  if (labels_) paintLabels(painter, size(), shown_.frame->camera, shown_.frame->contents.labels);
  return picture;
}

bool SceneCanvas::event(QEvent* event) {
  // Keys that are sent do not act as shortcuts of the view.
  if (event->type() == QEvent::ShortcutOverride && sends_ && isSent(static_cast<const QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto& help = static_cast<const QHelpEvent&>(*event);
  const auto hits = drawingsAt(contents_.drawings, camera_, size(), QPointF(help.pos()));
  return showDrawingTip(*this, help, hits) || QWidget::event(event);
}

void SceneCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (shown_.image.isNull()) {
    painter.fillRect(rect(), palette().window());
  } else {
    painter.setRenderHint(QPainter::SmoothPixmapTransform, shown_.frame->pixels != shown_.image.size());
    painter.drawImage(QRectF(rect()), shown_.image);
    if (labels_) paintLabels(painter, size(), shown_.frame->camera, shown_.frame->contents.labels);
    paintAxes(painter, size(), shown_.frame->camera);
    paintHand(painter);
  }
  const QString error = QString::fromStdString(thread_->error());
  if (!error.isEmpty()) {
    const QString text = tr("The scene cannot be drawn: %1").arg(error);
    return paintSentence(painter, *this, text, SentencePlace::kMiddle);
  }
  if (contents_.bodies.empty() && contents_.drawings.empty() && !hint_.isEmpty())
    paintSentence(painter, *this, hint_, SentencePlace::kMiddle);
  if (!notice_.isEmpty()) paintSentence(painter, *this, notice_, SentencePlace::kTop);
}

void SceneCanvas::resizeEvent(QResizeEvent*) {
  if (overview_) setOverview(SceneBox(*overview_));
  request();
}

void SceneCanvas::showEvent(QShowEvent*) {
  request();
}

void SceneCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) request();
  QWidget::changeEvent(event);
}

bool SceneCanvas::canDrag(const std::optional<SceneHit>& hit, Qt::KeyboardModifiers modifiers) const {
  if (!hit || (!moveAlways_ && !modifiers.testFlag(Qt::ControlModifier))) return false;
  return std::ranges::find(movable_, hit->model) != movable_.end();
}

void SceneCanvas::highlight(const std::string& object) {
  if (object == highlighted_) return;
  highlighted_ = object;
  request();
}

void SceneCanvas::pointAt(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  const auto hit = hot_ == GizmoHandle::kNone ? hitAt(at) : std::nullopt;
  canDrag(hit, modifiers) ? setCursor(Qt::OpenHandCursor) : unsetCursor();
  // The ground is below the mouse nearly always, which says nothing.
  const bool isGround = hit && hit->model.empty() && hit->point.z() < kGroundHeight;
  highlight(hit && !isGround && !isBackground(*hit) ? hit->owner() : std::string());
}

bool SceneCanvas::startDrag(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  const auto hit = hitAt(at);
  if (!canDrag(hit, modifiers)) return false;
  dragHeight_ = hit->point.z();
  highlight(hit->model);
  Q_EMIT dragStarted(QString::fromStdString(hit->model), hit->point.x(), hit->point.y());
  return true;
}

SceneCanvas::Mode SceneCanvas::modeFor(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::ShiftModifier))
    return Mode::kPanning;
  if (sends_) return Mode::kSending;
  hot_ = gizmo_ ? gizmo_->handleAt(camera_, size(), event.localPos()) : GizmoHandle::kNone;
  if (hot_ != GizmoHandle::kNone) {
    gizmoDrag_.emplace(hot_, *gizmo_, camera_, size(), event.localPos());
    return Mode::kHandling;
  }
  return startDrag(event.localPos(), event.modifiers()) ? Mode::kDragging : Mode::kOrbiting;
}

void SceneCanvas::mousePressEvent(QMouseEvent* event) {
  if (mode_ != Mode::kIdle) return;
  last_ = pressed_ = event->localPos();
  moved_ = isDoubleClick_ = false;
  backgrounds_.clear();
  speed_ = {};
  mode_ = modeFor(*event);
  if (mode_ == Mode::kSending) return sendMouse(SceneEvent::Kind::kMousePressed, last_);
  setCursor(Qt::ClosedHandCursor);
}

void SceneCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  const bool isFirstButton = mode_ == Mode::kIdle;
  mousePressEvent(event);
  isDoubleClick_ = isFirstButton && event->button() == Qt::LeftButton;
}

void SceneCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF by = event->localPos() - last_;
  last_ = event->localPos();
  moved_ = moved_ || (last_ - pressed_).manhattanLength() >= kSceneClickSlack;
  SceneCamera camera = camera_;
  switch (mode_) {
    case Mode::kIdle: {
      const GizmoHandle before =
          std::exchange(hot_, gizmo_ ? gizmo_->handleAt(camera_, size(), last_) : GizmoHandle::kNone);
      if (hot_ != before) update();
      return pointAt(last_, event->modifiers());
    }
    case Mode::kOrbiting:
      camera.orbit(by);
      return setCamera(camera);
    case Mode::kPanning:
      camera.pan(size(), by);
      return setCamera(camera);
    case Mode::kSending:
      return sendMouse(SceneEvent::Kind::kMouseMoved, last_);
    case Mode::kDragging:
    case Mode::kHandling:
      return dragTo(last_, event->modifiers(), event->timestamp());
  }
}

void SceneCanvas::dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers, std::uint64_t time) {
  // A click must not move what it selects.
  if (!moved_) return;
  const bool isSnapping = modifiers.testFlag(Qt::ControlModifier);
  if (gizmoDrag_) {
    readout_ = gizmoDrag_->readout(at, isSnapping);
    update();
    return Q_EMIT gizmoMoved(gizmoDrag_->poseAt(at, isSnapping));
  }
  const auto ground = camera_.ray(size(), at).onPlane(dragHeight_);
  if (!ground) return;
  speed_.add(time, ground->head<2>());
  // If dragging requires Control, that key cannot mean snapping, too.
  Q_EMIT dragMoved(ground->x(), ground->y(), isSnapping && moveAlways_);
}

bool SceneCanvas::cancelDrag() {
  if (!isDragging()) return false;
  const bool isGizmo = std::exchange(mode_, Mode::kIdle) == Mode::kHandling;
  gizmoDrag_.reset();
  readout_.clear();
  // The button is still pressed; its release is no click.
  moved_ = true;
  unsetCursor();
  request();
  isGizmo ? Q_EMIT gizmoCanceled() : Q_EMIT dragCanceled();
  return true;
}

void SceneCanvas::mouseReleaseEvent(QMouseEvent* event) {
  const Mode ended = std::exchange(mode_, Mode::kIdle);
  if (ended == Mode::kSending) return sendMouse(SceneEvent::Kind::kMouseReleased, event->localPos());
  readout_.clear();
  if (ended == Mode::kDragging) {
    const robotlink::Vector2 speed = speed_.at(event->timestamp());
    Q_EMIT dragEnded(speed.x(), speed.y());
  }
  if (const auto drag = std::exchange(gizmoDrag_, std::nullopt); drag && ended == Mode::kHandling) {
    const bool isSnapping = event->modifiers().testFlag(Qt::ControlModifier);
    moved_ ? Q_EMIT gizmoEnded(drag->poseAt(event->localPos(), isSnapping)) : Q_EMIT gizmoCanceled();
    moved_ = true;
  }
  if (event->button() == Qt::LeftButton && !moved_) click(event->localPos());
  if (event->button() == Qt::RightButton && !moved_) {
    Q_EMIT customContextMenuRequested(event->pos());
  }
  pointAt(event->localPos(), event->modifiers());
  request();
}

void SceneCanvas::setSelected(const std::string& object) {
  if (object == selected_) return;
  selected_ = object;
  request();
}

void SceneCanvas::click(const QPointF& at) {
  const auto hit = hitAt(at);
  if (!hit || hit->owner().empty() || (!isDoubleClick_ && isBackground(*hit))) return;
  Q_EMIT modelClicked(QString::fromStdString(hit->owner()));
}

void SceneCanvas::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  event->accept();
  if (mode_ == Mode::kHandling) return;
  if (mode_ == Mode::kDragging) return Q_EMIT dragTurned(notches * kSceneTurnStep);
  SceneCamera camera = camera_;
  camera.zoom(size(), std::pow(1.2, notches), event->position());
  setCamera(camera);
}

void SceneCanvas::sendMouse(SceneEvent::Kind kind, const QPointF& at) {
  const Ray ray = camera_.ray(size(), at);
  Q_EMIT eventHappened({kind, {}, ray.origin, ray.direction});
}

void SceneCanvas::sendKey(SceneEvent::Kind kind, const QKeyEvent& event) {
  const QString key = QKeySequence(event.key()).toString(QKeySequence::PortableText);
  if (!event.isAutoRepeat() && !key.isEmpty()) Q_EMIT eventHappened({kind, key});
}

void SceneCanvas::keyReleaseEvent(QKeyEvent* event) {
  if (!sends_ || !isSent(*event)) return QWidget::keyReleaseEvent(event);
  sendKey(SceneEvent::Kind::kKeyReleased, *event);
}

void SceneCanvas::keyPressEvent(QKeyEvent* event) {
  if (sends_ && isSent(*event)) return sendKey(SceneEvent::Kind::kKeyPressed, *event);
  QPointF by;
  if (event->key() == Qt::Key_Escape && cancelDrag()) return;
  if (event->key() == Qt::Key_Escape && event->modifiers() == Qt::NoModifier) return Q_EMIT nothingWanted();
  switch (event->key()) {
    case Qt::Key_Left:
      by = {kKeyStep, 0};
      break;
    case Qt::Key_Right:
      by = {-kKeyStep, 0};
      break;
    case Qt::Key_Up:
      by = {0, kKeyStep};
      break;
    case Qt::Key_Down:
      by = {0, -kKeyStep};
      break;
    default:
      return QWidget::keyPressEvent(event);
  }
  SceneCamera camera = camera_;
  event->modifiers().testFlag(Qt::ShiftModifier) ? camera.pan(size(), by) : camera.orbit(by);
  setCamera(camera);
}

void SceneCanvas::leaveEvent(QEvent*) {
  if (mode_ != Mode::kIdle) return;
  highlight({});
  unsetCursor();
}

}  // namespace widgets
