// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PathCanvas.h"

#include <qcustomplot.h>

#include <QBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/Theme.h"
#include "widgets/plots/CurveModel.h"
#include "widgets/plots/PlotStyle.h"

namespace widgets {
namespace {

using Curve = CurveModel::Curve;

std::vector<const Curve*> pathsOf(const CurveModel& curves) {
  std::vector<const Curve*> paths;
  for (const auto& curve : curves.curves()) {
    if (curve->across) paths.push_back(curve.get());
  }
  return paths;
}

/// The points of a path between two times.
QVector<QCPCurveData> pointsOf(const Curve& path, double from, double to) {
  const robotlink::Series &ys = path.points(), &xs = path.across->points();
  const std::size_t begin = ys.firstFrom(from), end = ys.firstAfter(to);
  const std::size_t step = (end - begin) / PathCanvas::kMaxPoints + 1;
  QVector<QCPCurveData> points;
  std::size_t x = xs.firstAfter(from);
  for (std::size_t y = begin; y < end; y += step) {
    const auto point = ys[y];
    while (x < xs.size() && xs[x].time <= point.time) ++x;
    if (x > 0) points.append({point.time, xs[x - 1].value, point.value});
  }
  return points;
}

}  // namespace

PathCanvas::PathCanvas(CurveModel& curves, QWidget* parent)
    : QWidget(parent), curves_(curves), plot_(new QCustomPlot(this)) {
  plot_->setObjectName(QStringLiteral("pathCanvas"));
  plot_->setAccessibleName(tr("Plot of one value over another"));
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMinimumSize(120, 100);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  plot_->setNotAntialiasedElements(QCP::aeAll);
  plot_->axisRect()->setupFullAxesBox(false);
  for (QCPAxis* axis : {plot_->xAxis2, plot_->yAxis2}) axis->setTicks(false);
  connect(plot_, &QCustomPlot::mouseWheel, this, [this] { isFitted_ = false; });
  connect(plot_, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) isFitted_ = false;
  });
  connect(plot_, &QCustomPlot::mouseDoubleClick, this, &PathCanvas::fit);
  connect(plot_, &QCustomPlot::afterLayout, this, [this] {
    if (isEqual_) plot_->yAxis->setScaleRatio(plot_->xAxis, 1);
  });
  applyTheme();
}

void PathCanvas::applyTheme() {
  stylePlot(*plot_, *plot_->axisRect(), palette(), font());
  matchPaths();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PathCanvas::matchPaths() {
  const auto paths = pathsOf(curves_);
  for (; paths_.size() > paths.size(); paths_.pop_back()) {
    plot_->removePlottable(paths_.back().graph);
    plot_->removeItem(paths_.back().mark);
  }
  while (paths_.size() < paths.size())
    paths_.push_back({new QCPCurve(plot_->xAxis, plot_->yAxis), new QCPItemTracer(plot_), {}, {}});
  const QString separator = QStringLiteral(" over ");
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const QColor color = curveColor(paths[i]->color, palette());
    paths_[i].graph->setPen(QPen(color, 1));
    paths_[i].mark->setStyle(QCPItemTracer::tsCircle);
    paths_[i].mark->setSize(11);
    paths_[i].mark->setPen(QPen(palette().color(QPalette::Text), 2));
    paths_[i].mark->setBrush(color);
  }
  const QString text = paths.empty() ? QString() : paths.front()->title;
  plot_->yAxis->setLabel(paths.size() == 1 ? text.section(separator, 0, 0) : QString());
  plot_->xAxis->setLabel(paths.size() == 1 ? text.section(separator, 1) : QString());
}

void PathCanvas::refresh(double from, double to, double shown) {
  matchPaths();
  const auto paths = pathsOf(curves_);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Curve& path = *paths[i];
    Path& drawn = paths_[i];
    const std::pair counts(path.points().size(), path.across->points().size());
    const std::pair times(from, to);
    if (counts != drawn.points || times != drawn.times)
      drawn.graph->data()->set(pointsOf(path, from, to), true);
    drawn.points = counts;
    drawn.times = times;
    const auto x = path.across->valueAt(shown), y = path.valueAt(shown);
    drawn.mark->setVisible(x && y);
    if (x && y) drawn.mark->position->setCoords(*x, *y);
  }
  if (isFitted_) fitPaths();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PathCanvas::fitPaths() {
  robotlink::Series::Extent xs, ys;
  for (const Path& path : paths_) {
    for (const QCPCurveData& point : *path.graph->data()) {
      if (!std::isfinite(point.key) || !std::isfinite(point.value)) continue;
      xs.add({point.key, point.key});
      ys.add({point.value, point.value});
    }
  }
  if (!xs.isEmpty()) showExtent(*plot_->xAxis, xs.min, xs.max);
  if (!ys.isEmpty()) showExtent(*plot_->yAxis, ys.min, ys.max);
  if (!isEqual_ || xs.isEmpty()) return;
  // The axis on which there is too much room follows from the other one.
  const QSize room = plot_->axisRect()->size();
  if (room.isEmpty()) return;
  const double perPixel =
      std::max(plot_->xAxis->range().size() / room.width(), plot_->yAxis->range().size() / room.height());
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    const double length = perPixel * (axis == plot_->xAxis ? room.width() : room.height());
    axis->setRange(axis->range().center(), length, Qt::AlignCenter);
  }
}

void PathCanvas::fit() {
  isFitted_ = true;
  fitPaths();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PathCanvas::setEqual(bool on) {
  isEqual_ = on;
  if (isFitted_) fitPaths();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PathCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) applyTheme();
  QWidget::changeEvent(event);
}

}  // namespace widgets
