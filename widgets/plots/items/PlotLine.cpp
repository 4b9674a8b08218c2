// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/items/PlotLine.h"

#include <qcustomplot.h>

namespace widgets {
namespace {

QCPItemStraightLine* lineIn(QCPAxisRect& area) {
  auto* line = new QCPItemStraightLine(area.parentPlot());
  for (QCPItemPosition* point : {line->point1, line->point2})
    point->setAxes(area.axis(QCPAxis::atBottom), area.axis(QCPAxis::atLeft));
  line->setClipAxisRect(&area);
  line->setVisible(false);
  return line;
}

}  // namespace

PlotLine::PlotLine(QCPAxisRect& curves, QCPAxisRect& strips) : lines_{lineIn(curves), lineIn(strips)} {}

void PlotLine::setTime(std::optional<double> time) {
  for (QCPItemStraightLine* line : lines_) {
    line->setVisible(time.has_value());
    if (!time) continue;
    line->point1->setCoords(*time, 0);
    line->point2->setCoords(*time, 1);
  }
}

void PlotLine::setPen(const QPen& pen) {
  for (QCPItemStraightLine* line : lines_) line->setPen(pen);
}

}  // namespace widgets
