// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/SectionCache.h"

#include <algorithm>

namespace logplayer::mcap {

namespace {

constexpr int kKeptOnRegret = 64;
/// Larger sections are not read ahead, since each needs its size in memory a second time.
constexpr std::size_t kMaxBytesAhead = 16U << 20U;

}  // namespace

SectionCache::SectionCache(const Source& source, FileIndex& index, const ReadOptions& options)
    : source_(source),
      index_(index),
      maxRecordBytes_(options.maxRecordBytes),
      loader_(source, options.maxRecordBytes),
      ahead_(source, options.maxRecordBytes, std::min(kMaxBytesAhead, options.cacheBytes / 2)),
      records_(options.cacheBytes),
      lists_(options.cacheBytes / 4),
      noted_(index.sections.size()) {
  left_.fill(SIZE_MAX);
}

void SectionCache::leave(std::size_t section) {
  if (keep_ > 0) {
    --keep_;
    return;
  }
  records_.retire(section);
  left_[nextLeft_++ % left_.size()] = section;
}

void SectionCache::expect(std::size_t section, std::shared_ptr<const ChannelSet> listed) {
  if (section < index_.sections.size() && !records_.contains(section))
    ahead_.begin(section, index_.sections[section], std::move(listed));
}

tl::expected<SectionCache::Records, std::string> SectionCache::records(std::size_t section,
                                                                       Listing* listing) {
  if (const auto* kept = records_.find(section)) return *kept;
  if (std::ranges::find(left_, section) != left_.end()) {
    keep_ = kKeptOnRegret;
    left_.fill(SIZE_MAX);
  }
  const std::size_t bytes = index_.sections[section].info.uncompressedBytes;
  std::shared_ptr<Buffer> buffer = records_.release(bytes);
  if (buffer == nullptr || buffer.use_count() > 1) buffer = std::make_shared<Buffer>();
  if (const auto read = readInto(section, *buffer, listing); !read) return tl::unexpected(read.error());
  records_.insert(section, buffer, buffer->capacity());
  return buffer;
}

tl::expected<void, std::string> SectionCache::readInto(std::size_t section, Buffer& buffer,
                                                       Listing* listing) {
  auto ahead = ahead_.take(section, buffer, listing);
  auto loaded = ahead ? std::move(*ahead) : loader_.load(index_.sections[section], buffer);
  if (!loaded) {
    const Section& damaged = index_.sections[section];
    noteDamage(section, {damaged.info.offset, damaged.info.length, loaded.error(), damaged.loose ? 0U : 1U});
  }
  return loaded;
}

void SectionCache::noteDamage(std::size_t section, const Damage& found) {
  if (noted_[section]) return;
  noted_[section] = true;
  const bool known = std::ranges::any_of(index_.damage, [&](const Damage& damage) {
    return damage.offset == found.offset && damage.what == found.what;
  });
  if (!known) index_.damage.push_back(found);
  doubt(index_.sections[section]);
}

std::vector<MessageRecord> SectionCache::messagesOfBroken(std::size_t section, Bytes records) {
  noteDamage(section, {index_.sections[section].info.offset, 0, "the records of a chunk do not fill it"});
  if (index_.sections[section].indexed) {
    if (auto indexed = indexedMessages(index_.sections[section], records)) return std::move(*indexed);
    distrustIndexes(section);
  }
  std::vector<MessageRecord> found;
  visitMessages(records, ChannelSet().set(), [&](const MessageRecord& message) {
    found.push_back(message);
    return true;
  });
  return found;
}

std::optional<std::vector<MessageRecord>> SectionCache::indexedMessages(const Section& section,
                                                                        Bytes records) const {
  const std::optional<MessageList> list = listByIndexes(section);
  if (!list) return std::nullopt;
  std::vector<MessageRecord> found;
  for (const MessageList::Channel& channel : list->channels()) {
    for (const MessageList::Entry& entry : list->of(channel.id)) {
      const auto message = messageAt(records, entry.offset, channel.id, entry.time);
      if (!message) return std::nullopt;
      found.push_back(*message);
    }
  }
  std::ranges::sort(found, {}, &MessageRecord::offset);
  return found;
}

void SectionCache::doubt(const Section& section) {
  if (!index_.bySummary || misfit_) return;
  misfit_ = !chunkIsThere(source_, section, maxRecordBytes_);
}

void SectionCache::doubtAll() {
  for (const Section& section : index_.sections) doubt(section);
}

void SectionCache::reset() {
  records_.clear();
  lists_.clear();
  ahead_.forget();
  noted_.assign(index_.sections.size(), false);
  misfit_ = false;
  ++surprises_;
}

std::shared_ptr<const MessageList> SectionCache::messages(std::size_t section) {
  if (const auto* kept = lists_.find(section)) return *kept;
  std::optional<MessageList> list;
  if (index_.sections[section].indexed) {
    list = listByIndexes(index_.sections[section]);
    if (!list) distrustIndexes(section);
  }
  if (!list) {
    const auto read = records(section);
    list = read ? MessageList::fromRecords(**read) : MessageList();
    // Without message indexes, everything behind the place where the records break off is lost.
    if (read && !visitRecords(**read, [](const RecordView&, std::size_t) {}))
      messagesOfBroken(section, **read);
    const auto ends = std::ranges::minmax_element(list->entries(), {}, &MessageList::Entry::time);
    if (ends.min != list->entries().end()) correctTimes(section, ends.min->time, ends.max->time);
  }
  auto shared = std::make_shared<const MessageList>(std::move(*list));
  lists_.insert(section, shared, shared->bytes());
  return shared;
}

/// Corrects the times in a chunk's head, which no checksum protects.
void SectionCache::correctTimes(std::size_t section, Instant first, Instant last) {
  ChunkInfo& info = index_.sections[section].info;
  if (info.start <= first && last <= info.end) return;
  info.start = std::min(info.start, first);
  info.end = std::max(info.end, last);
  ++surprises_;
}

std::optional<MessageList> SectionCache::listByIndexes(const Section& section) const {
  if (section.indexLength > maxRecordBytes_) return std::nullopt;
  const Buffer indexes = source_.read(section.indexOffset, section.indexLength);
  if (indexes.size() != section.indexLength) return std::nullopt;
  return MessageList::fromIndexes(indexes, section);
}

void SectionCache::compareIndexes(std::size_t section, const MessageList& found) {
  if (!index_.sections[section].indexed) return;
  const std::optional<MessageList> stated = listByIndexes(index_.sections[section]);
  if (!stated || !(*stated == found)) distrustIndexes(section);
}

void SectionCache::distrustIndexes(std::size_t section) {
  Section& damaged = index_.sections[section];
  if (!damaged.indexed) return;
  damaged.indexed = false;
  ++surprises_;
  lists_.erase(section);
  index_.damage.push_back({damaged.indexOffset, 0,
                           "the message indexes of a chunk are wrong; its messages are found by reading it"});
  doubt(damaged);
}

}  // namespace logplayer::mcap
