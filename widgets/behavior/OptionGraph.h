// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QRectF>
#include <QString>
#include <vector>

#include "widgets/behavior/BehaviorModel.h"

class QPainter;

namespace widgets {

/// The options of a behavior as a picture: a box for each, with a row for each of its states, in columns by
/// their depth below the root; lines from states to the options that they activate, and arcs for
/// transitions. Places are in pixels at zoom 1. A plain value.
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
  /// What is to be said of a place, as rich text.
  static QString toolTip(const BehaviorModel& model, const BehaviorModel::Place& place);

  /// Pure. `selected` may be nothing. The model must be that of the constructor, apart from what is active.
  void paint(QPainter& painter, const BehaviorModel& model, const BehaviorModel::Place& selected,
             const QPalette& palette) const;

 private:
  void paintOption(QPainter& painter, const BehaviorModel& model, int option,
                   const BehaviorModel::Place& selected, const QPalette& palette) const;
  void paintActivations(QPainter& painter, const BehaviorModel& model, const QPalette& palette) const;
  void paintTransitions(QPainter& painter, const BehaviorModel& model, int option,
                        const QPalette& palette) const;

  /// Indexed by option.
  std::vector<QRectF> boxes_;
  std::vector<int> rows_;
  QRectF bounds_;
};

}  // namespace widgets
