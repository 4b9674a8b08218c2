// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/FieldTable.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>

#include "logplayer/export/ExportPass.h"
#include "logplayer/export/MessageTable.h"
#include "logplayer/file/LogFile.h"
#include "logplayer/search/MessageSource.h"
#include "robotlink/expressions/FieldPath.h"

namespace widgets {
namespace {

constexpr std::size_t kBetweenReports = 1000;  // messages

std::string cellText(const robotlink::FieldValue& value) {
  if (value.text) return *value.text;
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value.number.value_or(0)).ptr};
}

/// Collects the values of a table, in any order.
class TableRows {
 public:
  explicit TableRows(const std::vector<FieldColumn>& columns) : columns_(columns) {
    for (const FieldColumn& column : columns) paths_.push_back(robotlink::FieldPath::parse(column.field));
  }

  void add(std::size_t column, robotlink::Instant time, const google::protobuf::Message& message) {
    const auto& path = paths_[column];
    const auto value = path ? path->valueIn(message) : std::nullopt;
    auto& cells = rows_[time];
    cells.resize(columns_.size());
    if (value) cells[column] = cellText(*value);
    if (rows_.size() <= FieldTable::kMaxRows) return;
    rows_.erase(rows_.begin());
    isCut_ = true;
  }

  FieldTable table() {
    FieldTable table{columns_, {}, isCut_};
    table.rows.reserve(rows_.size());
    for (auto& [time, cells] : rows_) table.rows.push_back({time, std::move(cells)});
    return table;
  }

 private:
  const std::vector<FieldColumn>& columns_;
  std::vector<robotlink::Result<robotlink::FieldPath>> paths_;
  std::map<robotlink::Instant, std::vector<std::string>> rows_;
  bool isCut_ = false;
};

robotlink::Error givenUp() {
  return {"log.given-up", "the table was canceled", {}, {}};
}

/// Adds what the history has on disk before the messages in memory.
robotlink::Result<void> addPieces(const FieldTableSource& source, TableRows& rows,
                                  const std::function<bool(double)>& goesOn) {
  std::set<std::string> streams;
  for (const FieldColumn& column : source.columns) streams.insert(column.stream);
  const auto history = logplayer::historySource(source.pieces);
  const auto [from, to] = history->stretch();
  const double length = robotlink::seconds(to - from + robotlink::Duration(1));
  const auto cursor = history->read({streams.begin(), streams.end()}, robotlink::Instant::min());
  std::size_t done = 0;
  while (const auto message = cursor->next()) {
    const double share = std::clamp(robotlink::seconds(message->time - from) / length, 0.0, 1.0);
    if (++done % kBetweenReports == 0 && !goesOn(share)) return tl::unexpected(givenUp());
    for (std::size_t column = 0; column < source.columns.size(); ++column) {
      const auto& later = source.messages[column];
      if (source.columns[column].stream != message->path) continue;
      if (later.empty() || message->time < later.front().time)
        rows.add(column, message->time, *message->value);
    }
  }
  return {};
}

robotlink::Result<FieldTable> tableOfHistory(const FieldTableSource& source,
                                             const std::function<bool(double)>& goesOn) {
  TableRows rows(source.columns);
  // Reading what is on disk takes nearly all of the time, if there is something.
  const double onDisk = source.pieces.empty() || source.columns.empty() ? 0 : 0.9;
  if (onDisk > 0) {
    const auto added = addPieces(source, rows, [&](double share) { return goesOn(onDisk * share); });
    if (!added) return tl::unexpected(added.error());
  }
  std::size_t all = 0, done = 0;
  for (const auto& messages : source.messages) all += messages.size();
  for (std::size_t column = 0; column < source.messages.size(); ++column) {
    for (const auto& message : source.messages[column]) {
      const double share = static_cast<double>(++done) / static_cast<double>(all);
      if (done % kBetweenReports == 0 && !goesOn(onDisk + (1 - onDisk) * share))
        return tl::unexpected(givenUp());
      rows.add(column, message.time, *message.value);
    }
  }
  return rows.table();
}

robotlink::Result<FieldTable> tableOfLog(const FieldTableSource& source,
                                         const std::function<bool(double)>& goesOn) {
  logplayer::LogFile::Options opening;
  opening.progress = [&goesOn](double) { return goesOn(0); };
  const auto log = logplayer::LogFile::open(source.log, opening);
  if (!log) return tl::unexpected(log.error());
  logplayer::ExportOptions options;
  options.progress = goesOn;
  const std::set<std::string> streams(source.logStreams.begin(), source.logStreams.end());
  TableRows rows(source.columns);
  const auto read =
      logplayer::forEachMessage(*log, {streams.begin(), streams.end()}, options, {},
                                [&](const robotlink::StreamMessage& message) -> robotlink::Result<void> {
                                  for (std::size_t column = 0; column < source.columns.size(); ++column) {
                                    if (source.logStreams[column] == message.path)
                                      rows.add(column, message.time + source.offset, *message.value);
                                  }
                                  return {};
                                });
  if (!read) return tl::unexpected(read.error());
  return rows.table();
}

}  // namespace

std::string FieldTable::csv(robotlink::Instant origin) const {
  std::vector<std::string> line{"time_s"};
  for (const FieldColumn& column : columns) line.push_back(column.stream + '.' + column.field);
  std::string text = logplayer::csvLine(line);
  for (const Row& row : rows) {
    const auto time = (row.time - origin).count();
    constexpr std::int64_t kSecond = 1'000'000'000;
    line = {logplayer::secondsText(time / kSecond, time % kSecond)};
    line.insert(line.end(), row.cells.begin(), row.cells.end());
    text += logplayer::csvLine(line);
  }
  return text;
}

FieldTableSource historyOf(const robotlink::StreamStore& store, const robotlink::HistoryArchive* archive,
                           std::vector<FieldColumn> columns) {
  FieldTableSource source;
  source.columns = std::move(columns);
  if (archive != nullptr) source.pieces = archive->pieces();
  for (const FieldColumn& column : source.columns) {
    auto& messages = source.messages.emplace_back();
    const auto* stream = store.find(column.stream);
    if (stream == nullptr) continue;
    // Messages that are only looked back at are in the archive, too, with those between them and the others.
    const std::size_t first = source.pieces.empty() ? 0 : stream->lookedAt;
    for (std::size_t i = first; i < stream->messages.size(); ++i)
      messages.push_back({stream->messages[i].time, stream->messages[i].value});
  }
  return source;
}

robotlink::Result<FieldTable> makeTable(const FieldTableSource& source,
                                        const std::function<bool(double)>& goesOn) {
  return source.log.empty() ? tableOfHistory(source, goesOn) : tableOfLog(source, goesOn);
}

}  // namespace widgets
