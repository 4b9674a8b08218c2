// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <memory>
#include <optional>

#include "widgets/View.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorFiles.h"
#include "widgets/color/TableDifferenceModel.h"

class QAction;
class QLabel;
class QMenu;
class QTableView;
class QToolButton;

namespace widgets {

class EmptyHint;

/// Compares the colour table that is being made with another one: that of a file, itself as it is now (to see
/// what comes), or as it was some steps ago. Lists what each class gained and lost; a click selects these
/// cells, so that the image and the colour space show them. Follows the table.
class ColorCompareView final : public View {
  Q_OBJECT
 public:
  explicit ColorCompareView(ViewContext& context, QWidget* parent = nullptr);
  ~ColorCompareView() override;

  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createViews();
  QWidget* createToolRow();
  void connectSignals();

  void askForFile();
  void useFile(const QString& file);
  void takeStep(std::size_t position);
  void listSteps();
  void takeTrained();

  void compare();
  void showSums();
  /// The share of the pixels of the image that are of another class.
  std::optional<double> changedPixels() const;
  void selectCells(const QModelIndex& index);
  void tell(const QString& problem);

  ColorBench& bench_;
  ColorFiles& files_;
  TableDifferenceModel model_;
  QTableView* table_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QLabel *name_ = nullptr, *sums_ = nullptr, *problem_ = nullptr;
  QAction *open_ = nullptr, *now_ = nullptr, *none_ = nullptr, *showInImage_ = nullptr, *deselect_ = nullptr;
  QToolButton* steps_ = nullptr;
  QMenu* stepMenu_ = nullptr;

  bool dirty_ = true;
  std::future<ReferenceTable> training_;
  std::optional<colortool::CellSet> selected_;  ///< what this view selected last
};

}  // namespace widgets
