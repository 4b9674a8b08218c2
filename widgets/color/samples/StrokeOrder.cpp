// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/samples/StrokeOrder.h"

#include "widgets/color/samples/StrokeModel.h"

namespace widgets {

StrokeOrder::StrokeOrder(StrokeModel& strokes, QObject* parent)
    : QSortFilterProxyModel(parent), strokes_(strokes) {
  setSourceModel(&strokes);
  setSortRole(StrokeModel::kSortRole);
}

void StrokeOrder::freeze() {
  if (!places_.empty()) return;
  for (int row = 0; row < rowCount(); ++row)
    places_[strokes_.stroke(mapToSource(index(row, 0)).row()).id] = static_cast<std::size_t>(row);
}

void StrokeOrder::thaw() {
  if (places_.empty()) return;
  places_.clear();
  invalidate();
}

std::size_t StrokeOrder::placeOf(const QModelIndex& index) const {
  const auto found = places_.find(strokes_.stroke(index.row()).id);
  return found == places_.end() ? places_.size() + static_cast<std::size_t>(index.row()) : found->second;
}

bool StrokeOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  if (places_.empty()) return QSortFilterProxyModel::lessThan(left, right);
  return sortOrder() == Qt::AscendingOrder ? placeOf(left) < placeOf(right) : placeOf(right) < placeOf(left);
}

}  // namespace widgets
