// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotMarkers.h"

#include <qcustomplot.h>

#include "widgets/Theme.h"

namespace widgets {

bool PlotMarkers::set(std::vector<PlotMarker> markers) {
  if (markers.size() > kMaxMarkers) markers.resize(kMaxMarkers);
  if (markers == markers_) return false;
  markers_ = std::move(markers);
  remake();
  return true;
}

void PlotMarkers::remake() {
  constexpr double kQuarter = -90;  // degrees: the text reads upwards
  for (QCPAbstractItem* item : items_) plot_.removeItem(item);
  items_.clear();
  for (const PlotMarker& marker : markers_) {
    addLine(marker.from);
    if (marker.to > marker.from) addLine(marker.to);
    auto* text = new QCPItemText(&plot_);
    text->setText(marker.text);
    text->setRotation(kQuarter);
    text->setPositionAlignment(Qt::AlignRight | Qt::AlignTop);
    text->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    text->position->setCoords(marker.from, 0);
    text->setColor(colorOf(Meaning::kNote, plot_.palette()));
    text->setFont(plot_.font());
    items_.push_back(text);
  }
}

void PlotMarkers::addLine(double time) {
  auto* line = new QCPItemStraightLine(&plot_);
  line->point1->setCoords(time, 0);
  line->point2->setCoords(time, 1);
  line->setPen(QPen(colorOf(Meaning::kNote, plot_.palette()), 0, Qt::DotLine));
  items_.push_back(line);
}

}  // namespace widgets
