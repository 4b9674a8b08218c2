// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/ProcessGraphWidget.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/picture/PanKeys.h"

namespace widgets {

ProcessGraphWidget::ProcessGraphWidget(QWidget* parent) : QWidget(parent) {
  describe(*this, {"processGraph", tr("Graph of the processes"), {}});
  setToolTip({});
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
}

void ProcessGraphWidget::setGraph(ProcessGraph graph) {
  const bool moved = graph.bounds != graph_.bounds;
  graph_ = std::move(graph);
  if (moved && fitted_) fit();
  update();
}

void ProcessGraphWidget::setSelected(const QString& process) {
  look_.selected = process;
  update();
}

void ProcessGraphWidget::fit() {
  fitted_ = true;
  const QRectF bounds = graph_.bounds;
  if (bounds.isEmpty()) return;
  const double scale = std::clamp(std::min(width() / bounds.width(), height() / bounds.height()), 0.1, 1.5);
  look_.sceneToWidget = QTransform::fromTranslate(width() / 2.0, height() / 2.0)
                            .scale(scale, scale)
                            .translate(-bounds.center().x(), -bounds.center().y());
  update();
}

void ProcessGraphWidget::zoomAt(const QPointF& point, double factor) {
  const double wanted = std::clamp(scale() * factor, 0.1, 4.0);
  const QPointF scene = look_.sceneToWidget.inverted().map(point);
  fitted_ = false;
  look_.sceneToWidget =
      QTransform::fromTranslate(point.x(), point.y()).scale(wanted, wanted).translate(-scene.x(), -scene.y());
  update();
}

void ProcessGraphWidget::zoom(double factor) {
  zoomAt(QRectF(rect()).center(), factor);
}

void ProcessGraphWidget::pan(const QPointF& by) {
  fitted_ = false;
  look_.sceneToWidget *= QTransform::fromTranslate(by.x(), by.y());
  update();
}

QRectF ProcessGraphWidget::nodeRect(const QString& process) const {
  const int node = graph_.find(process);
  return node < 0 ? QRectF() : look_.sceneToWidget.mapRect(graph_.nodes[static_cast<std::size_t>(node)].rect);
}

void ProcessGraphWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint(painter, graph_, look_, palette());
}

void ProcessGraphWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (fitted_) fit();
}

void ProcessGraphWidget::wheelEvent(QWheelEvent* event) {
  zoomAt(event->position(), std::pow(1.2, event->angleDelta().y() / 120.0));
  event->accept();
}

const ProcessGraph::Node* ProcessGraphWidget::nodeAt(const QPointF& point) const {
  const QPointF scene = look_.sceneToWidget.inverted().map(point);
  const auto found = std::find_if(graph_.nodes.begin(), graph_.nodes.end(),
                                  [&](const auto& node) { return node.rect.contains(scene); });
  return found == graph_.nodes.end() ? nullptr : &*found;
}

void ProcessGraphWidget::mousePressEvent(QMouseEvent* event) {
  dragged_ = event->localPos();
  if (event->button() != Qt::LeftButton) return;
  const auto* node = nodeAt(event->localPos());
  setSelected(node != nullptr ? node->name : QString());
  Q_EMIT selected(look_.selected);
}

void ProcessGraphWidget::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) != 0) pan(event->localPos() - dragged_);
  dragged_ = event->localPos();
}

void ProcessGraphWidget::mouseDoubleClickEvent(QMouseEvent*) {
  fit();
}

void ProcessGraphWidget::keyPressEvent(QKeyEvent* event) {
  if (const auto step = panOfKey(*event, 40)) return pan(*step);
  switch (event->key()) {
    case Qt::Key_F:
      return fit();
    case Qt::Key_Plus:
      return zoom(1.2);
    case Qt::Key_Minus:
      return zoom(1 / 1.2);
    default:
      QWidget::keyPressEvent(event);
  }
}

QString ProcessGraphWidget::toolTipAt(const QPointF& point) const {
  const auto* node = nodeAt(point);
  if (node == nullptr) return {};
  const QPointF scene = look_.sceneToWidget.inverted().map(point);
  for (const auto* ports : {&node->inputs, &node->outputs}) {
    for (const auto& port : *ports) {
      if (!port.rect.contains(scene)) continue;
      QStringList lines{QStringLiteral("<b>%1</b> %2").arg(port.package, port.type)};
      lines << tr("%1, %2 a second")
                   .arg(counted(port.count, tr("1 package"), tr("%1 packages")))
                   .arg(port.rate, 0, 'f', 1);
      if (!port.peer.isEmpty())
        lines << tr("from %1, %2").arg(port.peer, port.blocking ? tr("blocking") : tr("not blocking"));
      if (port.peer.isEmpty() && port.blocking)
        lines << tr("blocking: the next frame waits until all receivers have taken it");
      if (port.held) lines << tr("held: replaced by a value published in the view Data");
      if (port.missed > 0)
        lines << counted(port.missed, tr("1 was replaced by a newer one before it was used"),
                         tr("%1 were replaced by newer ones before they were used"));
      return lines.join(QStringLiteral("<br>"));
    }
  }
  QStringList lines{QStringLiteral("<b>%1</b>").arg(node->name), node->state.toHtmlEscaped()};
  lines << tr("%1, %2 a second")
               .arg(counted(node->frames, tr("1 frame"), tr("%1 frames")))
               .arg(node->rate, 0, 'f', 1);
  if (!node->tasks.isEmpty()) lines << tr("Tasks: %1").arg(node->tasks.join(QStringLiteral(", ")));
  return lines.join(QStringLiteral("<br>"));
}

bool ProcessGraphWidget::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), toolTipAt(help->pos()), this);
  return true;
}

}  // namespace widgets
