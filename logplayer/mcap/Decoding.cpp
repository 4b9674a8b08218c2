// SPDX-License-Identifier: GPL-3.0-or-later
// The decode functions of Codec.h: MCAP records from bytes.
#include "logplayer/mcap/Codec.h"
#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/RecordFields.h"

namespace logplayer::mcap {
namespace {

Instant takeInstant(ByteReader& fields) {
  return instantOf(fields.take<std::uint64_t>());
}

// These return false if a field that consists of several is not whole; that the bytes suffice is checked at
// the end.

template <std::unsigned_integral Number>
bool take(ByteReader& fields, Number& number) {
  number = fields.take<Number>();
  return true;
}

bool take(ByteReader& fields, Instant& instant) {
  instant = takeInstant(fields);
  return true;
}

bool take(ByteReader& fields, Opcode& opcode) {
  opcode = static_cast<Opcode>(fields.take<std::uint8_t>());
  return true;
}

bool take(ByteReader& fields, std::string& text) {
  text = fields.takeText();
  return true;
}

/// The first of equal keys counts.
bool take(ByteReader& fields, std::map<std::string, std::string>& map) {
  ByteReader entries(fields.take(fields.take<std::uint32_t>()));
  while (entries.good() && !entries.rest().empty()) {
    const std::string_view key = entries.takeText();
    const std::string_view value = entries.takeText();
    if (entries.good()) map.emplace(key, value);
  }
  return entries.good();
}

/// Pairs of a channel and a number.
template <typename Add>
bool takeNumbers(ByteReader& fields, Add add) {
  ByteReader entries(fields.take(fields.take<std::uint32_t>()));
  while (entries.good() && !entries.rest().empty()) {
    const auto key = entries.take<std::uint16_t>();
    const auto value = entries.take<std::uint64_t>();
    if (entries.good()) add(key, value);
  }
  return entries.good();
}

bool take(ByteReader& fields, std::vector<std::pair<std::uint16_t, std::uint64_t>>& offsets) {
  return takeNumbers(fields,
                     [&](std::uint16_t key, std::uint64_t value) { offsets.emplace_back(key, value); });
}

bool take(ByteReader& fields, std::map<std::uint16_t, std::uint64_t>& counts) {
  return takeNumbers(fields, [&](std::uint16_t key, std::uint64_t value) { counts[key] = value; });
}

}  // namespace

std::optional<RecordView> firstRecord(Bytes bytes) {
  ByteReader reader(bytes);
  RecordView record;
  record.opcode = reader.take<std::uint8_t>();
  record.content = reader.take(reader.take<std::uint64_t>());
  if (!reader.good() || record.opcode == 0) return std::nullopt;
  return record;
}

template <typename Record>
std::optional<Record> decode(Bytes content) {
  ByteReader fields(content);
  Record record;
  const bool whole =
      std::apply([&](auto&... field) { return (take(fields, field) && ...); }, fieldsOf(record));
  if (!whole || !fields.good()) return std::nullopt;
  if constexpr (std::same_as<Record, Schema>) {
    if (record.id == 0) return std::nullopt;
  }
  return record;
}
template std::optional<Header> decode(Bytes content);
template std::optional<Footer> decode(Bytes content);
template std::optional<Schema> decode(Bytes content);
template std::optional<Channel> decode(Bytes content);
template std::optional<ChunkHead> decode(Bytes content);
template std::optional<ChunkIndex> decode(Bytes content);
template std::optional<AttachmentIndex> decode(Bytes content);
template std::optional<Statistics> decode(Bytes content);
template std::optional<Metadata> decode(Bytes content);
template std::optional<MetadataIndex> decode(Bytes content);
template std::optional<SummaryOffset> decode(Bytes content);
template std::optional<DataEnd> decode(Bytes content);

std::optional<Message> decodeMessage(Bytes content) {
  constexpr std::size_t kHead = kMessageHeadBytes - kRecordHeadBytes;
  if (content.size() < kHead) return std::nullopt;
  Message message;
  message.channelId = loadNumber<std::uint16_t>(content.data());
  message.sequence = loadNumber<std::uint32_t>(content.data() + 2);
  message.logTime = instantOf(loadNumber<std::uint64_t>(content.data() + 6));
  message.publishTime = instantOf(loadNumber<std::uint64_t>(content.data() + 14));
  message.data = content.subspan(kHead);
  return message;
}

std::optional<MessageIndex> decodeMessageIndex(Bytes content) {
  ByteReader fields(content);
  MessageIndex index;
  index.channelId = fields.take<std::uint16_t>();
  const Bytes entries = fields.take(fields.take<std::uint32_t>());
  if (!fields.good() || entries.size() % 16 != 0) return std::nullopt;
  index.entries.resize(entries.size() / 16);
  const std::uint8_t* from = entries.data();
  for (MessageIndexEntry& entry : index.entries) {
    entry.time = loadNumber<std::uint64_t>(from);
    entry.offset = loadNumber<std::uint64_t>(from + 8);
    from += 16;
  }
  return index;
}

std::optional<CheckedAttachment> decodeAttachment(Bytes content) {
  ByteReader fields(content);
  CheckedAttachment result;
  result.attachment.logTime = takeInstant(fields);
  result.attachment.createTime = takeInstant(fields);
  result.attachment.name = fields.takeText();
  result.attachment.mediaType = fields.takeText();
  result.attachment.data = textOf(fields.take(fields.take<std::uint64_t>()));
  const std::size_t checked = content.size() - fields.rest().size();
  const auto crc = fields.take<std::uint32_t>();
  if (!fields.good()) return std::nullopt;
  result.crcFits = crc == 0 || crc == crc32(content.first(checked));
  return result;
}

}  // namespace logplayer::mcap
