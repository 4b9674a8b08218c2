// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/models/ProcessTableModel.h"

class QAction;
class QSplitter;
class QTableView;

namespace widgets {

class EmptyHint;
class ProcessGraphWidget;

/// The processes of the selected robot: as a graph with the packages between them and their rates, and as a
/// table. Rates are means over about the last two seconds of the platform's time.
class ProcessesView final : public View {
  Q_OBJECT
 public:
  explicit ProcessesView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  void showTables();

  ProcessTableModel model_;
  ProcessGraphWidget* graph_ = nullptr;
  QTableView* table_ = nullptr;
  QSplitter* splitter_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* fit_ = nullptr;
  QAction* zoomIn_ = nullptr;
  QAction* zoomOut_ = nullptr;
  QAction* details_ = nullptr;
  QAction* debugLinks_ = nullptr;
  QAction* refresh_ = nullptr;
  std::string robot_;
  const void* shown_ = nullptr;  // the newest table that is shown
};

}  // namespace widgets
