// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

class QCPAxisRect;
class QCPItemStraightLine;
class QPen;

namespace widgets {

/// A vertical line at a time, through the curves of a plot and the strips of states below them. The plot owns
/// its items. GUI thread.
class PlotLine {
 public:
  PlotLine(QCPAxisRect& curves, QCPAxisRect& strips);
  /// In s; empty: no line.
  void setTime(std::optional<double> time);
  void setPen(const QPen& pen);

 private:
  std::array<QCPItemStraightLine*, 2> lines_;
};

}  // namespace widgets
