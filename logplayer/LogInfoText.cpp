// SPDX-License-Identifier: GPL-3.0-or-later
// LogInfo as text for the user, see toText().
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "logplayer/LogInfo.h"
#include "logplayer/base/LogDates.h"
#include "robotlink/base/TextParts.h"

namespace logplayer {
namespace {

using nlohmann::json;
using robotlink::Instant;

std::string bytesText(std::uint64_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " B";
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  constexpr std::array<const char*, 5> kUnits{"B", "kB", "MB", "GB", "TB"};
  while (value >= 999.5 && unit + 1 < kUnits.size()) {
    value /= 1000;
    ++unit;
  }
  return fmt::format("{:.{}f} {}", value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0, kUnits[unit]);
}

/// A number with separators: "12,345".
std::string countText(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, 1, ',');
  return digits;
}

std::string rateText(double rate) {
  if (rate <= 0) return "-";
  return fmt::format("{:.{}f} Hz", rate, rate < 9.995 ? 2 : 1);
}

/// The encoding of a stream's messages, if not all are Protobuf.
std::string encodingText(const LogInfo::Stream& stream) {
  if (stream.undecoded == 0) return stream.encoding;
  const std::string encoding = stream.encoding.empty() ? "unknown" : stream.encoding;
  if (stream.undecoded == stream.count) return encoding + ", not decoded";
  return encoding + ", " + countText(stream.undecoded) + " not decoded";
}

bool allProtobuf(const LogInfo& info) {
  return std::all_of(info.streams.begin(), info.streams.end(), [](const auto& stream) {
    return stream.encoding == "protobuf" && stream.undecoded == 0;
  });
}

/// The messages that stay bytes: "12 messages (cdr)"; empty if there are none.
std::string undecodedText(const LogInfo& info) {
  std::uint64_t count = 0;
  std::map<std::string, std::uint64_t> encodings;
  for (const auto& stream : info.streams) {
    if (stream.undecoded == 0) continue;
    count += stream.undecoded;
    ++encodings[stream.encoding.empty() ? "of unknown encoding" : stream.encoding];
  }
  std::vector<std::string> names;
  for (const auto& [name, streams] : encodings) names.push_back(name);
  return count == 0 ? ""
                    : countText(count) + (count == 1 ? " message (" : " messages (") +
                          robotlink::joined(names) + ")";
}

std::string percentText(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? "-"
                    : fmt::format("{:.1f} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

/// A text table whose columns are as wide as their widest cell. `columns` is their alignment: "lr" is left,
/// right.
class Table {
 public:
  explicit Table(std::string columns) : columns_(std::move(columns)) {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  std::string text() const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_) {
      widths.resize(std::max(widths.size(), row.size()));
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const auto& row : rows_) {
      std::string line = " ";
      for (std::size_t i = 0; i < row.size(); ++i) {
        const std::string gap(widths[i] - row[i].size(), ' ');
        line += " " + (columns_[i] == 'l' ? row[i] + gap : gap + row[i]) + " ";
      }
      text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
  }

 private:
  std::string columns_;
  std::vector<std::vector<std::string>> rows_;
};

std::vector<std::string> countTexts(const std::map<std::string, std::uint64_t>& counts) {
  std::vector<std::string> parts;
  parts.reserve(counts.size());
  for (const auto& [name, count] : counts) parts.push_back(countText(count) + " " + name);
  return parts;
}

/// Adds a named row, or several if the parts do not fit on one line.
void addParts(Table& table, std::string name, const std::vector<std::string>& parts) {
  constexpr std::size_t kWidth = 90;
  std::string line;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!line.empty() && line.size() + parts[i].size() > kWidth) {
      table.add({std::exchange(name, ""), std::exchange(line, "")});
    }
    if (!line.empty()) line += ' ';
    line += parts[i];
    if (i + 1 < parts.size()) line += ',';
  }
  if (!line.empty()) table.add({name, line});
}

std::vector<std::string> frameParts(const LogInfo& info) {
  std::map<std::string, std::uint64_t> steps, frames;
  for (const auto& [process, count] : info.framesOf)
    (process.ends_with("/platform") ? steps : frames)[process] = count;
  std::vector<std::string> parts = countTexts(frames);
  if (parts.size() > 1) parts.insert(parts.begin(), countText(info.frames) + " in all");
  for (const auto& [process, count] : steps) parts.push_back(countText(count) + " steps of " + process);
  return parts;
}

std::vector<std::string> valueParts(const mcap::Metadata& record) {
  std::vector<std::string> parts;
  parts.reserve(record.values.size());
  for (const auto& [key, value] : record.values) parts.push_back(key + " " + value);
  return parts;
}

/// Removes the prefix from the names of this program's own metadata records.
std::string recordName(const std::string& name) {
  constexpr std::string_view kOurs = "robotcontrol.";
  return name.starts_with(kOurs) ? name.substr(kOurs.size()) : name;
}

std::string compressionText(const LogInfo& info) {
  std::vector<std::string> names;
  for (const auto& [name, count] : info.compressions)
    names.push_back(name == "none" ? "not compressed" : name);
  std::string text =
      countText(info.chunks) + (info.chunks == 1 ? " chunk, " : " chunks, ") + robotlink::joined(names);
  if (info.compressedBytes != info.uncompressedBytes) {
    text += ": " + bytesText(info.compressedBytes) + " of " + bytesText(info.uncompressedBytes) + " (" +
            percentText(info.compressedBytes, info.uncompressedBytes) + ")";
  }
  return text;
}

std::string figures(const LogInfo& info) {
  Table table("ll");
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) table.add({name, value});
  };
  add("format", info.format + (info.library.empty() ? "" : ", written by " + info.library));
  add("size", bytesText(info.fileBytes));
  if (info.chunks > 0) add("chunks", compressionText(info));
  add("time", info.messages == 0
                  ? "no messages"
                  : dateOrSeconds(info.begin) + " to " + dateOrSeconds(info.end) + ", " +
                        fmt::format("{:.3f} s long", robotlink::seconds(info.end - info.begin)));
  addParts(table, "robots", info.robots);
  add("messages", countText(info.messages) + " in " + countText(info.streams.size()) + " streams");
  add("not decoded", undecodedText(info));
  addParts(table, "frames", frameParts(info));
  add("images", countText(info.images));
  addParts(table, "attachments", info.attachments);
  addParts(table, "not understood", countTexts(info.notUnderstood));
  for (const mcap::Metadata& record : info.metadata)
    addParts(table, recordName(record.name), valueParts(record));
  return table.text();
}

