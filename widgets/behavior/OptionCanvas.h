// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTransform>
#include <QWidget>

#include "widgets/behavior/BehaviorModel.h"
#include "widgets/behavior/OptionGraph.h"

namespace widgets {

/// Shows the graph of a behavior's options, as large as fits; a click selects a state. Object name
/// "behaviorGraph". GUI thread.
class OptionCanvas final : public QWidget {
  Q_OBJECT
 public:
  /// The model must outlive the canvas.
  explicit OptionCanvas(const BehaviorModel& model, QWidget* parent = nullptr);
  /// Call it when options or states are others.
  void layOut();
  const BehaviorModel::Place& selected() const { return selected_; }
  void select(const BehaviorModel::Place& place);
  /// The rectangle of a state, in widget pixels.
  QRectF stateRect(const BehaviorModel::Place& place) const;

 Q_SIGNALS:
  void selectionChanged();
  /// The user double-clicked the selected state.
  void activated();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  /// From the graph's pixels to the widget's.
  QTransform transform() const;

  const BehaviorModel& model_;
  OptionGraph graph_;
  BehaviorModel::Place selected_;
};

}  // namespace widgets
