// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "widgets/RowModel.h"

namespace robotlink {
class Session;
}

namespace widgets {

struct LogOverview;

/// A stream of a log, or of what is kept of live robots.
struct StreamRow {
  /// Path of the log; empty for a live robot, whose streams have no row in the timeline.
  std::string log;
  /// Path and schema of the stream.
  std::string path, type;
  /// Number of messages, and the sum of their sizes (0: not counted yet); of a live robot, the memory and
  /// the part of the disk's files that they take.
  std::uint64_t count = 0, bytes = 0;
  /// Hz; 0: unknown.
  double rate = 0;
  /// Whether it has a row in the timeline.
  bool shown = true;
  /// Whether its messages are stepped; shown bold.
  bool stepped = false;

  bool operator==(const StreamRow&) const = default;
};

/// The streams of all open logs as a table. The check box of a row says whether the stream has a row in the
/// timeline. GUI thread.
class StreamListModel final : public RowModel<StreamRow> {
  Q_OBJECT
 public:
  /// Path, number of messages, their size, rate in Hz, schema, and file name of the log.
  enum Column { kPath, kCount, kBytes, kRate, kSchema, kLog, kColumns };
  /// Numbers as numbers.
  static constexpr int kSortRole = Qt::UserRole + 1;
  /// Path and schema in one text.
  static constexpr int kFilterRole = Qt::UserRole + 2;

  explicit StreamListModel(QObject* parent = nullptr);
  /// Replaces the rows. Selections survive unless streams were added or removed.
  void setRows(std::vector<StreamRow> rows);
  /// The rows of what is kept of live robots.
  static std::vector<StreamRow> rowsOf(robotlink::Session& session);
  /// The rows of one log; `hidden` are the paths of streams without a row in the timeline.
  static std::vector<StreamRow> rowsOf(const std::string& log, const LogOverview& overview,
                                       const std::set<std::string>& hidden);

  QVariant data(const QModelIndex& index, int role) const override;
  /// Changes the check and emits shownChanged().
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  /// The user checked or unchecked a stream.
  void shownChanged(const std::string& log, const std::string& stream, bool shown);
};

/// "1.4 MB"
QString bytesText(std::uint64_t bytes);

}  // namespace widgets
