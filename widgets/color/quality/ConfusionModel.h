// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "colortool/image/ColorClasses.h"
#include "colortool/scoring/Evaluation.h"

namespace widgets {

/// The confusion matrix of an evaluation: which class the pixels of each class were classified as. There is a
/// row for each class that occurs, a column for its recall, and a column for each class that occurs or was
/// found. Cells are shares of the row's pixels in percent. GUI thread.
class ConfusionModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  /// kShareRole: the share of a cell, 0 to 1; invalid in the column of recalls and in unknown rows.
  /// kRightRole: whether the cell is on the diagonal, where a large share is good.
  static constexpr int kShareRole = Qt::UserRole + 1, kRightRole = Qt::UserRole + 2;

  using QAbstractTableModel::QAbstractTableModel;
  /// Replaces the matrix; without an evaluation the table is empty. `alone` lists classes of a single stroke,
  /// whose figures mean nothing in cross-validation and are not shown.
  void setEvaluation(const colortool::ColorClasses& classes, std::optional<colortool::Evaluation> evaluation,
                     std::vector<std::uint8_t> alone = {});
  /// Mean recall of all classes but the background and those that are alone; unset if none is left.
  std::optional<double> meanRecall() const;
  /// Share of the background's pixels that were classified as a class of things (colortool::objectClasses()):
  /// neither green nor white, gray or black. Unset without background pixels.
  std::optional<double> falseColors() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// The share of the pixels of class `label` that were classified as class `found`, 0 to 1.
  double share(int label, int found) const;
  /// Whether the figures of a class mean nothing.
  bool isAlone(int colorClass) const;
  QString nameOf(int colorClass) const;
  QVariant toolTip(int label, int found) const;

  colortool::ColorClasses classes_;
  std::optional<colortool::Evaluation> evaluation_;
  std::vector<std::uint8_t> alone_;
  /// The class numbers of the rows and columns (without the column of recalls).
  std::vector<int> rows_, columns_;
};

}  // namespace widgets
