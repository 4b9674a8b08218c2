// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace google::protobuf {
class FieldDescriptor;
class Message;
}  // namespace google::protobuf

namespace logplayer {

/// Messages of one type as rows of a table, with a column for each field that occurs in any of them:
/// "position.x", "joints[0].position". Usage in two passes: learn() for all messages, then row() for each.
/// One thread.
class MessageTable {
 public:
  /// The usual limit of spreadsheets; further fields are left out.
  static constexpr std::size_t kMaxColumns = 16'384;

  /// `room`: the number of columns that may still be added; shared by tables that are put side by side.
  explicit MessageTable(std::shared_ptr<std::size_t> room = std::make_shared<std::size_t>(kMaxColumns))
      : room_(std::move(room)) {}

  /// Adds columns for the fields of a message.
  void learn(const google::protobuf::Message& message);
  /// The names of the columns, in the order of the schema and of repeated elements.
  std::vector<std::string> columns() const;
  /// Returns a cell per column; empty for unset fields. Timestamps and durations are seconds, enumerations
  /// names, bytes base64.
  std::vector<std::string> row(const google::protobuf::Message& message) const;
  /// Number of values for which there was no room for a column.
  std::uint64_t leftOut() const { return leftOut_; }

 private:
  /// The path to a value as field numbers and indices, from the outside in; sorts in the order of the schema.
  using Place = std::vector<int>;
  /// Visits all values of a message.
  class Walk;

  std::shared_ptr<std::size_t> room_;
  /// The names of the columns.
  std::map<Place, std::string> columns_;
  std::uint64_t leftOut_ = 0;
};

/// Formats a line of a CSV file (RFC 4180), including the line end.
std::string csvLine(const std::vector<std::string>& cells);
/// Formats a time in seconds: "12.340000000".
std::string secondsText(std::int64_t seconds, std::int64_t nanos);

}  // namespace logplayer
