// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "widgets/data/FieldTable.h"

namespace widgets {

/// Shows a FieldTable: the time in s since the timeline's origin, and a column for each field. GUI thread.
class FieldTableModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  using QAbstractTableModel::QAbstractTableModel;
  void setTable(FieldTable table, robotlink::Instant origin);
  const FieldTable& table() const { return table_; }
  robotlink::Instant origin() const { return origin_; }
  /// The last row that is not later than an instant; -1: there is none.
  int rowAt(robotlink::Instant time) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  FieldTable table_;
  robotlink::Instant origin_;
};

}  // namespace widgets
