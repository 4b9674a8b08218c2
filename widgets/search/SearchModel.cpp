// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/search/SearchModel.h"

#include <algorithm>

namespace widgets {

using robotlink::Instant;

SearchModel::SearchModel(QObject* parent)
    : TitledModel({tr("Time"), tr("Lasts"), tr("Robot"), tr("Text"), tr("Log")}, parent) {}

void SearchModel::clear() {
  beginResetModel();
  rows_.clear();
  endResetModel();
}

void SearchModel::add(const std::vector<SearchRow>& rows) {
  for (const SearchRow& row : rows) {
    const auto at = std::ranges::upper_bound(rows_, row.from, {}, &SearchRow::from);
    const int place = static_cast<int>(at - rows_.begin());
    beginInsertRows({}, place, place);
    rows_.insert(at, row);
    endInsertRows();
  }
}

void SearchModel::move(std::size_t log, robotlink::Duration by) {
  beginResetModel();
  for (SearchRow& row : rows_) {
    if (row.number != log) continue;
    row.from += by;
    if (row.until) *row.until += by;
  }
  std::ranges::stable_sort(rows_, {}, &SearchRow::from);
  endResetModel();
}

void SearchModel::setOrigin(Instant time) {
  if (origin_ == time) return;
  origin_ = time;
  announceRows();
}

int SearchModel::rowAt(Instant time) const {
  return static_cast<int>(std::ranges::upper_bound(rows_, time, {}, &SearchRow::from) - rows_.begin()) - 1;
}

QString SearchModel::csv() const {
  const auto quoted = [](QString text) {
    return QStringLiteral("\"%1\"").arg(text.replace(QLatin1String("\""), QLatin1String("\"\"")));
  };
  QString text = QStringLiteral("from_s,until_s,robot,text,log\n");
  for (const SearchRow& row : rows_) {
    const auto time = [this](Instant at) {
      return QString::number(robotlink::seconds(at - origin_), 'f', 6);
    };
    text += QStringList{time(row.from), row.until ? time(*row.until) : QString(), quoted(row.robot),
                        quoted(row.text), quoted(row.log)}
                .join(QLatin1Char(',')) +
            QLatin1Char('\n');
  }
  return text;
}

int SearchModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant SearchModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const SearchRow& at = row(index.row());
  if (role == Qt::TextAlignmentRole && index.column() <= kLength) return kNumberAlignment;
  if (role == Qt::ToolTipRole && index.column() == kText) return at.text;
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kFrom:
      return QString::number(robotlink::seconds(at.from - origin_), 'f', 3);
    case kLength:
      if (!at.until) return tr("to the end");
      return *at.until == at.from ? QString()
                                  : QString::number(robotlink::seconds(*at.until - at.from), 'f', 3);
    case kRobot:
      return at.robot;
    case kText:
      return at.text;
    default:
      return at.log;
  }
}

}  // namespace widgets
