// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/solutions/SolutionModel.h"

class QAction;
class QLabel;
class QSplitter;
class QTreeView;

namespace widgets {

class EmptyHint;
class ParameterPanel;

/// The tasks of the selected robot and the solutions that exist for them. A click on a solution, or Space,
/// requests a switch to it; a solution that cannot be chosen shows the reason. A check box lets a solution
/// run in the shadow of the active one, and has the robot measure its tasks, so that what both cost is shown.
/// The panel below edits the parameters of the current solution.
///
/// Registered as "solutions". GUI thread.
class SolutionsView final : public View {
  Q_OBJECT
 public:
  explicit SolutionsView(ViewContext& context, QWidget* parent = nullptr);
  /// Updates the tree if the robot or its SolutionTables changed.
  void tick() override;
  /// The panel of parameters, which is hidden at first.
  ParameterPanel& parameters() { return *parameters_; }

 protected:
  /// Handles Space and Return in the tree.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Switches to the solution at `index`, or says why it cannot be chosen; ignores tasks.
  void choose(const QModelIndex& index);
  /// Requests a solution and shows the outcome.
  void select(const std::string& task, const std::string& solution);
  /// Requests that a solution runs in the shadow of the active one, or no longer, and shows the outcome.
  void requestShadow(const std::string& task, const std::string& solution, bool on);
  /// Has the robot measure its tasks if it does not, so that the costs are known.
  void measure();
  /// The team of the robot; empty: it has none, or none is known.
  std::string team() const;
  /// Requests the current solution from robots, this one included.
  void selectIn(const std::vector<std::string>& robots);
  /// Requests the layout's default solution for every task that runs another one.
  void selectDefaults();
  /// Says why there is nothing to choose, if there is nothing.
  void showHint();
  /// Shows the parameters of the solution at `index` if the panel is visible.
  void showCurrent(const QModelIndex& index);

  SolutionModel model_;
  int ticks_ = 0;
  QTreeView* tree_ = nullptr;
  QSplitter* splitter_ = nullptr;
  ParameterPanel* parameters_ = nullptr;
  /// Outcome of the last request.
  QLabel* state_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* defaults_ = nullptr;
  QAction *inTeam_ = nullptr, *inAllRobots_ = nullptr;
  QAction* showParameters_ = nullptr;
  std::string robot_;
  /// Addresses of the tables that the tree shows, to detect new ones.
  std::vector<const void*> shown_;
  /// The same of the tables of keys.
  std::vector<const void*> shownKeys_;
};

}  // namespace widgets
