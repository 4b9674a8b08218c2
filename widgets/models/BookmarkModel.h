// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <string>
#include <vector>

#include "logplayer/Bookmarks.h"

namespace widgets {

/// The bookmarks of all open logs as a table; their texts can be edited. Shows times since the origin that
/// views count from. GUI thread.
class BookmarkModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kTime, kLength, kText, kLog, kColumns };
  static constexpr int kSortRole = Qt::UserRole + 1;

  struct Row {
    std::string log;  ///< its path
    robotlink::Duration offset{0};
    logplayer::Bookmark bookmark;  ///< in times of its log
    bool operator==(const Row&) const = default;
  };

  using QAbstractTableModel::QAbstractTableModel;
  void setRows(std::vector<Row> rows, robotlink::Instant origin);
  const Row& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  /// Asks for the change; the rows change when they are set anew.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  void changeWanted(const std::string& log, const logplayer::Bookmark& bookmark);

 private:
  std::vector<Row> rows_;
  robotlink::Instant origin_{};
};

}  // namespace widgets
