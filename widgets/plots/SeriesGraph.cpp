// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/SeriesGraph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace widgets {
namespace {

using robotlink::Series;

robotlink::Instant instantAt(double seconds) {
  return robotlink::Instant(robotlink::fromSeconds(seconds));
}

/// The value at a time on the line between two points.
double valueBetween(const Series::Point& a, const Series::Point& b, double time) {
  const double length = b.time - a.time;
  return length > 0 ? a.value + (b.value - a.value) * (time - a.time) / length : b.value;
}

}  // namespace

/// Collects the bars of columns, each reaching to where the line left the one before.
class SeriesGraph::Bars {
 public:
  Bars(const QCPAxis& value, const QRect& area)
      : top_(area.top() - 2),
        height_(area.height() + 3),
        lower_(value.range().lower),
        offset_(value.coordToPixel(lower_) - top_),
        // The scale is computed as the axis does it, which takes a call for each.
        scale_((value.coordToPixel(value.range().upper) - top_ - offset_) / value.range().size()) {
    lines_.reserve(2 * static_cast<std::size_t>(area.width()) + 1);
  }

  /// Continues the line from column `x` at a value, or begins it there.
  void leaveAt(int x, double value) {
    isDrawing_ = !std::isnan(value);
    x_ = x;
    if (isDrawing_) y_ = pixel(value);
  }
  void interrupt() { isDrawing_ = false; }
  /// Draws the line up to the point at which it reaches column `x`.
  void goTo(int x, double value) {
    if (isDrawing_ && !std::isnan(value) && x > x_ + 1) lines_.emplace_back(x_, y_, x, pixel(value));
  }
  void add(int x, const Series::Extent& extent) {
    int top = pixel(extent.max), bottom = pixel(extent.min);
    if (isDrawing_ && x <= x_ + 1) {
      top = std::min(top, y_);
      bottom = std::max(bottom, y_);
    }
    lines_.emplace_back(x, top, x, bottom);
  }
  /// Lines are used, since where there is a clip, rectangles take twenty times as long.
  void draw(QCPPainter& painter) const { painter.drawLines(lines_.data(), static_cast<int>(lines_.size())); }

 private:
  /// A little outside for all that is not seen.
  int pixel(double value) const {
    return top_ + static_cast<int>(std::clamp(offset_ + scale_ * (value - lower_), 0.0, height_));
  }

  const int top_;  ///< Pixels are counted from here.
  const double height_;
  const double lower_, offset_, scale_;
  std::vector<QLine> lines_;
  int x_ = 0, y_ = 0;
  bool isDrawing_ = false;
};

SeriesGraph::SeriesGraph(QCPAxis* time, QCPAxis* value) : QCPGraph(time, value) {
  setAdaptiveSampling(false);
}

void SeriesGraph::draw(QCPPainter* painter) {
  if (!series_ || series_->empty() || !keyAxis() || !valueAxis()) return;
  const QCPRange times = keyAxis()->range();
  const int count = keyAxis()->axisRect()->width();
  const std::size_t begin = series_->firstFrom(times.lower), end = series_->firstAfter(times.upper);
  if (end - begin > static_cast<std::size_t>(std::max(0, count))) {
    drawColumns(*painter, count);
  } else {
    drawPoints(*painter, begin - std::min<std::size_t>(begin, 1), std::min(end + 1, series_->size()));
  }
}

bool SeriesGraph::isInterrupted(const Point& from, const Point& to) const {
  return !gaps_.empty() && isCut(gaps_, instantAt(from.time), instantAt(to.time));
}

void SeriesGraph::drawPoints(QCPPainter& painter, std::size_t begin, std::size_t end) {
  QVector<QCPGraphData> data;
  for (std::size_t i = begin; i < end; ++i) {
    const Point point = (*series_)[i];
    // The line ends where the graph has no number.
    if (i > begin && isInterrupted((*series_)[i - 1], point))
      data.append({((*series_)[i - 1].time + point.time) / 2, std::numeric_limits<double>::quiet_NaN()});
    data.append({point.time, point.value});
  }
  mDataContainer->set(data, true);
  QCPGraph::draw(&painter);
  mDataContainer->clear();
}

void SeriesGraph::drawColumns(QCPPainter& painter, int count) {
  const Series& series = *series_;
  const QRect area = keyAxis()->axisRect()->rect();
  const double from = keyAxis()->range().lower, to = keyAxis()->range().upper;
  Bars bars(*valueAxis(), area);
  std::size_t before = series.firstFrom(from);
  // The line begins at the point before, and leads to the one behind.
  if (before > 0) bars.leaveAt(area.left() - 1, valueBetween(series[before - 1], series[before], from));
  for (const Series::Column& column : series.columns(from, to, static_cast<std::size_t>(count))) {
    if (!gaps_.empty() && column.begin > 0 && isInterrupted(series[column.begin - 1], series[column.begin]))
      bars.interrupt();
    const int x = area.left() + static_cast<int>(column.part);
    bars.goTo(x, column.first);
    if (!column.extent.isEmpty()) bars.add(x, column.extent);
    bars.leaveAt(x, column.last);
    before = column.end;
  }
  if (before < series.size() && before > 0 && !isInterrupted(series[before - 1], series[before]))
    bars.goTo(area.right(), valueBetween(series[before - 1], series[before], to));
  painter.setAntialiasing(false);
  painter.setPen(pen());
  bars.draw(painter);
}

}  // namespace widgets
