// SPDX-License-Identifier: GPL-3.0-or-later
// Painting of a ProcessGraph: a pure function of the graph, the look and the palette.
#include <QPainter>
#include <QPainterPath>

#include "widgets/Theme.h"
#include "widgets/processes/GraphLayout.h"
#include "widgets/processes/ProcessGraphWidget.h"

namespace widgets {
namespace {

constexpr double kNodeMargin = 8;

QString rateText(double rate) {
  return rate > 0 ? ProcessGraphWidget::tr("%1 Hz").arg(rate, 0, 'f', rate < 10 ? 1 : 0) : QString();
}

QColor portColor(const ProcessGraph::Port& port, const QPalette& palette) {
  if (port.falls) return colorOf(Meaning::kWarning, palette);
  return port.rate > 0 ? colorOf(Meaning::kNote, palette) : colorOf(Meaning::kMuted, palette);
}

QPainterPath edgePath(const ProcessGraph& graph, const ProcessGraph::Edge& edge) {
  const QRectF from = graph.output(edge).rect, to = graph.input(edge).rect;
  const QPointF start(from.right(), from.center().y()), end(to.left(), to.center().y());
  QPainterPath path(start);
  if (!edge.back) {
    const double bow = std::max(40.0, (end.x() - start.x()) / 2);
    path.cubicTo(start + QPointF(bow, 0), end - QPointF(bow, 0), end);
    return path;
  }
  // Edges against the flow run below all nodes, so that they cross nothing.
  const double low = graph.bounds.bottom() - 24, side = GraphSizes::kColumnGap / 2;
  const QPointF turn(start.x(), low), back(end.x(), low);
  path.cubicTo(start + QPointF(side, 0), turn + QPointF(side, 0), turn);
  path.lineTo(back);
  path.cubicTo(back - QPointF(side, 0), end - QPointF(side, 0), end);
  return path;
}

void paintEdge(QPainter& painter, const ProcessGraph& graph, const ProcessGraph::Edge& edge,
               const QString& selected, const QPalette& palette) {
  const auto& input = graph.input(edge);
  const bool chosen = graph.nodes[static_cast<std::size_t>(edge.from)].name == selected ||
                      graph.nodes[static_cast<std::size_t>(edge.to)].name == selected;
  QPen pen(portColor(input, palette), chosen ? 2.4 : 1.4);
  if (!input.blocking) pen.setDashPattern({4, 3});
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(edgePath(graph, edge));
  const QPointF tip(input.rect.left(), input.rect.center().y());
  painter.setPen(Qt::NoPen);
  painter.setBrush(pen.color());
  painter.drawPolygon(QPolygonF(QVector<QPointF>{tip, tip + QPointF(-7, -3.5), tip + QPointF(-7, 3.5)}));
}

void paintPort(QPainter& painter, const ProcessGraph::Port& port, bool output, const QPalette& palette) {
  const QRectF row = port.rect.adjusted(kNodeMargin, 0, -kNodeMargin, 0);
  // The number of missed packages matters more than the rate, which is shown at the sender and in
  // the tooltip.
  const bool lossy = !output && port.falls;
  const QString figures = port.held ? ProcessGraphWidget::tr("held")
                          : lossy   ? ProcessGraphWidget::tr("%1 missed").arg(port.missed)
                                    : rateText(port.rate);
  const double width = painter.fontMetrics().horizontalAdvance(figures);
  const QRectF name = output ? row.adjusted(width + 6, 0, 0, 0) : row.adjusted(0, 0, -width - 6, 0);
  painter.setPen(palette.color(QPalette::Text));
  painter.drawText(
      name, (output ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
      painter.fontMetrics().elidedText(port.package, Qt::ElideRight, static_cast<int>(name.width())));
  // A blocking output ends at a bar, behind which the process waits.
  if (output && port.blocking) {
    const QPointF end(port.rect.right(), port.rect.center().y());
    painter.fillRect(QRectF(end - QPointF(4, 6), QSizeF(4, 12)), palette.color(QPalette::Text));
  }
  painter.setPen(lossy || port.held ? colorOf(Meaning::kWarning, palette)
                                    : colorOf(Meaning::kMuted, palette));
  painter.drawText(row, (output ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter, figures);
}

void paintNodeHeader(QPainter& painter, const ProcessGraph::Node& node, const QPalette& palette) {
  const QRectF header(node.rect.topLeft(), QSizeF(node.rect.width(), GraphSizes::kHeader));
  const QRectF line = header.adjusted(kNodeMargin, 3, -kNodeMargin, -GraphSizes::kHeader / 2);
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(node.failed ? colorOf(Meaning::kBad, palette) : palette.color(QPalette::Text));
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, node.name);
  font.setBold(false);
  painter.setFont(font);
  painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, rateText(node.rate));
  QString below = node.tasks.join(QStringLiteral(", "));
  if (node.state.isEmpty()) below = ProcessGraphWidget::tr("platform");
  if (node.failed || node.state == QLatin1String("stopped")) below = node.state;
  painter.setPen(node.failed ? colorOf(Meaning::kBad, palette) : colorOf(Meaning::kMuted, palette));
  const QRectF second = line.translated(0, GraphSizes::kHeader / 2 - 4);
  painter.drawText(second, Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(below, Qt::ElideRight, static_cast<int>(second.width())));
}

void paintNode(QPainter& painter, const ProcessGraph::Node& node, bool selected, const QPalette& palette) {
  const QColor base = palette.color(QPalette::Base), text = palette.color(QPalette::Text);
  QColor frame = mixed(base, text, 0.35);
  if (node.failed) frame = colorOf(Meaning::kBad, palette);
  if (selected) frame = palette.color(QPalette::Highlight);
  QPainterPath box, header;
  box.addRoundedRect(node.rect, 6, 6);
  header.addRect(QRectF(node.rect.topLeft(), QSizeF(node.rect.width(), GraphSizes::kHeader - 2)));
  const QColor tint =
      node.failed ? mixed(base, colorOf(Meaning::kBad, palette), 0.18) : mixed(base, text, 0.07);
  painter.fillPath(box, base);
  painter.fillPath(box.intersected(header), tint);
  painter.setPen(QPen(frame, selected || node.failed ? 2.2 : 1.2));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(box);
  paintNodeHeader(painter, node, palette);
  for (const auto& port : node.inputs) paintPort(painter, port, false, palette);
  for (const auto& port : node.outputs) paintPort(painter, port, true, palette);
}

}  // namespace

void ProcessGraphWidget::paint(QPainter& painter, const ProcessGraph& graph, const Look& look,
                               const QPalette& palette) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setTransform(look.sceneToWidget, true);
  QFont font = painter.font();
  font.setPixelSize(12);
  painter.setFont(font);
  for (const auto& edge : graph.edges) paintEdge(painter, graph, edge, look.selected, palette);
  for (const auto& node : graph.nodes) paintNode(painter, node, node.name == look.selected, palette);
}

}  // namespace widgets
