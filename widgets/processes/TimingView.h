// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "widgets/TypedStreams.h"
#include "widgets/View.h"
#include "widgets/processes/TimingModel.h"

class QAction;
class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace widgets {

class EmptyHint;

/// Run times of the selected robot's tasks. Measuring costs the robot some time, so it is on only while the
/// button "Measure" is checked, which sets the debug key "timing/tasks". When another robot is selected while
/// the button is checked, the view requests the key for that robot and clears the statistics.
///
/// Registered as "timing". GUI thread.
class TimingView final : public View {
  Q_OBJECT
 public:
  explicit TimingView(ViewContext& context, QWidget* parent = nullptr);
  /// Adds the StopwatchTimes that arrived since the last tick.
  void tick() override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Starts over when another robot is selected.
  void followRobot();
  /// Removes the rows of processes and tasks that the robot's layout no longer has. True if the layout
  /// changed.
  bool forgetDead();
  /// Requests the debug key on or off.
  void measure(bool on);

  TimingModel model_;
  /// The model sorted by TimingModel::kNumberRole.
  QSortFilterProxyModel* sorted_;
  QTableView* table_ = nullptr;
  QLabel* state_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* measure_ = nullptr;
  QAction* reset_ = nullptr;
  QAction* copy_ = nullptr;
  /// What was already read of each stream, by path.
  std::map<std::string, StreamCursor> cursors_;
  std::string robot_;
  /// Processes and tasks of the robot as one string, to detect another layout.
  std::string program_;
};

}  // namespace widgets
