// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/items/PlotMarkers.h"

#include <qcustomplot.h>

#include <algorithm>

#include "widgets/Theme.h"

namespace widgets {

/// Lines at many times, which are drawn at a cost that depends on those that are seen.
class MarkerLines final : public QCPAbstractItem {
 public:
  explicit MarkerLines(QCustomPlot& plot) : QCPAbstractItem(&plot) { setClipAxisRect(plot.axisRect()); }
  double selectTest(const QPointF&, bool, QVariant*) const override { return -1; }

  std::vector<PlotMarker> lines;
  QPalette palette;

 protected:
  void draw(QCPPainter* painter) override {
    const QCPAxisRect& area = *clipAxisRect();
    const QCPAxis& time = *area.axis(QCPAxis::atBottom);
    painter->setAntialiasing(false);
    int drawn = -1;
    for (auto at = std::ranges::lower_bound(lines, time.range().lower, {}, &PlotMarker::from);
         at != lines.end() && at->from <= time.range().upper; ++at) {
      const int x = static_cast<int>(time.coordToPixel(at->from));
      if (x == drawn) continue;
      drawn = x;
      painter->setPen(QPen(colorOf(at->meaning, palette), 0, Qt::DotLine));
      painter->drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
      // A head, by which it can be told from bookmarks.
      painter->fillRect(QRect(x - 2, area.top(), 5, 5), colorOf(at->meaning, palette));
    }
  }
};

PlotMarkers::PlotMarkers(QCustomPlot& plot) : plot_(plot), lines_(new MarkerLines(plot)) {}

bool PlotMarkers::setLines(std::vector<PlotMarker> lines) {
  if (lines == lines_->lines) return false;
  lines_->lines = std::move(lines);
  return true;
}

QStringList PlotMarkers::textsNear(double time, double reach) const {
  constexpr int kMost = 8;
  QStringList texts;
  for (auto at = std::ranges::lower_bound(lines_->lines, time - reach, {}, &PlotMarker::from);
       at != lines_->lines.end() && at->from <= time + reach; ++at) {
    if (texts.size() == kMost) return texts << QStringLiteral("…");
    texts << at->text;
  }
  return texts;
}

bool PlotMarkers::set(std::vector<PlotMarker> markers) {
  if (markers.size() > kMaxMarkers) markers.resize(kMaxMarkers);
  if (markers == markers_) return false;
  markers_ = std::move(markers);
  remake();
  return true;
}

void PlotMarkers::remake() {
  constexpr double kQuarter = -90;  // degrees: the text reads upward
  lines_->palette = plot_.palette();
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
