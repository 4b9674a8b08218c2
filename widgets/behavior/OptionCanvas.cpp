// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/behavior/OptionCanvas.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

namespace widgets {

OptionCanvas::OptionCanvas(const BehaviorModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  setObjectName(QStringLiteral("behaviorGraph"));
  setAccessibleName(tr("Options of the behavior"));
  setMinimumSize(120, 100);
  setFocusPolicy(Qt::StrongFocus);
}

void OptionCanvas::layOut() {
  graph_ = OptionGraph(model_);
  if (graph_.stateRect(selected_).isEmpty()) select({});
  update();
}

void OptionCanvas::select(const BehaviorModel::Place& place) {
  if (place == selected_) return;
  selected_ = place;
  update();
  Q_EMIT selectionChanged();
}

QTransform OptionCanvas::transform() const {
  const QRectF bounds = graph_.bounds();
  if (bounds.isEmpty()) return {};
  const double scale = std::min({1.5, width() / bounds.width(), height() / bounds.height()});
  return QTransform::fromTranslate(-bounds.left(), -bounds.top()) * QTransform::fromScale(scale, scale);
}

QRectF OptionCanvas::stateRect(const BehaviorModel::Place& place) const {
  return transform().mapRect(graph_.stateRect(place));
}

void OptionCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  painter.setTransform(transform());
  graph_.paint(painter, model_, selected_, palette());
}

void OptionCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const BehaviorModel::Place place = graph_.at(transform().inverted().map(event->localPos()));
  select(place.state < 0 ? BehaviorModel::Place{} : place);
}

void OptionCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  mousePressEvent(event);
  if (selected_.state >= 0) Q_EMIT activated();
}

bool OptionCanvas::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto place = graph_.at(transform().inverted().map(QPointF(help->pos())));
  QToolTip::showText(help->globalPos(), OptionGraph::toolTip(model_, place), this);
  return true;
}

}  // namespace widgets
