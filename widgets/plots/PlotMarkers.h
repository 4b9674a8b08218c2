// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

class QCPAbstractItem;
class QCustomPlot;

namespace widgets {

/// Something that happened at a time, or from one to another, in s.
struct PlotMarker {
  double from = 0, to = 0;
  QString text;
  bool operator==(const PlotMarker&) const = default;
};

/// Marks times in a plot by lines with a text. GUI thread.
class PlotMarkers {
 public:
  /// More are not shown.
  static constexpr std::size_t kMaxMarkers = 500;

  /// `plot` must outlive this; its palette and font are used.
  explicit PlotMarkers(QCustomPlot& plot) : plot_(plot) {}
  /// True if they are others than before, so that the plot must be drawn.
  bool set(std::vector<PlotMarker> markers);
  /// Makes the items again, in the colors of the palette.
  void remake();

 private:
  void addLine(double time);

  QCustomPlot& plot_;
  std::vector<PlotMarker> markers_;
  std::vector<QCPAbstractItem*> items_;
};

}  // namespace widgets
