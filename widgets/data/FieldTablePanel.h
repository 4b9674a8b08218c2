// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <atomic>
#include <functional>
#include <vector>

#include "robotlink/base/Worker.h"
#include "widgets/View.h"
#include "widgets/data/FieldTableModel.h"

class QAction;
class QComboBox;
class QLabel;
class QProgressBar;
class QTableView;

namespace widgets {

class OpenLogs;

/// A table of some fields over time, of the history that the session holds or of the whole log at the play
/// head, which can be saved as CSV. It is made in a thread; what takes longer than half a second shows its
/// progress and can be canceled. The table does not change by itself; Refresh reads it again. GUI thread.
class FieldTablePanel final : public QWidget {
  Q_OBJECT
 public:
  /// Returns the name of the file to write; empty: canceled. Tests replace the dialog by it.
  using FileQuestion = std::function<QString(const QString& title, const QString& suggestion)>;

  FieldTablePanel(ViewContext& context, QWidget* parent);
  void setFileQuestion(FileQuestion question) { askForFile_ = std::move(question); }

  /// Begins a table of these fields, and shows the panel.
  void show(std::vector<FieldColumn> columns);
  /// Takes the table when it is complete; call this in each tick.
  void tick();

 private:
  void createActions();
  void createViews();
  /// Starts the table over.
  void refresh();
  /// The columns in the log at the play head; false: it does not have their streams.
  bool readsLog(FieldTableSource& source);
  void take(robotlink::Result<FieldTable> table);
  void saveCsv();

  ViewContext& context_;
  OpenLogs& logs_;
  FileQuestion askForFile_;
  FieldTableModel model_;
  std::vector<FieldColumn> columns_;
  QTableView* table_ = nullptr;
  /// The source of the table: the history, or the log.
  QComboBox* source_ = nullptr;
  QLabel* state_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QAction* refresh_ = nullptr;
  QAction* cancel_ = nullptr;
  QAction* csv_ = nullptr;
  QAction* close_ = nullptr;
  /// Ticks since the table was begun; negative: none is being made.
  int ticks_ = -1;
  /// Written by the thread.
  std::atomic<double> share_{0};
  robotlink::Worker<FieldTableSource, robotlink::Result<FieldTable>> worker_;
};

}  // namespace widgets
