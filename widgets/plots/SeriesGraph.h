// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include <memory>
#include <vector>

#include "robotlink/series/Series.h"
#include "robotlink/session/RemoteRobot.h"

namespace widgets {

/// A graph that draws a series of any length at a cost that depends on its width in pixels only: where there
/// are more points than columns of pixels, each column gets a bar from the smallest to the largest value.
/// That is what the line of all points looks like, one pixel wide. GUI thread; the plot owns it.
class SeriesGraph final : public QCPGraph {
 public:
  SeriesGraph(QCPAxis* time, QCPAxis* value);
  /// Null: nothing is drawn.
  void setSeries(std::shared_ptr<const robotlink::Series> series) { series_ = std::move(series); }
  /// Stretches of time that no line crosses.
  void setGaps(std::vector<robotlink::LineGap> gaps) { gaps_ = std::move(gaps); }

 protected:
  void draw(QCPPainter* painter) override;

 private:
  class Bars;
  using Point = robotlink::Series::Point;
  /// Draws each of the points [begin, end).
  void drawPoints(QCPPainter& painter, std::size_t begin, std::size_t end);
  void drawColumns(QCPPainter& painter, int count);
  /// Whether there is no line between two points.
  bool isInterrupted(const Point& from, const Point& to) const;

  std::shared_ptr<const robotlink::Series> series_;
  std::vector<robotlink::LineGap> gaps_;
};

}  // namespace widgets
