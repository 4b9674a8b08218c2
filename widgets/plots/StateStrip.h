// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

#include <memory>
#include <utility>
#include <vector>

#include "robotlink/series/Series.h"
#include "widgets/plots/PlotSource.h"

namespace widgets {

/// A row that shows which state lasted from when to when: stretches in a color for each state, with its name
/// where there is room. States that change faster than pixels are dark. The axis of values counts rows. What
/// it costs depends on its width in pixels only. GUI thread; the plot owns it.
class StateStrip final : public QCPGraph {
 public:
  /// The states of one source: of the session, or of a log.
  struct Part {
    std::shared_ptr<const robotlink::Series> series;
    /// The position in rows, downward.
    double top = 0, bottom = 1;
    bool operator==(const Part&) const = default;
  };
  StateStrip(QCPAxis* time, QCPAxis* rows) : QCPGraph(time, rows) { setAntialiased(false); }
  void setParts(std::vector<Part> parts) { parts_ = std::move(parts); }
  /// The names of the states; they must outlive what is drawn.
  void setNames(std::shared_ptr<const StateNames> names) { names_ = std::move(names); }
  /// The time, in s, up to which the last state is known to last.
  void setEnd(double time) { end_ = time; }
  /// Stretches of time in which nothing is known.
  void setGaps(std::vector<std::pair<double, double>> gaps) { gaps_ = std::move(gaps); }
  void setColors(const QPalette& palette, const QFont& font);

 protected:
  void draw(QCPPainter* painter) override;

 private:
  void drawPart(QCPPainter& painter, const Part& part) const;
  void drawState(QCPPainter& painter, const QRect& where, double value) const;

  std::vector<Part> parts_;
  std::shared_ptr<const StateNames> names_;
  double end_ = 0;
  std::vector<std::pair<double, double>> gaps_;
  QPalette palette_;
  QFont font_;
};

}  // namespace widgets
