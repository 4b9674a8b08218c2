// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "robotlink/base/Worker.h"
#include "widgets/View.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorFiles.h"
#include "widgets/color/quality/TableDifferenceModel.h"

class QAction;
class QLabel;
class QMenu;
class QTableView;

namespace widgets {

class EmptyHint;

/// Compares the trained color table with a reference: the table of a file, the trained table as it is now (to
/// see the effect of what follows), or as it was some steps ago. Lists what each class gained and lost; a
/// click selects these cells, so that the image and the color space show them. Follows every change of the
/// table.
///
/// Registered as "color-compare". GUI thread.
class ColorCompareView final : public View {
  Q_OBJECT
 public:
  explicit ColorCompareView(ViewContext& context, QWidget* parent = nullptr);
  /// Waits for a training that has begun.
  ~ColorCompareView() override;

  /// Compares again if a table changed, and takes over a table that was trained.
  void tick() override;

 private:
  void createActions();
  void createViews();
  QWidget* createToolRow();
  void connectSignals();

  /// Opens a dialog, then useFile().
  void askForFile();
  /// Reads the reference from a file; problems are shown.
  void useFile(const QString& file);
  /// Trains the reference from the samples after `position` steps, in another thread.
  void takeStep(std::size_t position);
  /// Fills the menu of steps.
  void listSteps();
  /// Takes over the table that takeStep() has trained, once it is ready.
  void takeTrained();

  /// Computes the differences.
  void compare();
  /// Updates the line below the table.
  void showSums();
  /// Share of the image's pixels that changed their class, 0 to 1; unset without an image.
  std::optional<double> changedPixels() const;
  /// Selects the cells behind a cell of the table.
  void selectCells(const QModelIndex& index);
  /// Shows a problem; empty: none.
  void report(const QString& problem);

  ColorBench& bench_;
  ColorFiles& files_;
  TableDifferenceModel model_;
  QTableView* table_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QLabel *name_ = nullptr, *sums_ = nullptr, *problem_ = nullptr;
  QAction *open_ = nullptr, *now_ = nullptr, *none_ = nullptr, *showInImage_ = nullptr, *deselect_ = nullptr;
  QMenu* stepMenu_ = nullptr;

  /// The table after a step, which is to be trained.
  struct Step {
    std::uint64_t number;
    colortool::Samples samples;
    QString name;
  };
  /// Whether the tables changed since the last comparison.
  bool dirty_ = true;
  /// The cells that this view last selected; while the bench selects the same, it follows the difference.
  std::optional<colortool::CellSet> selected_;
  /// The newest step, and whether its table is still wanted.
  std::uint64_t step_ = 0;
  bool awaited_ = false;
  /// Trains the table of a step; its result is with the step's number.
  robotlink::Worker<Step, std::pair<std::uint64_t, ReferenceTable>> trainer_;
};

}  // namespace widgets
