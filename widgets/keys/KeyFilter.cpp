// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/keys/KeyFilter.h"

#include <algorithm>

#include "widgets/keys/KeyTreeModel.h"

namespace widgets {

KeyFilter::KeyFilter(QObject* parent) : QSortFilterProxyModel(parent) {
  setRecursiveFilteringEnabled(true);
  setDynamicSortFilter(true);
}

void KeyFilter::setWords(const QString& text) {
  words_ = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  invalidateFilter();
}

void KeyFilter::setActiveOnly(bool on) {
  activeOnly_ = on;
  invalidateFilter();
}

bool KeyFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const QModelIndex index = sourceModel()->index(row, 0, parent);
  const QVariant kind = index.data(KeyTreeModel::kKindRole);
  if (!kind.isValid()) return false;  // a group is accepted with its keys
  if (activeOnly_ && kind.toInt() == 0) return false;
  const QString name = index.data(KeyTreeModel::kKeyRole).toString();
  return std::all_of(words_.begin(), words_.end(),
                     [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); });
}

}  // namespace widgets
