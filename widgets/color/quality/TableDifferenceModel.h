// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "colortool/table/TableDifference.h"

#include "widgets/TitledModel.h"

namespace widgets {

/// The difference of two color tables: what each class gained and lost, one row per class of both tables, one
/// for no class, and last the sums. GUI thread.
class TableDifferenceModel final : public TitledModel {
  Q_OBJECT
 public:
  /// Class, cells gained, from which classes, cells lost, to which classes, cells before and after.
  enum Column { kClass, kGained, kFrom, kLost, kTo, kBefore, kAfter, kColumns };

  explicit TableDifferenceModel(QObject* parent = nullptr);
  /// Null: there are no rows. Rows, and so the selection, are kept if the classes are the same.
  void setDifference(std::shared_ptr<const colortool::TableDifference> difference);
  /// Null: none.
  const colortool::TableDifference* difference() const { return difference_.get(); }
  /// The cells that a cell of the table represents: those gained, those lost, or both.
  colortool::CellSet cellsOf(const QModelIndex& index) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// The class of a row; unset for the sums.
  std::optional<int> classOf(int row) const;
  QString text(int row, int column) const;
  /// The classes from (or to) which cells changed: "white 120, none 33", largest first, at most `atMost`.
  QString partners(int colorClass, bool gained, int atMost) const;

  std::shared_ptr<const colortool::TableDifference> difference_;
};

}  // namespace widgets
