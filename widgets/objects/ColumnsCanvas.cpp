// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/ColumnsCanvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/Theme.h"

namespace widgets {
namespace {

constexpr int kAxisWidth = 56, kColumnMargin = 8;  // px

/// The number of at least this size that is a digit, and none that is hard to divide, times a power of ten.
double roundedUp(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (step * power >= value * (1 - 1e-9)) return step * power;
  return 10 * power;
}

QRectF columnArea(const QSize& size) {
  return {QPointF(kAxisWidth, kColumnMargin),
          QPointF(std::max(kAxisWidth + 1, size.width() - kColumnMargin),
                  std::max(kColumnMargin + 1, size.height() - kColumnMargin))};
}

double heightOf(const QRectF& area, const ColumnGraph& graph, double value) {
  const double share = std::clamp((value - graph.low) / (graph.high - graph.low), 0.0, 1.0);
  return area.bottom() - share * area.height();
}

void paintAxis(QPainter& painter, const QRectF& area, const ColumnGraph& graph, const QPalette& palette) {
  constexpr int kLines = 4;
  for (int i = 0; i <= kLines; ++i) {
    const double value = graph.low + (graph.high - graph.low) * i / kLines;
    const double y = heightOf(area, graph, value);
    painter.setPen(mixed(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.2));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(palette.color(QPalette::Text));
    const QRectF place(0, y - 10, kAxisWidth - 4, 20);
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, QString::number(value, 'g', 3));
  }
  if (graph.unit.isEmpty()) return;
  painter.drawText(QRectF(area.left() + 4, area.top(), area.width(), 20), Qt::AlignLeft | Qt::AlignTop,
                   graph.unit);
}

}  // namespace

void ColumnGraph::fit(double minimum, double maximum) {
  const bool isLimited = maximum > minimum && std::isfinite(minimum) && std::isfinite(maximum);
  double lowest = 0, highest = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  low = lowest < 0 ? -roundedUp(-lowest) : 0;
  high = highest > 0 ? roundedUp(highest) : low < 0 ? 0 : 1;
  if (!isLimited) return;
  // A sensor that reports nothing but 0 has all of its range before it.
  if (highest <= 0 && lowest >= 0) high = maximum;
  low = std::max(low, std::min(minimum, 0.0));
  high = std::max(std::min(high, maximum), low + 1e-12);
}

void SteadyLimits::Limits::include(const Limits& other) {
  low = std::min(low, other.low);
  high = std::max(high, other.high);
}

void SteadyLimits::apply(ColumnGraph& graph) {
  const Limits own{graph.low, graph.high};
  if (!wanted_) wanted_ = own;
  wanted_->include(own);
  if (!shown_) shown_ = own;
  shown_->include(own);
  if (++count_ >= kPatience) {
    shown_ = std::exchange(wanted_, std::nullopt);
    count_ = 0;
  }
  graph.low = shown_->low;
  graph.high = shown_->high;
}

void paintColumns(QPainter& painter, const QSize& size, const ColumnGraph& graph, const QPalette& palette,
                  std::optional<int> marked) {
  painter.fillRect(QRect(QPoint(), size), palette.color(QPalette::Base));
  const QRectF area = columnArea(size);
  // An empty graph shows a hint on how to fill it.
  if (graph.values.empty()) return;
  paintAxis(painter, area, graph, palette);
  const double step = area.width() / static_cast<double>(graph.values.size());
  const double zero = heightOf(area, graph, 0);
  const double gap = step > 4 ? 0.15 * step : 0;
  for (std::size_t i = 0; i < graph.values.size(); ++i) {
    if (!std::isfinite(graph.values[i])) continue;
    const double y = heightOf(area, graph, graph.values[i]);
    const double x = area.left() + step * static_cast<double>(i);
    const bool isMarked = marked == static_cast<int>(i);
    painter.fillRect(
        QRectF(QPointF(x + gap / 2, std::min(y, zero)), QPointF(x + step - gap / 2, std::max(y, zero))),
        isMarked ? palette.color(QPalette::Highlight) : curveColor(0, palette));
  }
}

ColumnsCanvas::ColumnsCanvas(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("columnsCanvas"));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(120, 80);
}

void ColumnsCanvas::show(ColumnGraph graph) {
  graph_ = std::move(graph);
  if (marked_ && *marked_ >= static_cast<int>(graph_.values.size())) mark(std::nullopt);
  update();
}

std::optional<int> ColumnsCanvas::columnAt(const QPoint& at) const {
  const QRectF area = columnArea(size());
  if (graph_.values.empty() || at.x() < area.left() || at.x() >= area.right()) return std::nullopt;
  const double share = (at.x() - area.left()) / area.width();
  const int last = static_cast<int>(graph_.values.size()) - 1;
  return std::clamp(static_cast<int>(share * static_cast<double>(graph_.values.size())), 0, last);
}

void ColumnsCanvas::mark(std::optional<int> column) {
  if (column == marked_) return;
  marked_ = column;
  update();
  Q_EMIT pointedAt(column.value_or(-1));
}

void ColumnsCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintColumns(painter, size(), graph_, palette(), marked_);
}

void ColumnsCanvas::mouseMoveEvent(QMouseEvent* event) {
  mark(columnAt(event->pos()));
}

void ColumnsCanvas::leaveEvent(QEvent*) {
  mark(std::nullopt);
}

void ColumnsCanvas::keyPressEvent(QKeyEvent* event) {
  const int last = static_cast<int>(graph_.values.size()) - 1;
  const int by = event->key() == Qt::Key_Left ? -1 : event->key() == Qt::Key_Right ? 1 : 0;
  if (by == 0 || last < 0) return QWidget::keyPressEvent(event);
  mark(marked_ ? std::clamp(*marked_ + by, 0, last) : by > 0 ? 0 : last);
}

}  // namespace widgets
