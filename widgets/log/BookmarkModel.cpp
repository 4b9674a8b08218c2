// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/BookmarkModel.h"

#include <algorithm>

#include "widgets/log/TimeScale.h"

namespace widgets {

void BookmarkModel::setRows(std::vector<Row> rows, robotlink::Instant origin) {
  if (rows == rows_ && origin == origin_) return;
  origin_ = origin;
  const auto sameOne = [](const Row& a, const Row& b) {
    return a.log == b.log && a.bookmark.id == b.bookmark.id;
  };
  if (!std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(), sameOne)) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
    return;
  }
  rows_ = std::move(rows);
  if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int BookmarkModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int BookmarkModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant BookmarkModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& at = row(index.row());
  const robotlink::Duration length = at.bookmark.to - at.bookmark.from;
  if (role == Qt::TextAlignmentRole && index.column() <= kLength)
    return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role == kSortRole && index.column() == kTime)
    return qlonglong{(at.bookmark.from + at.offset).time_since_epoch().count()};
  if (role == kSortRole && index.column() == kLength) return qlonglong{length.count()};
  if (role != Qt::DisplayRole && role != Qt::EditRole && role != kSortRole) return {};
  switch (index.column()) {
    case kTime:
      return timeText(at.bookmark.from + at.offset - origin_);
    case kLength:
      return length.count() > 0 ? timeText(length) : QStringLiteral("–");
    case kText:
      return QString::fromStdString(at.bookmark.text);
    default:
      return QString::fromStdString(std::filesystem::path(at.log).filename().string());
  }
}

bool BookmarkModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::EditRole || index.column() != kText) return false;
  const std::string log = row(index.row()).log;
  logplayer::Bookmark changed = row(index.row()).bookmark;
  changed.text = value.toString().toStdString();
  if (changed == row(index.row()).bookmark) return false;
  Q_EMIT changeWanted(log, changed);
  return true;
}

QVariant BookmarkModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QString titles[] = {tr("Time [s]"), tr("Length [s]"), tr("Bookmark"), tr("Log")};
  return titles[section];
}

Qt::ItemFlags BookmarkModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const auto flags = QAbstractTableModel::flags(index) | Qt::ItemNeverHasChildren;
  return index.column() == kText ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace widgets
