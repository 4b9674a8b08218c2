// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/session/StreamStore.h"

namespace widgets {

/// A field of a stream's messages, as a column of a table over time.
struct FieldColumn {
  std::string stream;
  /// A path as robotlink::FieldPath parses it.
  std::string field;
  bool operator==(const FieldColumn&) const = default;
};

/// Values of some fields over time: a row for each time at which one of their streams has a message.
struct FieldTable {
  struct Row {
    robotlink::Instant time;
    /// For each column; empty where it has no value.
    std::vector<std::string> cells;
  };
  /// The maximum number of rows, of which the last ones are kept.
  static constexpr std::size_t kMaxRows = 500'000;

  std::vector<FieldColumn> columns = {};
  /// In order of time.
  std::vector<Row> rows = {};
  /// Whether there were more rows.
  bool isCut = false;

  /// RFC 4180, with the column "time_s": seconds since `origin`.
  std::string csv(robotlink::Instant origin) const;
};

/// The source of a table: the fields, and the messages of their streams or a log that has them. A value
/// that threads pass on.
struct FieldTableSource {
  /// A message, shared with the session's history.
  struct Message {
    robotlink::Instant time;
    robotlink::PackagePtr value;
  };
  std::vector<FieldColumn> columns = {};
  /// For each column the messages of its stream; not used for a log.
  std::vector<std::vector<Message>> messages = {};
  /// The pieces of the history on disk, before these messages; not used for a log.
  std::vector<robotlink::HistoryArchive::Piece> pieces = {};
  /// A log that is read instead; empty: none. The streams of the columns in it, and what is added to its
  /// times.
  std::filesystem::path log = {};
  std::vector<std::string> logStreams = {};
  robotlink::Duration offset{0};
};

/// Takes the messages that a session holds, in memory and in its archive, which may be null; it shares them,
/// which is quick.
FieldTableSource historyOf(const robotlink::StreamStore& store, const robotlink::HistoryArchive* archive,
                           std::vector<FieldColumn> columns);

/// Makes the table. `goesOn` is called from time to time with the progress, 0 to 1; if it returns false,
/// making fails with "log.given-up". Any thread.
robotlink::Result<FieldTable> makeTable(const FieldTableSource& source,
                                        const std::function<bool(double)>& goesOn);

}  // namespace widgets
