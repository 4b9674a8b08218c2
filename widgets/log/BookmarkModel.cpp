// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/BookmarkModel.h"

#include <algorithm>

#include "widgets/log/TimeScale.h"

namespace widgets {

BookmarkModel::BookmarkModel(QObject* parent)
    : RowModel({tr("Time [s]"), tr("Length [s]"), tr("Bookmark"), tr("Log")}, parent) {}

void BookmarkModel::setRows(std::vector<BookmarkRow> rows, robotlink::Instant origin) {
  if (rows == rows_ && origin == origin_) return;
  origin_ = origin;
  replaceRows(std::move(rows), [](const BookmarkRow& a, const BookmarkRow& b) {
    return a.log == b.log && a.bookmark.id == b.bookmark.id;
  });
}

QVariant BookmarkModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const BookmarkRow& at = row(index.row());
  const robotlink::Duration length = at.bookmark.to - at.bookmark.from;
  if (role == Qt::TextAlignmentRole && index.column() <= kLength) return kNumberAlignment;
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

Qt::ItemFlags BookmarkModel::flags(const QModelIndex& index) const {
  const auto flags = QAbstractTableModel::flags(index);
  return index.column() == kText ? flags | Qt::ItemIsEditable : flags;
}

}  // namespace widgets
