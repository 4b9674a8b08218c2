// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "widgets/View.h"
#include "widgets/data/DataModel.h"

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QSplitter;
class QTreeView;

namespace widgets {

class EmptyHint;
class FieldTablePanel;
class PublishPanel;
class UnfoldedRows;

/// All streams of the session, by robot, as a tree of the fields of their messages at the instant that the
/// timeline shows. Values can be searched, copied, dragged into a plot, and compared with those of another
/// robot, of a remembered instant, or of the log that is replayed. Streams behind debug keys that are off are
/// gray; a click on their state switches the key on. Selected values are listed over time in a table below,
/// and messages to a robot are filled in and sent there.
///
/// Registered as "data". GUI thread.
class DataView final : public View {
  Q_OBJECT
 public:
  explicit DataView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;

  /// Compares with "none", "now" (remembers the values that are shown), "remembered", "logged", or a robot.
  /// Fails if there is no such robot.
  robotlink::Result<void> compareWith(const std::string& what);
  /// The comparisons that this function accepts now.
  static std::vector<std::string> comparisons(const robotlink::Session& session);

 private:
  void createActions();
  void createTree();
  void createViews();
  void connectSignals();
  /// Shows new data; the visible rows stay where they are.
  void updateModel();
  void search(const QString& words);
  /// Fills the combo box of what can be compared with, if the robots changed.
  void listComparisons();
  /// Applies what the combo box says.
  void compare();
  /// Plots a number, or switches on what is off.
  void activate(const QModelIndex& index);
  void switchOn(const QModelIndex& index);
  void plotSelected();
  /// Lists the selected values over time.
  void showTable();
  void copy(const QString& text);
  void copyJson();
  /// The selected rows in their order, in the column of names.
  QModelIndexList selectedRows() const;
  void showMenu(const QPoint& at);
  /// Updates actions, the line at the bottom and the hint.
  void showState();

  DataModel model_;
  QTreeView* tree_ = nullptr;
  UnfoldedRows* unfolded_ = nullptr;
  QLineEdit* search_ = nullptr;
  QComboBox* comparison_ = nullptr;
  QLabel* path_ = nullptr;
  QLabel* state_ = nullptr;
  FieldTablePanel* table_ = nullptr;
  PublishPanel* publishing_ = nullptr;
  QSplitter* splitter_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* remember_ = nullptr;
  QAction* plot_ = nullptr;
  QAction* listOverTime_ = nullptr;
  QAction* publish_ = nullptr;
  QAction* switchOn_ = nullptr;
  QAction* copyPath_ = nullptr;
  QAction* copyValue_ = nullptr;
  QAction* copyJson_ = nullptr;
  /// Whether rows were inserted or removed since updateModel() began.
  bool hasOtherRows_ = false;
  /// The robots that the combo box lists.
  std::vector<std::string> listedRobots_;
};

}  // namespace widgets
