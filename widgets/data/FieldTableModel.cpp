// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/FieldTableModel.h"

#include <algorithm>

namespace widgets {

void FieldTableModel::setTable(FieldTable table, robotlink::Instant origin) {
  beginResetModel();
  table_ = std::move(table);
  origin_ = origin;
  endResetModel();
}

int FieldTableModel::rowAt(robotlink::Instant time) const {
  const auto later = std::ranges::upper_bound(table_.rows, time, {}, &FieldTable::Row::time);
  return static_cast<int>(later - table_.rows.begin()) - 1;
}

int FieldTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(table_.rows.size());
}

int FieldTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(table_.columns.size()) + 1;
}

QVariant FieldTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const FieldTable::Row& row = table_.rows[static_cast<std::size_t>(index.row())];
  if (index.column() == 0) return QString::number(robotlink::seconds(row.time - origin_), 'f', 3);
  return QString::fromStdString(row.cells[static_cast<std::size_t>(index.column() - 1)]);
}

QVariant FieldTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  if (section == 0) return tr("Time (s)");
  const FieldColumn& column = table_.columns[static_cast<std::size_t>(section - 1)];
  return QString::fromStdString(role == Qt::ToolTipRole ? column.stream + '.' + column.field : column.field);
}

}  // namespace widgets
