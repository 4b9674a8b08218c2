// SPDX-License-Identifier: GPL-3.0-or-later
// SceneCanvas: the handles of the gizmo, and what is dropped from a palette.
#include <QDragEnterEvent>
#include <QDragMoveEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QPainter>

#include "widgets/scene/SceneCanvas.h"
#include "widgets/scene/ScenePalette.h"

namespace widgets {

void SceneCanvas::setGizmo(const std::optional<Gizmo>& gizmo) {
  if (mode_ == Mode::kHandling && gizmo_ && gizmo) {
    // The handles go with the object.
    gizmo_->pose = gizmo->pose;
    return update();
  }
  const bool isSame =
      gizmo_.has_value() == gizmo.has_value() &&
      (!gizmo || (gizmo_->pose.matrix() == gizmo->pose.matrix() && gizmo_->axes == gizmo->axes));
  if (isSame) return;
  gizmo_ = gizmo;
  if (!gizmo_) hot_ = GizmoHandle::kNone;
  update();
}

std::optional<SceneHit> SceneCanvas::hitAt(const QPointF& at) const {
  return firstHit(contents_.bodies, camera_.ray(size(), at));
}

bool SceneCanvas::isBackground(const SceneHit& hit) const {
  if (!hit.model.empty()) return false;
  const auto [known, isNew] = backgrounds_.try_emplace(hit.owner(), false);
  if (isNew) known->second = isSurroundings(hit.owner(), contents_.bodies);
  return known->second;
}

std::optional<robotlink::Vector3> SceneCanvas::placeAt(const QPointF& at) const {
  return camera_.ray(size(), at).onPlane(0);
}

void SceneCanvas::paintHand(QPainter& painter) {
  if (gizmo_ && shown_.frame) paintGizmo(painter, *gizmo_, shown_.frame->camera, size(), hot_);
  if (readout_.isEmpty()) return;
  QRectF box = QFontMetricsF(painter.font()).boundingRect(readout_).adjusted(-6, -3, 6, 3);
  box.moveTopLeft(last_ + QPointF(16, 14));
  if (box.right() > width()) box.moveRight(last_.x() - 10);
  if (box.bottom() > height()) box.moveBottom(last_.y() - 10);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 170));
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(Qt::white);
  painter.drawText(box, Qt::AlignCenter, readout_);
}

void SceneCanvas::dragEnterEvent(QDragEnterEvent* event) {
  if (!ScenePalette::kindIn(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void SceneCanvas::dragMoveEvent(QDragMoveEvent* event) {
  const auto place = placeAt(event->posF());
  last_ = event->posF();
  readout_ = place ? tr("x: %1 m  y: %2 m").arg(place->x(), 0, 'f', 2).arg(place->y(), 0, 'f', 2) : QString();
  update();
  event->setAccepted(place.has_value());
}

void SceneCanvas::dragLeaveEvent(QDragLeaveEvent*) {
  readout_.clear();
  update();
}

void SceneCanvas::dropEvent(QDropEvent* event) {
  readout_.clear();
  const QString kind = ScenePalette::kindIn(*event->mimeData());
  const auto place = placeAt(event->posF());
  if (kind.isEmpty() || !place) return;
  event->acceptProposedAction();
  Q_EMIT dropped(kind, place->x(), place->y());
}

}  // namespace widgets
