// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "logplayer/bookmarks/Bookmarks.h"

#include "widgets/RowModel.h"

namespace widgets {

/// A bookmark and the log that contains it.
struct BookmarkRow {
  /// Path of the log; with the bookmark's id it identifies the row.
  std::string log;
  /// Added to the log's times to get times of the timeline.
  robotlink::Duration offset{0};
  /// In the log's own times.
  logplayer::Bookmark bookmark;

  bool operator==(const BookmarkRow&) const = default;
};

/// The bookmarks of all open logs as a table. The texts can be edited; an edit is a signal to the owner, who
/// changes the bookmark and sets the rows again. Times are shown in seconds from the origin that all views
/// count from. GUI thread.
class BookmarkModel final : public RowModel<BookmarkRow> {
  Q_OBJECT
 public:
  /// Beginning, length, text, and the file name of the log.
  enum Column { kTime, kLength, kText, kLog, kColumns };
  /// Times and lengths as integers in ns, everything else as its text.
  static constexpr int kSortRole = Qt::UserRole + 1;

  explicit BookmarkModel(QObject* parent = nullptr);
  /// Replaces the rows. `origin` is the instant shown as 0 s. Selections survive unless bookmarks were added,
  /// removed or reordered.
  void setRows(std::vector<BookmarkRow> rows, robotlink::Instant origin);

  QVariant data(const QModelIndex& index, int role) const override;
  /// Emits changeWanted() if the text differs; the model itself is not changed.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  /// The user edited a text. `bookmark` is the whole bookmark with the new text.
  void changeWanted(const std::string& log, const logplayer::Bookmark& bookmark);

 private:
  robotlink::Instant origin_{};
};

}  // namespace widgets
