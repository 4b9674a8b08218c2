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

/// Messages of one type as the rows of a table, with a column for each field that occurs in any of them:
/// "position.x", "joints[0].position". First all messages are shown to learn(), then each to row(). One
/// thread.
class MessageTable {
 public:
  /// More columns than this no spreadsheet takes; fields past it are left out.
  static constexpr std::size_t kMaxColumns = 16'384;

  /// `room`: how many columns may still be made, shared by tables that stand side by side.
  explicit MessageTable(std::shared_ptr<std::size_t> room = std::make_shared<std::size_t>(kMaxColumns))
      : room_(std::move(room)) {}

  void learn(const google::protobuf::Message& message);
  /// In the order of the schema, elements of repeated fields in theirs.
  std::vector<std::string> columns() const;
  /// A cell for each column; empty where a field is not set. Time stamps and durations are seconds,
  /// enumerations names, bytes base64.
  std::vector<std::string> row(const google::protobuf::Message& message) const;
  /// Values that have no column.
  std::uint64_t leftOut() const { return leftOut_; }

 private:
  /// Fields and elements on the way to a value, from the message inwards: sorts as the schema does.
  using Place = std::vector<int>;
  class Walk;

  std::shared_ptr<std::size_t> room_;
  std::map<Place, std::string> columns_;  // their names
  std::uint64_t leftOut_ = 0;
};

/// A row of a file of comma-separated values (RFC 4180), with its line end.
std::string csvLine(const std::vector<std::string>& cells);
/// "12.340000000".
std::string secondsText(std::int64_t seconds, std::int64_t nanos);

}  // namespace logplayer
