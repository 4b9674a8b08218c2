// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "widgets/TitledModel.h"

namespace widgets {

/// A table with fixed titles whose rows are values, in their order. GUI thread.
template <typename Row>
class RowModel : public TitledModel {
 public:
  const Row& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }
  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
  }

 protected:
  using TitledModel::TitledModel;
  /// Replaces the rows. Selections survive if the rows are of the same things as before, in the same order,
  /// which `same` says of two rows.
  template <typename Same>
  void replaceRows(std::vector<Row> rows, Same same) {
    const bool kept = std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(), same);
    if (!kept) this->beginResetModel();
    rows_ = std::move(rows);
    kept ? this->announceRows() : this->endResetModel();
  }

  std::vector<Row> rows_;
};

}  // namespace widgets