json bookmarkJson(const Bookmark& bookmark) {
  return {{"id", bookmark.id},
          {"from", robotlink::seconds(bookmark.from)},
          {"to", robotlink::seconds(bookmark.to)},
          {"text", bookmark.text}};
}

json streamJson(const LogInfo::Stream& stream) {
  return {{"path", stream.path},
          {"type", stream.type},
          {"encoding", stream.encoding},
          {"undecoded", stream.undecoded},
          {"count", stream.count},
          {"bytes", stream.bytes},
          {"rate_hz", stream.rate},
          {"begin", robotlink::seconds(stream.first)},
          {"end", robotlink::seconds(stream.last)}};
}

}  // namespace

json toJson(const LogInfo& info) {
  json result;
  result["file"] = info.file.string();
  result["format"] = info.format;
  result["file_bytes"] = info.fileBytes;
  result["complete"] = info.complete;
  result["begin"] = robotlink::seconds(info.begin);
  result["end"] = robotlink::seconds(info.end);
  if (isDate(info.begin)) {
    result["begin_date"] = dateText(info.begin);
    result["end_date"] = dateText(info.end);
  }
  result["duration_s"] = robotlink::seconds(info.end - info.begin);
  result["robots"] = info.robots;
  result["messages"] = info.messages;
  result["frames"] = info.frames;
  result["frames_of"] = info.framesOf;
  result["images"] = info.images;
  result["streams"] = json::array();
  for (const auto& stream : info.streams) result["streams"].push_back(streamJson(stream));
  result["bookmarks"] = json::array();
  for (const Bookmark& bookmark : info.bookmarks) result["bookmarks"].push_back(bookmarkJson(bookmark));
  result["chunks"] = info.chunks;
  result["compressions"] = info.compressions;
  result["compressed_bytes"] = info.compressedBytes;
  result["uncompressed_bytes"] = info.uncompressedBytes;
  result["library"] = info.library;
  result["attachments"] = info.attachments;
  result["metadata"] = json::array();
  for (const auto& record : info.metadata) {
    result["metadata"].push_back({{"name", record.name}, {"values", record.values}});
  }
  result["not_understood"] = info.notUnderstood;
  result["damage"] = json::array();
  for (const auto& damage : info.damage) {
    result["damage"].push_back({{"offset", damage.offset}, {"bytes", damage.bytes}, {"what", damage.what}});
  }
  result["losses"] = info.losses;
  return result;
}

std::string toText(const LogInfo& info) {
  std::string text = info.file.string() + "\n" + figures(info);
  if (!info.bookmarks.empty()) {
    Table bookmarks("rrl");
    bookmarks.add({"bookmark", "to", ""});
    for (const Bookmark& bookmark : info.bookmarks) {
      std::string name = bookmark.text;
      std::replace(name.begin(), name.end(), '\n', ' ');
      bookmarks.add({dateOrSeconds(bookmark.from),
                     bookmark.to == bookmark.from ? "" : dateOrSeconds(bookmark.to), name});
    }
    text += "\n" + bookmarks.text();
  }
  if (info.streams.empty()) return text;
  std::uint64_t allBytes = 0;
  for (const auto& stream : info.streams) allBytes += stream.bytes;
  const bool encodings = !allProtobuf(info);
  Table streams(encodings ? "lllrrrr" : "llrrrr");
  const auto addRow = [&](std::vector<std::string> row, const std::string& encoding) {
    if (encodings) row.insert(row.begin() + 2, encoding);
    streams.add(std::move(row));
  };
  addRow({"stream", "type", "messages", "rate", "size", "share"}, "encoding");
  for (const auto& stream : info.streams) {
    addRow({stream.path, stream.type, countText(stream.count), rateText(stream.rate), bytesText(stream.bytes),
            percentText(stream.bytes, allBytes)},
           encodingText(stream));
  }
  return text + "\n" + streams.text();
}

}  // namespace logplayer
