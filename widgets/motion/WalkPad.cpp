// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/WalkPad.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/Controls.h"
#include "widgets/Theme.h"

namespace widgets {
namespace {

QRectF discIn(const QRectF& rect) {
  const double side = std::min(rect.width(), rect.height()) - 24;
  return {rect.center().x() - side / 2, rect.center().y() - side / 2, side, side};
}

/// Returns -1, 0 or 1, depending on which of the keys for `plus` and `minus` are held.
double direction(const QSet<int>& keys, std::initializer_list<int> plus, std::initializer_list<int> minus) {
  const auto held = [&](std::initializer_list<int> any) {
    return std::any_of(any.begin(), any.end(), [&](int key) { return keys.contains(key); });
  };
  return (held(plus) ? 1.0 : 0.0) - (held(minus) ? 1.0 : 0.0);
}

bool drives(int key) {
  static constexpr int kKeys[] = {Qt::Key_W, Qt::Key_A,  Qt::Key_S,    Qt::Key_D,    Qt::Key_Q,
                                  Qt::Key_E, Qt::Key_Up, Qt::Key_Down, Qt::Key_Left, Qt::Key_Right};
  return std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys);
}

/// Forwards and turning do not bound each other, so the pad of wheels is a square.
void paintRings(QPainter& painter, const QRectF& disc, const QPalette& palette, bool wheels) {
  const QColor line = mixed(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.25);
  painter.setPen(QPen(line, 1));
  painter.setBrush(palette.color(QPalette::Base));
  const double quarter = disc.width() / 4;
  const QRectF half = disc.adjusted(quarter, quarter, -quarter, -quarter);
  wheels ? painter.drawRoundedRect(disc, 8, 8) : painter.drawEllipse(disc);
  painter.setBrush(Qt::NoBrush);
  wheels ? painter.drawRoundedRect(half, 4, 4) : painter.drawEllipse(half);
  painter.drawLine(QPointF(disc.center().x(), disc.top()), QPointF(disc.center().x(), disc.bottom()));
  painter.drawLine(QPointF(disc.left(), disc.center().y()), QPointF(disc.right(), disc.center().y()));
}

/// Clamps a vector to the border of the pad: a robot may be faster than what can be commanded.
WalkAxes withinPad(WalkAxes axes, bool wheels) {
  const auto finite = [](double value) { return std::isfinite(value) ? value : 0.0; };
  axes = {finite(axes.forward), finite(axes.left), finite(axes.turn)};
  if (wheels) return {std::clamp(axes.forward, -1.0, 1.0), axes.left, std::clamp(axes.turn, -1.0, 1.0)};
  const double length = std::hypot(axes.forward, axes.left);
  return length > 1 ? WalkAxes{axes.forward / length, axes.left / length, axes.turn} : axes;
}

void paintVector(QPainter& painter, const QRectF& disc, const WalkAxes& asked, const QColor& color,
                 bool filled, bool wheels) {
  const WalkAxes axes = withinPad(asked, wheels);
  const double radius = disc.width() / 2;
  const QPointF tip = disc.center() + QPointF(wheels ? -axes.turn : -axes.left, -axes.forward) * radius;
  painter.setPen(QPen(color, filled ? 3 : 2, filled ? Qt::SolidLine : Qt::DashLine, Qt::RoundCap));
  painter.drawLine(disc.center(), tip);
  painter.setPen(QPen(color, 2));
  painter.setBrush(filled ? QBrush(color) : QBrush(Qt::NoBrush));
  painter.drawEllipse(tip, filled ? 7 : 5, filled ? 7 : 5);
  painter.setBrush(Qt::NoBrush);
  if (axes.turn == 0 || wheels) return;
  // The rotation as an arc around the disc, from the top, to the left if it is counterclockwise.
  const double margin = filled ? 5 : 9;
  painter.setPen(QPen(color, filled ? 4 : 2, filled ? Qt::SolidLine : Qt::DashLine, Qt::FlatCap));
  painter.drawArc(disc.adjusted(-margin, -margin, margin, margin), 90 * 16,
                  static_cast<int>(std::clamp(axes.turn, -1.5, 1.5) * 90 * 16));
}

}  // namespace

