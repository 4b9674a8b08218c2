// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/models/CurveModel.h"
#include "widgets/models/PlotTreeModel.h"

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QSortFilterProxyModel;
class QSplitter;
class QTreeView;

namespace widgets {

class EmptyHint;
class PlotCanvas;

/// Values over time: any plot value, any number in any stream. Curves come from a searchable tree by double
/// click, Enter or drag; what a robot does not tell yet is asked for by its debug key, and that is said. The
/// legend shows the values of the moment, and those under the cursor.
class PlotsView final : public View {
  Q_OBJECT
 public:
  /// Asks for the name of a file to write; empty: cancelled.
  using FileQuestion = std::function<QString(const QString& title, const QString& suffix)>;

  explicit PlotsView(ViewContext& context, QWidget* parent = nullptr);
  void setFileQuestion(FileQuestion question) { askForFile_ = std::move(question); }
  /// Adds a curve by PlotSource::text().
  void addCurve(const QString& source);
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createTree();
  void createLegend();
  void createViews();
  void connectSignals();
  void addSelected();
  void removeSelected();
  void listSources();
  void requestMissing();
  void exportCsv();
  void exportPng();
  double shownTime() const;
  QString jointOf(const PlotSource& source) const;
  void showCursor(std::optional<double> time);

  PlotTreeModel sources_;
  CurveModel curves_;
  QSortFilterProxyModel* filter_;
  FileQuestion askForFile_;
  PlotCanvas* canvas_ = nullptr;
  QTreeView* tree_ = nullptr;
  QWidget* treePanel_ = nullptr;
  QTreeView* legend_ = nullptr;
  QLineEdit* search_ = nullptr;
  QComboBox* window_ = nullptr;
  QLabel* state_ = nullptr;
  QSplitter* splitter_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* showTree_ = nullptr;
  QAction* add_ = nullptr;
  QAction* remove_ = nullptr;
  QAction* follow_ = nullptr;
  QAction* pause_ = nullptr;
  QAction* fit_ = nullptr;
  QAction* csv_ = nullptr;
  QAction* png_ = nullptr;
  std::uint64_t listVersion_ = 0;
  int ticks_ = 0;
  bool dirty_ = true;
  double drawnTime_ = -1;
};

}  // namespace widgets
