// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "widgets/Theme.h"

class QCPAbstractItem;
class QCustomPlot;

namespace widgets {

/// An event at a time, or from one time to another, in s.
struct PlotMarker {
  double from = 0, to = 0;
  QString text;
  Meaning meaning = Meaning::kNote;
  bool operator==(const PlotMarker&) const = default;
};

class MarkerLines;

/// Marks times in a plot by lines with a text, or, where there may be thousands, by lines alone. GUI thread.
class PlotMarkers {
 public:
  /// The maximum number of markers shown.
  static constexpr std::size_t kMaxMarkers = 500;

  /// `plot` must outlive this; its palette and font are used.
  explicit PlotMarkers(QCustomPlot& plot);
  /// True if they are others than before, so that the plot must be drawn.
  bool set(std::vector<PlotMarker> markers);
  /// The same of lines without texts, in order of time.
  bool setLines(std::vector<PlotMarker> lines);
  /// The texts of lines near a time, in s, a few at most.
  QStringList textsNear(double time, double reach) const;
  /// Makes the items again, in the colors of the palette.
  void remake();

 private:
  void addLine(double time);

  QCustomPlot& plot_;
  std::vector<PlotMarker> markers_;
  std::vector<QCPAbstractItem*> items_;
  /// The plot owns it.
  MarkerLines* lines_;
};

}  // namespace widgets
