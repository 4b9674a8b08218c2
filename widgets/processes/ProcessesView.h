// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/process/Link.h"
#include "widgets/View.h"
#include "widgets/processes/ProcessTableModel.h"

class QAction;
class QSplitter;
class QTableView;

namespace widgets {

class EmptyHint;
class HostingBar;
class ProcessGraphWidget;

/// The processes of the selected robot, as a graph with the packages between them and their rates, and as a
/// table. Rates are means over about the last two seconds on the platform's clock; less if the history is
/// shorter.
///
/// Registered as "processes". GUI thread.
class ProcessesView final : public View {
  Q_OBJECT
 public:
  explicit ProcessesView(ViewContext& context, QWidget* parent = nullptr);
  /// Updates graph and table if the robot or its ProcessTable changed.
  void tick() override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Rebuilds graph and table from the newest ProcessTable and the one two seconds before.
  void showTables();

  /// Shows where the program runs.
  void showHosting();

  ProcessTableModel model_;
  HostingBar* hosting_ = nullptr;
  ProcessGraphWidget* graph_ = nullptr;
  QTableView* table_ = nullptr;
  QSplitter* splitter_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* fit_ = nullptr;
  QAction* zoomIn_ = nullptr;
  QAction* zoomOut_ = nullptr;
  /// Shows the table below the graph.
  QAction* details_ = nullptr;
  /// Shows the links of the debug process.
  QAction* debugLinks_ = nullptr;
  /// Requests the tables from the robot.
  QAction* refresh_ = nullptr;
  std::string robot_;
  /// The ProcessTable that is shown, to detect a new one.
  robotlink::PackagePtr shown_;
  /// The HostingStatus that is shown.
  robotlink::PackagePtr shownHosting_;
};

}  // namespace widgets
