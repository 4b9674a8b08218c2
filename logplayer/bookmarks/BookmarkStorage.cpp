// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bookmarks/BookmarkStorage.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "foxglove/Event.pb.h"
#include "logplayer/file/LogImport.h"
#include "robotlink/base/bytes/Fnv.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Schema.h"
#include "robotlink/session/VersionedFile.h"

namespace logplayer {
namespace {

using nlohmann::json;
using robotlink::Instant;
using robotlink::Result;

// The largest integer that is exact in JSON.
constexpr std::int64_t kMaxId = (std::int64_t{1} << 53U) - 1;
const robotlink::VersionedFormat kFormat{"robotcontrol-bookmarks", 1, "bookmarks"};

const std::string* metadata(const foxglove::Event& event, std::string_view key) {
  for (const auto& pair : event.metadata()) {
    if (pair.key() == key) return &pair.value();
  }
  return nullptr;
}

void addMetadata(foxglove::Event& event, const char* key, const std::string& value) {
  auto* pair = event.add_metadata();
  pair->set_key(key);
  pair->set_value(value);
}

std::uint64_t hashOf(mcap::Bytes data) {
  const std::string_view bytes(reinterpret_cast<const char*>(data.data()), data.size());
  return robotlink::fnv1a(bytes) & static_cast<std::uint64_t>(kMaxId);
}

std::uint64_t eventIdOf(const foxglove::Event& event, mcap::Bytes data) {
  const std::string* text = metadata(event, "id");
  std::uint64_t id = 0;
  if (!text || std::from_chars(text->data(), text->data() + text->size(), id).ec != std::errc())
    return hashOf(data);
  return id;
}

// A text for an event of another program that has none.
std::string eventTextOf(const foxglove::Event& event) {
  if (const std::string* text = metadata(event, "text")) return *text;
  std::string all;
  for (const auto& pair : event.metadata()) {
    all += (all.empty() ? "" : ", ") + pair.key() + ": " + pair.value();
  }
  return all;
}

void readEvent(mcap::Bytes data, BookmarkChanges& changes) {
  foxglove::Event event;
  if (!event.ParseFromArray(data.data(), static_cast<int>(data.size()))) return;
  const std::uint64_t id = eventIdOf(event, data);
  if (metadata(event, "removed")) {
    changes[id] = std::nullopt;
    return;
  }
  const Instant from = robotlink::instant(event.start_time());
  const Instant to = event.has_end_time() ? robotlink::instant(event.end_time()) : from;
  changes[id] = Bookmark{id, from, std::max(from, to), eventTextOf(event)};
}

foxglove::Event eventOf(std::uint64_t id, const std::optional<Bookmark>& bookmark) {
  foxglove::Event event;
  addMetadata(event, "id", std::to_string(id));
  if (!bookmark) {
    addMetadata(event, "removed", "true");
    return event;
  }
  assign(*event.mutable_start_time(), bookmark->from);
  assign(*event.mutable_end_time(), bookmark->to);
  addMetadata(event, "text", bookmark->text);
  return event;
}

bool isBookmarks(const mcap::Reader& log, const mcap::Channel& channel) {
  const auto schema = log.schemas().find(channel.schemaId);
  return channel.topic == robotlink::streams::kBookmarks && channel.messageEncoding == "protobuf" &&
         schema != log.schemas().end() && schema->second.name == foxglove::Event::descriptor()->full_name();
}

json jsonOf(std::uint64_t id, const std::optional<Bookmark>& bookmark) {
  if (!bookmark) return {{"id", id}, {"removed", true}};
  return {{"id", id},
          {"from_ns", bookmark->from.time_since_epoch().count()},
          {"to_ns", bookmark->to.time_since_epoch().count()},
          {"text", bookmark->text}};
}

// An integer within the bounds; empty for anything else, such as a fraction.
std::optional<std::int64_t> wholeNumber(const json& entry, const char* name, std::int64_t min,
                                        std::int64_t max) {
  const auto found = entry.find(name);
  if (found == entry.end() || !found->is_number_integer()) return std::nullopt;
  if (found->is_number_unsigned() && found->get<std::uint64_t>() > static_cast<std::uint64_t>(max))
    return std::nullopt;
  const auto number = found->get<std::int64_t>();
  return number < min || number > max ? std::nullopt : std::optional(number);
}

// Adds an entry to the changes. Returns what is wrong with it, or null.
const char* readEntry(const json& entry, BookmarkChanges& changes) {
  // The difference of two times must fit, too.
  constexpr std::int64_t kLatest = std::numeric_limits<std::int64_t>::max() / 2;
  if (!entry.is_object()) return "it is not an object in braces";
  const auto id = wholeNumber(entry, "id", 0, kMaxId);
  if (!id) return "its \"id\" is missing, or not a whole number from 0 to 2^53 - 1";
  const auto number = static_cast<std::uint64_t>(*id);
  const auto removed = entry.find("removed");
  if (removed != entry.end() && !removed->is_boolean()) return "\"removed\" is neither true nor false";
  if (removed != entry.end() && removed->get<bool>()) {
    changes.emplace(number, std::nullopt);
    return nullptr;
  }
  const auto from = wholeNumber(entry, "from_ns", -kLatest, kLatest),
             to = wholeNumber(entry, "to_ns", -kLatest, kLatest);
  if (!from || !to) return "\"from_ns\" or \"to_ns\" is missing, or not a whole number of nanoseconds";
  const auto text = entry.find("text");
  if (text == entry.end() || !text->is_string()) return "its \"text\" is missing, or not in quotes";
  const Instant begin{robotlink::Duration(*from)}, end{robotlink::Duration(*to)};
  changes.emplace(number, Bookmark{number, begin, std::max(begin, end), text->get<std::string>()});
  return nullptr;
}

bool earlier(const Bookmark& a, const Bookmark& b) {
  return std::tie(a.from, a.to, a.id) < std::tie(b.from, b.to, b.id);
}

}  // namespace

BookmarkChanges readBookmarks(mcap::Reader& log) {
  std::vector<std::uint16_t> channels;
  for (const auto& [id, channel] : log.channels()) {
    if (isBookmarks(log, channel)) channels.push_back(id);
  }
  std::vector<mcap::MessagePosition> positions;
  mcap::MessagePosition before{Instant::min()};
  while (const auto position = channels.empty() ? std::nullopt : log.next(before, channels)) {
    positions.push_back(*position);
    before = *position;
  }
  // Sorted by the order of the file, since the last message counts and a bookmark may have been moved to an
  // earlier time.
  std::sort(positions.begin(), positions.end(), [](const auto& a, const auto& b) {
    return std::tie(a.chunkOffset, a.offset) < std::tie(b.chunkOffset, b.offset);
  });
  BookmarkChanges changes;
  for (const auto& position : positions) {
    if (const auto data = log.read(position)) readEvent(data->message.data, changes);
  }
  return changes;
}

Result<void> writeBookmarks(mcap::Writer& log, const BookmarkChanges& changes) {
  if (changes.empty()) return {};
  const auto* type = foxglove::Event::descriptor();
  const auto schema = log.addSchema(type->full_name(), "protobuf", robotlink::schemaOf(*type));
  if (!schema) return tl::unexpected(schema.error());
  const auto channel = log.addChannel(robotlink::streams::kBookmarks, *schema, "protobuf", {});
  if (!channel) return tl::unexpected(channel.error());
  // A removal is written at the log's end, which it does not change.
  const Instant end = log.statistics().messageEnd;
  for (const auto& [id, bookmark] : changes) {
    const std::string data = eventOf(id, bookmark).SerializeAsString();
    const Instant time = bookmark ? bookmark->from : end;
    const mcap::Bytes bytes(reinterpret_cast<const std::uint8_t*>(data.data()), data.size());
    if (const auto written = log.write({*channel, 0, time, time, bytes}); !written) return written;
  }
  return {};
}

std::filesystem::path fileBeside(const std::filesystem::path& log) {
  std::filesystem::path file = log;
  file += ".bookmarks.json";
  return file;
}

Result<BookmarkChanges> readBookmarksBeside(const std::filesystem::path& log) {
  const std::filesystem::path file = fileBeside(log);
  const auto contents = robotlink::readVersioned(file, kFormat);
  if (!contents) return tl::unexpected(contents.error());
  const robotlink::FilePosition where{file.string(), 0, 0};
  BookmarkChanges changes;
  const auto entries = contents->find("entries");
  if (entries == contents->end()) return changes;
  if (!entries->is_array())
    return robotlink::failure("bookmarks.format", "the \"entries\" are not a list in brackets", where);
  for (std::size_t i = 0; i < entries->size(); ++i) {
    if (const char* problem = readEntry((*entries)[i], changes))
      return robotlink::failure("bookmarks.format",
                                "bookmark " + std::to_string(i + 1) + " cannot be read: " + problem, where);
  }
  return changes;
}

Result<void> writeBookmarksBeside(const std::filesystem::path& log, const BookmarkChanges& changes) {
  const std::filesystem::path file = fileBeside(log);
  if (changes.empty()) {
    std::error_code error;
    std::filesystem::remove(file, error);
    if (!error) return {};
    return robotlink::failure("file.io", "cannot remove it: " + error.message(), {file.string(), 0, 0},
                              {error.message()});
  }
  json entries = json::array();
  for (const auto& [id, bookmark] : changes) entries.push_back(jsonOf(id, bookmark));
  return robotlink::writeVersioned(file, kFormat, {{"entries", std::move(entries)}});
}

std::vector<Bookmark> StoredBookmarks::bookmarks() const {
  return changed(changed({}, inLog), beside);
}

Result<StoredBookmarks> readStoredBookmarks(const std::filesystem::path& log,
                                            const std::function<bool(double)>& progress) {
  if (canImport(log)) return storedBookmarksOf(log, nullptr);
  mcap::Reader::Options options;
  options.progress = progress;
  const auto reader = mcap::Reader::open(log, options);
  if (!reader) return tl::unexpected(reader.error());
  return storedBookmarksOf(log, reader->get());
}

Result<StoredBookmarks> storedBookmarksOf(const std::filesystem::path& log, mcap::Reader* open) {
  StoredBookmarks stored;
  if (open != nullptr) {
    stored.inLog = readBookmarks(*open);
    stored.canAppend = open->complete() && ::access(log.c_str(), W_OK) == 0;
  }
  auto beside = readBookmarksBeside(log);
  if (beside) {
    stored.beside = std::move(*beside);
  } else {
    stored.problem = beside.error();
  }
  return stored;
}

BookmarkChanges difference(const std::vector<Bookmark>& from, const std::vector<Bookmark>& to) {
  BookmarkChanges changes;
  for (const Bookmark& bookmark : from) changes[bookmark.id] = std::nullopt;
  for (const Bookmark& bookmark : to) changes[bookmark.id] = bookmark;
  for (const Bookmark& bookmark : from) {
    if (changes[bookmark.id] == bookmark) changes.erase(bookmark.id);
  }
  return changes;
}

std::vector<Bookmark> changed(const std::vector<Bookmark>& bookmarks, const BookmarkChanges& changes) {
  std::vector<Bookmark> result;
  for (const Bookmark& bookmark : bookmarks) {
    if (!changes.contains(bookmark.id)) result.push_back(bookmark);
  }
  for (const auto& [id, bookmark] : changes) {
    if (bookmark) result.push_back(*bookmark);
  }
  std::sort(result.begin(), result.end(), earlier);
  return result;
}

}  // namespace logplayer
