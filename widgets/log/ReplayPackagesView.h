// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/models/ReplayPackageModel.h"

class QLabel;
class QSortFilterProxyModel;
class QTableView;

namespace widgets {

class EmptyHint;

/// From where the packages of a replay come, each as logged or recomputed by the program; how what is
/// recomputed differs from what was logged; which tasks of the program cannot run and why.
class ReplayPackagesView final : public View {
  Q_OBJECT
 public:
  explicit ReplayPackagesView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;

 private:
  void createViews();
  void connectSignals();
  void showTasks();

  OpenLogs& logs_;
  ReplayPackageModel model_;
  QSortFilterProxyModel* filtered_;
  QTableView* table_ = nullptr;
  QLabel* tasks_ = nullptr;
  EmptyHint* hint_ = nullptr;
};

}  // namespace widgets
