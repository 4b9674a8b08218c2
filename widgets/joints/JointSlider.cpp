// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/joints/JointSlider.h"

#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "robotlink/base/Geometry.h"
#include "widgets/Theme.h"
#include "widgets/joints/JointsModel.h"

namespace widgets {
namespace {

/// Room at both ends, so that the mark of a limit is whole.
constexpr double kSliderEnd = 5;

int sliderStepsOf(double angle) {
  return static_cast<int>(std::lround(robotlink::degrees(angle) * JointSlider::kPerDegree));
}

}  // namespace

JointSlider::JointSlider(const JointRow& joint, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), minimum_(joint.minimum), maximum_(joint.maximum) {
  // Rounded inwards, so that the ends are not beyond the limits.
  setRange(static_cast<int>(std::ceil(robotlink::degrees(minimum_) * kPerDegree - 1e-6)),
           static_cast<int>(std::floor(robotlink::degrees(maximum_) * kPerDegree + 1e-6)));
  setSingleStep(kPerDegree);
  setPageStep(10 * kPerDegree);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(false);
  connect(this, &QSlider::valueChanged, this, [this](int value) {
    Q_EMIT angleWanted(std::clamp(robotlink::radians(value / double(kPerDegree)), minimum_, maximum_));
  });
  showJoint(joint);
}

void JointSlider::showJoint(const JointRow& joint) {
  requested_ = joint.requested;
  measured_ = joint.measured;
  isCommanded_ = joint.commanded.has_value();
  const auto& known = joint.requested ? joint.requested : joint.measured;
  const auto& shown = joint.commanded ? joint.commanded : known;
  if (shown && !isSliderDown()) {
    const QSignalBlocker quiet(this);
    setValue(sliderStepsOf(*shown));
  }
  update();
}

double JointSlider::placeOf(double angle) const {
  const double share = std::clamp((angle - minimum_) / (maximum_ - minimum_), 0.0, 1.0);
  return kSliderEnd + share * (width() - 2 * kSliderEnd);
}

void JointSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double middle = height() / 2.0, thickness = std::clamp(height() / 2.5, 4.0, 9.0);
  const QColor track = mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.15);
  const auto bar = [&](double from, double to, const QColor& color) {
    painter.fillRect(QRectF(QPointF(std::min(from, to), middle - thickness / 2),
                            QPointF(std::max(from, to), middle + thickness / 2)),
                     color);
  };
  bar(placeOf(minimum_), placeOf(maximum_), track);
  const double zero = placeOf(0);
  if (measured_) bar(zero, placeOf(*measured_), colorOf(Meaning::kNote, palette()));
  painter.setPen(QPen(palette().color(QPalette::Text), 1));
  painter.drawLine(QPointF(zero, middle - thickness / 2), QPointF(zero, middle + thickness / 2));
  const QColor mark = isCommanded_ ? colorOf(Meaning::kWarning, palette()) : palette().color(QPalette::Text);
  if (requested_) {
    painter.setPen(QPen(mark, 2));
    const double x = placeOf(*requested_);
    painter.drawLine(QPointF(x, middle - thickness), QPointF(x, middle + thickness));
  }
  if (!isEnabled()) return;
  // The handle, filled while the user turns the joint.
  const double x = placeOf(robotlink::radians(value() / double(kPerDegree)));
  painter.setPen(QPen(hasFocus() ? palette().color(QPalette::Highlight) : mark, hasFocus() ? 2 : 1.5));
  painter.setBrush(isCommanded_ ? mark : palette().color(QPalette::Base));
  painter.drawEllipse(QPointF(x, middle), kSliderEnd - 1, kSliderEnd - 1);
}

void JointSlider::moveTo(int x) {
  const double share = std::clamp((x - kSliderEnd) / std::max(1.0, width() - 2 * kSliderEnd), 0.0, 1.0);
  setValue(static_cast<int>(std::lround(minimum() + share * (maximum() - minimum()))));
}

void JointSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  setSliderDown(true);
  moveTo(event->pos().x());
}

void JointSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) moveTo(event->pos().x());
}

void JointSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) setSliderDown(false);
}

void JointSlider::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QSlider::wheelEvent(event);
  else
    event->ignore();
}

}  // namespace widgets
