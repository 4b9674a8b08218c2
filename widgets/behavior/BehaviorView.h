// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <utility>

#include "robotlink/process/Link.h"
#include "widgets/PackageSubscription.h"
#include "widgets/View.h"
#include "widgets/behavior/BehaviorModel.h"
#include "widgets/behavior/OptionHistory.h"

class QAction;
class QLabel;
class QSplitter;

namespace widgets {

class EmptyHint;
class HistoryStrip;
class OptionCanvas;
class ParameterEdits;

/// The behavior of the selected robot: its options and states as a graph, what is active, since when and why,
/// and the states of the last minute. States are forced, and transitions taken step by step, by the
/// parameters "control" of the behavior's solution.
///
/// Registered as "behavior". GUI thread.
class BehaviorView final : public View {
  Q_OBJECT
 public:
  explicit BehaviorView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  /// The states of the last minute, with when and why.
  std::optional<QString> numbers() override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  void updateActions();
  /// Asks whether a robot's behavior is held that is shown from now on.
  void followHold();
  void showHold(bool isHeld);
  void askHold();
  void forceSelected();
  void step();
  /// Sets a parameter of the robot's behavior. Returns whether it was sent; a refusal is shown by the
  /// session.
  bool setControl(const char* parameter, const std::string& value);

  BehaviorModel model_;
  OptionHistory history_;
  PackageSubscription subscription_;
  ParameterEdits* edits_ = nullptr;
  OptionCanvas* graph_ = nullptr;
  HistoryStrip* strip_ = nullptr;
  QLabel* now_ = nullptr;
  QSplitter* splitter_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* force_ = nullptr;
  QAction* release_ = nullptr;
  QAction* hold_ = nullptr;
  QAction* step_ = nullptr;
  std::string robot_;
  /// The robot and its solution to which Hold belongs; without a solution it can be held by nothing.
  std::pair<std::string, QString> controlled_;
  /// Counts the questions whether the behavior is held, and what the user chose instead.
  int holdNumber_ = 0;
  /// Ticks until it is asked again; 0: it is not.
  int ticksUntilHold_ = 0;
  /// The packages that are shown, to detect new ones.
  robotlink::PackagePtr shownGraph_, shownState_;
};

}  // namespace widgets
