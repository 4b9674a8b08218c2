// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "widgets/View.h"
#include "widgets/models/TimingModel.h"
#include "widgets/models/TypedStreams.h"

class QAction;
class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace widgets {

class EmptyHint;

/// How long the tasks of the selected robot take. Measuring costs a little, so it is on while the button
/// "Measure" is: it sets the debug key "timing/tasks". The view switches it on when it is first shown for a
/// robot.
class TimingView final : public View {
  Q_OBJECT
 public:
  explicit TimingView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  void followRobot();
  bool forgetDead();
  void measure(bool on);
  void reset();

  TimingModel model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_ = nullptr;
  QLabel* state_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* measure_ = nullptr;
  QAction* reset_ = nullptr;
  QAction* copy_ = nullptr;
  std::map<std::string, StreamCursor> cursors_;  // by stream
  std::string robot_;
  std::string program_;  // its processes and their tasks
};

}  // namespace widgets
