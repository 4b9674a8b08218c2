// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "colortool/ColorClasses.h"
#include "colortool/Evaluation.h"

namespace widgets {

/// What pixels of each class were found to be: a row for each class that occurs, a column for its recall and
/// one for each class that occurs or was found. Shares of a row's pixels. GUI thread.
class ConfusionModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  /// The share of a cell, 0 to 1, and whether it is right that it is large.
  static constexpr int kShareRole = Qt::UserRole + 1, kRightRole = Qt::UserRole + 2;

  using QAbstractTableModel::QAbstractTableModel;
  /// Nothing: the table is empty. `alone`: classes whose figures say nothing.
  void setEvaluation(const colortool::ColorClasses& classes, std::optional<colortool::Evaluation> evaluation,
                     std::vector<std::uint8_t> alone = {});
  /// Over the classes, without background, whose figures say something; nothing without such.
  std::optional<double> meanRecall() const;
  /// Share of the background's pixels that were found to be of a colour that things have, neither green nor
  /// white, grey or black (colortool::isThingColor()); nothing without background.
  std::optional<double> falseColors() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  double share(int label, int found) const;
  bool isAlone(int colorClass) const;
  QString nameOf(int colorClass) const;
  QVariant toolTip(int label, int found) const;

  colortool::ColorClasses classes_;
  std::optional<colortool::Evaluation> evaluation_;
  std::vector<std::uint8_t> alone_;
  std::vector<int> rows_, columns_;  ///< classes
};

}  // namespace widgets
