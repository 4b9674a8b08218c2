// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/HeaderState.h"

#include <QHeaderView>
#include <QJsonArray>
#include <QJsonObject>
#include <QSet>
#include <algorithm>

#include "widgets/ColumnFit.h"

namespace widgets {
namespace {

constexpr int kMinSection = 8, kMaxSection = 4000;  // pixels; clamps widths of damaged states

}  // namespace

QJsonValue headerState(const QHeaderView& header) {
  QJsonArray columns;
  const ColumnFit* fit = ColumnFit::of(header);
  for (int visual = 0; visual < header.count(); ++visual) {
    const int column = header.logicalIndex(visual);
    columns.append(QJsonArray{column, fit != nullptr ? fit->pinned(column) : header.sectionSize(column)});
  }
  return QJsonObject{{QStringLiteral("columns"), columns},
                     {QStringLiteral("sorted_by"), header.sortIndicatorSection()},
                     {QStringLiteral("descending"), header.sortIndicatorOrder() == Qt::DescendingOrder}};
}

void restoreHeader(QHeaderView& header, const QJsonValue& state) {
  const QJsonArray columns = state[QLatin1String("columns")].toArray();
  QSet<int> known;
  for (const auto& value : columns) {
    const int column = value.toArray().at(0).toInt(-1);
    if (column >= 0 && column < header.count()) known.insert(column);
  }
  if (columns.size() != header.count() || known.size() != header.count()) return;
  ColumnFit* fit = ColumnFit::of(header);
  for (int visual = 0; visual < header.count(); ++visual) {
    const QJsonArray entry = columns.at(visual).toArray();
    const int column = entry.at(0).toInt(), width = entry.at(1).toInt();
    header.moveSection(header.visualIndex(column), visual);
    if (fit != nullptr) {
      fit->pin(column, width);
      continue;
    }
    if (width > 0) header.resizeSection(column, std::clamp(width, kMinSection, kMaxSection));
  }
  const int sorted = state[QLatin1String("sorted_by")].toInt(-1);
  if (!header.isSortIndicatorShown() || sorted < 0 || sorted >= header.count()) return;
  header.setSortIndicator(
      sorted, state[QLatin1String("descending")].toBool() ? Qt::DescendingOrder : Qt::AscendingOrder);
}

}  // namespace widgets
