// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainterPath>
#include <QPalette>
#include <QRectF>
#include <QString>
#include <map>
#include <vector>

#include "widgets/behavior/BehaviorModel.h"

class QPainter;

namespace widgets {

/// The options of a behavior as a picture: a box for each, with a row for each of its states, in columns by
/// their depth below the root; lines from states to the options that they activate, which pass between the
/// boxes, and arcs for transitions. Places are in pixels at zoom 1. A plain value.
class OptionGraph {
 public:
  static constexpr double kWidth = 170, kHeader = 24, kRow = 20, kColumnGap = 60, kRowGap = 18, kMargin = 16;

  OptionGraph() = default;
  explicit OptionGraph(const BehaviorModel& model);

  QRectF bounds() const { return bounds_; }
  QRectF optionRect(int option) const;
  QRectF stateRect(const BehaviorModel::Place& place) const;
  /// The state, or with state -1 the option, that is shown at a point; nothing: option -1.
  BehaviorModel::Place at(const QPointF& point) const;
  /// A line from a state to an option that it activates.
  struct Line {
    BehaviorModel::Place from;
    int to = 0;
    QPainterPath path;
  };
  const std::vector<Line>& lines() const { return lines_; }
  /// The tooltip about a place, as rich text.
  static QString toolTip(const BehaviorModel& model, const BehaviorModel::Place& place);

  /// Pure. `selected` may be nothing. The model must be that of the constructor, apart from what is active.
  void paint(QPainter& painter, const BehaviorModel& model, const BehaviorModel::Place& selected,
             const QPalette& palette) const;

 private:
  /// A place where a line passes a column: above, between or below its boxes.
  struct Gap {
    double top = 0, bottom = 0;
    /// The number of lines that pass already.
    int lines = 0;
  };
  void findGaps();
  /// The height at which a line passes a column, near to one.
  double passage(int column, double near);
  void routeLines(const BehaviorModel& model);
  QPainterPath route(const BehaviorModel::Place& from, int to);
  static double leftOf(int column) { return kMargin + column * (kWidth + kColumnGap); }
  void paintOption(QPainter& painter, const BehaviorModel& model, int option,
                   const BehaviorModel::Place& selected, const QPalette& palette) const;
  void paintActivations(QPainter& painter, const BehaviorModel& model, const QPalette& palette) const;
  void paintTransitions(QPainter& painter, const BehaviorModel& model, int option,
                        const QPalette& palette) const;

  /// Indexed by option.
  std::vector<QRectF> boxes_;
  std::vector<int> rows_, columns_;
  std::map<int, std::vector<Gap>> gaps_;
  std::vector<Line> lines_;
  QRectF bounds_;
};

}  // namespace widgets
