// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/link/StreamList.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/core/platform/JsonOutput.h"
#include "robotlink/base/Printable.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/foxglove/session/LinkNames.h"

namespace app {
namespace {

std::string bytesRateText(double bytes) {
  if (bytes >= 1e6) return fmt::format("{:.2f} MB/s", bytes / 1e6);
  if (bytes >= 1e3) return fmt::format("{:.1f} kB/s", bytes / 1e3);
  return fmt::format("{:.0f} B/s", bytes);
}

std::string noteOn(const StreamList::Stream& stream) {
  std::string note;
  if (!stream.isDecoded) note = stream.encoding + ", not decoded";
  // The same images are offered three times.
  if (stream.topic.ends_with(robotlink::websocket::kJpegChannel)) note = "as JPEG";
  if (stream.topic.ends_with(robotlink::websocket::kPngChannel)) note = "as PNG";
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) note += fmt::format("{}{} {}", note.empty() ? "" : ", ", count, what);
  };
  add(stream.thinned.value_or(0), "thinned");
  add(stream.dropped.value_or(0), "dropped");
  return note;
}

}  // namespace

void StreamList::update(std::vector<Stream> streams, double seconds) {
  rows_.clear();
  for (Stream& stream : streams) {
    Count& before = counts_[stream.topic];
    Row row{std::move(stream), before};
    // A new connection counts from 0.
    const bool isNew = row.stream.messages < before.messages;
    const double time = std::max(seconds - before.seconds, 1e-3);
    row.rate = isNew ? 0 : static_cast<double>(row.stream.messages - before.messages) / time;
    row.bytesPerSecond = isNew ? 0 : static_cast<double>(row.stream.bytes - before.bytes) / time;
    before = {seconds, row.stream.messages, row.stream.bytes};
    rows_.push_back(std::move(row));
  }
}

bool StreamList::has(const std::string& path) const {
  return std::ranges::any_of(rows_, [&](const Row& row) { return row.stream.path == path; });
}

std::string StreamList::near(const std::string& path) const {
  std::vector<std::string> paths;
  for (const Row& row : rows_) paths.push_back(row.stream.path);
  return robotlink::nearest(path, paths);
}

std::string StreamList::text() const {
  std::size_t pathWidth = 6, typeWidth = 4;
  for (const Row& row : rows_) {
    pathWidth = std::max(pathWidth, row.stream.path.size());
    typeWidth = std::max(typeWidth, row.stream.type.size());
  }
  std::string text = fmt::format("  {:<{}}  {:<{}}  {:>9}  {:>11}\n", "stream", pathWidth, "type", typeWidth,
                                 "rate", "bytes");
  for (const Row& row : rows_) {
    const bool isOn = row.stream.isSubscribed;
    std::string line =
        fmt::format("  {:<{}}  {:<{}}  {:>9}  {:>11}  {}", row.stream.path, pathWidth, row.stream.type,
                    typeWidth, isOn ? fmt::format("{:.1f} Hz", row.rate) : "-",
                    isOn ? bytesRateText(row.bytesPerSecond) : "-", noteOn(row.stream));
    line.erase(line.find_last_not_of(' ') + 1);
    text += robotlink::printable(line) + "\n";
  }
  return text;
}

std::string StreamList::json(const std::string& url, const std::vector<std::string>& robots,
                             const std::string& state) const {
  nlohmann::json streams = nlohmann::json::array();
  for (const Row& row : rows_) {
    nlohmann::json stream{{"path", row.stream.path},
                          {"topic", row.stream.topic},
                          {"type", row.stream.type},
                          {"encoding", row.stream.encoding},
                          {"subscribed", row.stream.isSubscribed},
                          {"decoded", row.stream.isDecoded},
                          {"messages", row.stream.messages},
                          {"bytes", row.stream.bytes},
                          {"rate", row.rate},
                          {"bytes_per_second", row.bytesPerSecond}};
    if (row.stream.thinned) stream["thinned"] = *row.stream.thinned;
    if (row.stream.dropped) stream["dropped"] = *row.stream.dropped;
    streams.push_back(std::move(stream));
  }
  return jsonOutput(nlohmann::json{{"url", url}, {"robots", robots}, {"state", state}, {"streams", streams}});
}

}  // namespace app
