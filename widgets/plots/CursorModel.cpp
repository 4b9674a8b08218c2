// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/CursorModel.h"

#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "widgets/Theme.h"

namespace widgets {

CursorModel::CursorModel(const CurveModel& curves, QObject* parent)
    : QAbstractTableModel(parent), curves_(curves) {
  for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
    connect(&curves, signal, this, &CursorModel::update);
  connect(&curves, &QAbstractItemModel::modelReset, this, &CursorModel::update);
  connect(&curves, &QAbstractItemModel::dataChanged, this, [this](const QModelIndex& topLeft) {
    if (topLeft.column() <= CurveModel::kValue) update();
  });
}

void CursorModel::setCursors(const Cursors& cursors) {
  if (cursors_ == cursors) return;
  cursors_ = cursors;
  for (Row& row : rows_) row.count = kUnknown;
  update();
  Q_EMIT headerDataChanged(Qt::Horizontal, kName, kDeviation);
}

void CursorModel::update() {
  std::vector<Row> rows;
  if (cursors_) {
    const auto [from, to] = std::minmax(cursors_->first, cursors_->second);
    for (const auto& curve : curves_.curves()) {
      const robotlink::Series& points = curve->points();
      const std::size_t begin = points.firstFrom(from), end = points.firstAfter(to);
      rows.push_back({curve->title, curve->source().text(), curve->color, curve->valueAt(cursors_->first),
                      curve->valueAt(cursors_->second), end - begin});
      Row& row = rows.back();
      const Row* before = rows.size() <= rows_.size() ? &rows_[rows.size() - 1] : nullptr;
      const bool isKnown = before != nullptr && before->name == row.name && before->count == row.count;
      const auto name = [&](const std::optional<double>& value) {
        return value ? curve->words(*value) : QStringLiteral("–");
      };
      if (curve->isStrip()) row.states = {name(row.first), name(row.second)};
      row.between = isKnown ? before->between : robotlink::statistics(points, begin, end);
    }
  }
  const bool isOther = rows.size() != rows_.size();
  if (isOther) beginResetModel();
  rows_ = std::move(rows);
  if (isOther) endResetModel();
  if (!isOther && !rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int CursorModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int CursorModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

std::optional<double> CursorModel::number(const Row& row, int column) {
  switch (column) {
    case kFirst:
      return row.first;
    case kSecond:
      return row.second;
    case kDifference:
      return row.first && row.second ? std::optional(*row.second - *row.first) : std::nullopt;
    case kMin:
      return row.between.min;
    case kMax:
      return row.between.max;
    case kMean:
      return row.between.mean;
    default:
      return row.between.deviation;
  }
}

QVariant CursorModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  if (index.column() == kName) {
    if (role == Qt::DecorationRole) return curveColor(row.color, QGuiApplication::palette());
    return role == Qt::DisplayRole ? row.title : role == Qt::ToolTipRole ? row.name : QVariant();
  }
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  if (row.states) {
    return index.column() == kFirst    ? row.states->first
           : index.column() == kSecond ? row.states->second
                                       : QStringLiteral("–");
  }
  const auto value = number(row, index.column());
  return value && !std::isnan(*value) ? QString::number(*value, 'g', 5) : QStringLiteral("–");
}

QVariant CursorModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kName:
      return tr("Between the cursors");
    case kFirst:
      return tr("At A");
    case kSecond:
      return tr("At B");
    case kDifference:
      return tr("B − A");
    case kMin:
      return tr("Minimum");
    case kMax:
      return tr("Maximum");
    case kMean:
      return tr("Mean");
    default:
      return tr("Deviation");
  }
}

}  // namespace widgets