WalkPad::WalkPad(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("walkPad"));
  describeUse();
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void WalkPad::describeUse() {
  const QString walk = tr(
      "Drag to walk, up is forward. Keys: W/A/S/D or the arrows walk, Q and E turn, Shift halves the speed.");
  const QString drive =
      tr("Drag to drive: up is forward, left turns left. Keys: W and S or the arrows drive, A and D or the "
         "arrows turn, Shift halves.");
  describe(*this, {"walkPad", wheels_ ? tr("Driving pad") : tr("Walk pad"), wheels_ ? drive : walk});
}

void WalkPad::setWheels(bool wheels) {
  if (wheels == wheels_) return;
  release();
  wheels_ = wheels;
  describeUse();
}

void WalkPad::show(Picture picture) {
  picture_ = std::move(picture);
  update();
}

void WalkPad::paint(QPainter& painter, const QRectF& rect, const Picture& picture, const QPalette& palette) {
  const QRectF disc = discIn(rect);
  painter.setRenderHint(QPainter::Antialiasing);
  paintRings(painter, disc, palette, picture.wheels);
  if (picture.measured)
    paintVector(painter, disc, *picture.measured, colorOf(Meaning::kGood, palette), false, picture.wheels);
  if (picture.enabled) {
    paintVector(painter, disc, picture.asked, colorOf(Meaning::kNote, palette), true, picture.wheels);
    return;
  }
  painter.setPen(colorOf(Meaning::kMuted, palette));
  painter.drawText(disc.adjusted(disc.width() / 8, 0, -disc.width() / 8, 0),
                   Qt::AlignCenter | Qt::TextWordWrap, picture.hint);
}

void WalkPad::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint(painter, rect(), picture_, palette());
  if (!hasFocus()) return;
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1, Qt::DotLine));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(1, 1, -2, -2));
}

void WalkPad::setAxes(const WalkAxes& axes) {
  if (axes == axes_) return;
  axes_ = axes;
  Q_EMIT moved();
}

void WalkPad::release() {
  keys_.clear();
  setAxes({});
}

void WalkPad::follow(const QPointF& position) {
  const QRectF disc = discIn(rect());
  QPointF vector = (position - disc.center()) / (disc.width() / 2);
  const double length = std::hypot(vector.x(), vector.y());
  if (wheels_) {
    vector = {std::clamp(vector.x(), -1.0, 1.0), std::clamp(vector.y(), -1.0, 1.0)};
  } else if (length > 1) {
    vector /= length;
  }
  setAxes(wheels_ ? WalkAxes{-vector.y(), 0, -vector.x()} : WalkAxes{-vector.y(), -vector.x(), axes_.turn});
}

void WalkPad::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) follow(event->localPos());
}

void WalkPad::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) follow(event->localPos());
}

void WalkPad::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) release();
}

void WalkPad::useKeys(bool halved) {
  const double scale = halved ? 0.5 : 1;
  const double sideways = scale * direction(keys_, {Qt::Key_A, Qt::Key_Left}, {Qt::Key_D, Qt::Key_Right});
  const double turn = scale * direction(keys_, {Qt::Key_Q}, {Qt::Key_E});
  const double forward = scale * direction(keys_, {Qt::Key_W, Qt::Key_Up}, {Qt::Key_S, Qt::Key_Down});
  setAxes(wheels_ ? WalkAxes{forward, 0, std::clamp(sideways + turn, -scale, scale)}
                  : WalkAxes{forward, sideways, turn});
}

void WalkPad::keyPressEvent(QKeyEvent* event) {
  const bool modified =
      (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
  if (modified || !(drives(event->key()) || event->key() == Qt::Key_Shift))
    return QWidget::keyPressEvent(event);
  if (drives(event->key())) keys_.insert(event->key());
  useKeys(event->modifiers().testFlag(Qt::ShiftModifier) || event->key() == Qt::Key_Shift);
}

void WalkPad::keyReleaseEvent(QKeyEvent* event) {
  if (!(drives(event->key()) || event->key() == Qt::Key_Shift)) return QWidget::keyReleaseEvent(event);
  if (event->isAutoRepeat()) return;
  keys_.remove(event->key());
  useKeys(event->modifiers().testFlag(Qt::ShiftModifier) && event->key() != Qt::Key_Shift);
}

void WalkPad::focusOutEvent(QFocusEvent* event) {
  release();
  QWidget::focusOutEvent(event);
  update();
}

void WalkPad::hideEvent(QHideEvent* event) {
  release();
  QWidget::hideEvent(event);
}

}  // namespace widgets
