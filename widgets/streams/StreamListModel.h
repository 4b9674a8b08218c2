// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "robotlink/session/RemoteRobot.h"
#include "widgets/RowModel.h"
#include "widgets/streams/StreamAskers.h"

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
  /// Bytes a second, and bytes of a message; 0: unknown.
  double byteRate = 0, meanSize = 0;
  /// Its part of the bytes of all streams, 0 to 1.
  double share = 0;
  /// The messages that the line did not deliver; only for a remote robot.
  robotlink::MissingMessages missing = {};
  StreamAsked asked = {};
  /// Whether it has a row in the timeline.
  bool shown = true;
  /// Whether its messages are stepped; shown bold.
  bool stepped = false;

  bool operator==(const StreamRow&) const = default;
};

/// The streams of all open logs and of all live robots as a table: how much comes, what is left out, and who
/// asked for it. The check box of a row says whether the stream has a row in the timeline. GUI thread.
class StreamListModel final : public RowModel<StreamRow> {
  Q_OBJECT
 public:
  /// kByteRate in bytes per second, kMeanSize in bytes, kShare of the bytes of all streams.
  enum Column {
    kPath,
    kRate,
    kByteRate,
    kMeanSize,
    kCount,
    kBytes,
    kShare,
    kLeftOut,
    kAskedBy,
    kSchema,
    kLog,
    kColumns
  };
  /// The selection of streams in the list.
  enum class Which : std::uint8_t { kAll, kUnread, kLeftOut };
  /// Numbers as numbers.
  static constexpr int kSortRole = Qt::UserRole + 1;
  /// Path, schema and who asked in one text.
  static constexpr int kFilterRole = Qt::UserRole + 2;

  explicit StreamListModel(QObject* parent = nullptr);
  /// Replaces the rows, and sets their shares. Selections survive unless streams were added or removed.
  void setRows(std::vector<StreamRow> rows, Which which = Which::kAll);
  /// The rows of what is kept of live robots; if `robots` is not null, only of these.
  static std::vector<StreamRow> rowsOf(robotlink::Session& session,
                                       const std::set<std::string>* robots = nullptr);
  /// The rows of one log; `hidden` are the paths of streams without a row in the timeline.
  static std::vector<StreamRow> rowsOf(const std::string& log, const LogOverview& overview,
                                       const std::set<std::string>& hidden);

  QVariant data(const QModelIndex& index, int role) const override;
  /// Changes the check and emits shownChanged().
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 Q_SIGNALS:
  /// The user checked or unchecked a stream.
  void shownChanged(const std::string& log, const std::string& stream, bool shown);

 private:
  QVariant sortValue(const StreamRow& row, int column) const;
  QString shownText(const StreamRow& row, int column) const;
  QString toolTip(const StreamRow& row, int column) const;
};

}  // namespace widgets
