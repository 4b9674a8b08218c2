// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/read/Scan.h"
#include "logplayer/mcap/read/SectionCache.h"
#include "tests/logplayer/mcap/TemporaryLog.h"

namespace logplayer::mcap::test {

/// The records of these messages.
inline Buffer recordsOf(const std::vector<Expected>& messages) {
  Buffer records;
  for (const Expected& message : messages) {
    encode(records, Message{message.channelId, message.sequence, at(message.time), at(message.time + 1),
                            bytesOf(message.data)});
  }
  return records;
}

/// A file that is put together record by record, so that any of them can be wrong. It begins with the magic
/// and a header.
class BuiltFile {
 public:
  BuiltFile() : bytes(std::begin(kMagic), std::end(kMagic)) { add(Header{"p", "test"}); }

  std::uint64_t size() const { return bytes.size(); }
  /// Returns where it begins.
  template <typename Record>
  std::uint64_t add(const Record& record) {
    const std::uint64_t start = size();
    encode(bytes, record);
    return start;
  }
  void addChannels(std::uint16_t count) {
    for (std::uint16_t id = 1; id <= count; ++id) add(Channel{id, 0, "c" + std::to_string(id), "", {}});
  }
  std::uint64_t addBytes(std::size_t count, std::uint8_t value) {
    bytes.insert(bytes.end(), count, value);
    return size() - count;
  }
  /// A chunk that is not compressed and has no CRC; its head has the times of the messages.
  std::uint64_t addChunk(const std::vector<Expected>& messages) {
    const auto [first, last] = std::ranges::minmax(messages, {}, &Expected::time);
    return addChunk(recordsOf(messages), first.time, last.time);
  }
  std::uint64_t addChunk(const Buffer& records, std::int64_t first, std::int64_t last) {
    const std::uint64_t start = add(ChunkHead{at(first), at(last), records.size(), 0, "", records.size()});
    bytes.insert(bytes.end(), records.begin(), records.end());
    return start;
  }
  /// A chunk with its message indexes.
  std::uint64_t addIndexed(const std::vector<Expected>& messages) {
    const std::uint64_t start = addChunk(messages);
    std::map<std::uint16_t, MessageIndex> indexes;
    std::uint64_t offset = 0;
    for (const Expected& message : messages) {
      indexes[message.channelId].entries.push_back({static_cast<std::uint64_t>(message.time), offset});
      offset += kMessageHeadBytes + message.data.size();
    }
    for (auto& [channel, index] : indexes) {
      index.channelId = channel;
      add(index);
    }
    return start;
  }
  /// What follows the data, without a summary.
  void end() {
    add(DataEnd{});
    add(Footer{});
    bytes.insert(bytes.end(), std::begin(kMagic), std::end(kMagic));
  }
  Source source() const { return written(bytes); }
  /// The same, ended as by end().
  Source closed() const {
    BuiltFile whole;
    whole.bytes = bytes;
    whole.end();
    return written(whole.bytes);
  }

  Buffer bytes;

 private:
  Source written(const Buffer& all) const {
    writeBytes(*folder_ / "built.mcap", std::string(textOf(all)));
    return std::move(*Source::open(*folder_ / "built.mcap"));
  }

  std::unique_ptr<TemporaryFolder> folder_ = std::make_unique<TemporaryFolder>();
};

/// A built file that was closed, with what its messages are read by.
struct ScannedFile {
  explicit ScannedFile(const BuiltFile& file, const ReadOptions& options = {})
      : source(file.closed()), index(indexByScan(source, options)), cache(source, index, options) {}

  std::vector<std::string> damage() const {
    std::vector<std::string> texts;
    for (const Damage& damage : index.damage) texts.push_back(damage.what);
    return texts;
  }

  Source source;
  FileIndex index;
  SectionCache cache;
};

}  // namespace logplayer::mcap::test
