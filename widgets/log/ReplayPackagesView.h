// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/log/ReplayPackageModel.h"

class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace widgets {

class EmptyHint;

/// The packages of a replay, each as logged or recomputed by the robot's program; how the recomputed ones
/// differ from the logged ones; and which tasks of the program cannot run, and why.
///
/// Registered as "replay-packages". GUI thread.
class ReplayPackagesView final : public View {
  Q_OBJECT
 public:
  explicit ReplayPackagesView(ViewContext& context, QWidget* parent = nullptr);
  /// Shows the replay's newest status.
  void tick() override;

 private:
  void createViews();
  void connectSignals();
  /// Updates the text about tasks that cannot run.
  void showTasks();

  OpenLogs& logs_;
  ReplayPackageModel model_;
  QSortFilterProxyModel* filtered_;
  QTableView* table_ = nullptr;
  QLabel* tasks_ = nullptr;
  EmptyHint* hint_ = nullptr;
};

}  // namespace widgets
