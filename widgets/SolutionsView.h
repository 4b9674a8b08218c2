// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/models/SolutionModel.h"

class QAction;
class QLabel;
class QSplitter;
class QTreeView;

namespace widgets {

class EmptyHint;
class ParameterPanel;

/// The tasks of the selected robot and the solutions that exist for them. One click on a solution, or Space,
/// switches to it; what cannot be chosen says why. The panel below edits the parameters of the current
/// solution.
class SolutionsView final : public View {
  Q_OBJECT
 public:
  explicit SolutionsView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  void choose(const QModelIndex& index);
  void select(const std::string& task, const std::string& solution);
  void selectDefaults();
  void showCurrent(const QModelIndex& index);
  void say(const QString& text, bool bad);

  SolutionModel model_;
  QTreeView* tree_ = nullptr;
  QSplitter* splitter_ = nullptr;
  ParameterPanel* parameters_ = nullptr;
  QLabel* state_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* defaults_ = nullptr;
  QAction* showParameters_ = nullptr;
  std::string robot_;
  std::vector<const void*> shown_;  // the tables that are shown
};

}  // namespace widgets
