// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <optional>

#include "colortool/TableDifference.h"

namespace widgets {

/// What became of each class between two colour tables, a row each: those of the tables, none, and last the
/// sum. GUI thread.
class TableDifferenceModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kClass, kGained, kFrom, kLost, kTo, kBefore, kAfter, kColumns };

  using QAbstractTableModel::QAbstractTableModel;
  /// Null: there are no rows. Rows of the same classes keep their place, so that a selection does.
  void setDifference(std::shared_ptr<const colortool::TableDifference> difference);
  const colortool::TableDifference* difference() const { return difference_.get(); }
  /// The cells that a cell of the table speaks of: what was gained, what was lost, else both.
  colortool::CellSet cellsOf(const QModelIndex& index) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// Nothing for the sum.
  std::optional<int> classOf(int row) const;
  QString text(int row, int column) const;
  /// "white 120, none 33", the largest first.
  QString partners(int colorClass, bool gained, int atMost) const;

  std::shared_ptr<const colortool::TableDifference> difference_;
};

}  // namespace widgets
