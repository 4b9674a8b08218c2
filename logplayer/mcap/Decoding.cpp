// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/Codec.h"
#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/RecordBytes.h"

namespace logplayer::mcap {
namespace {

Instant takeInstant(ByteReader& fields) {
  return instantOf(fields.take<std::uint64_t>());
}

/// Decodes a map; returns false if its bytes are not complete pairs. Of equal keys the first one counts.
bool takeMap(ByteReader& fields, std::map<std::string, std::string>& map) {
  ByteReader entries(fields.take(fields.take<std::uint32_t>()));
  while (entries.good() && !entries.rest().empty()) {
    const std::string_view key = entries.takeText();
    const std::string_view value = entries.takeText();
    if (entries.good()) map.emplace(key, value);
  }
  return entries.good();
}

template <typename Take>
bool takeNumbers(ByteReader& fields, Take take) {
  ByteReader entries(fields.take(fields.take<std::uint32_t>()));
  while (entries.good() && !entries.rest().empty()) {
    const auto key = entries.take<std::uint16_t>();
    const auto value = entries.take<std::uint64_t>();
    if (entries.good()) take(key, value);
  }
  return entries.good();
}

template <typename Record>
std::optional<Record> ifGood(const ByteReader& fields, Record record) {
  if (!fields.good()) return std::nullopt;
  return record;
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

std::optional<Header> decodeHeader(Bytes content) {
  ByteReader fields(content);
  Header header;
  header.profile = fields.takeText();
  header.library = fields.takeText();
  return ifGood(fields, std::move(header));
}

std::optional<Footer> decodeFooter(Bytes content) {
  ByteReader fields(content);
  Footer footer;
  footer.summaryStart = fields.take<std::uint64_t>();
  footer.summaryOffsetStart = fields.take<std::uint64_t>();
  footer.summaryCrc = fields.take<std::uint32_t>();
  return ifGood(fields, footer);
}

std::optional<Schema> decodeSchema(Bytes content) {
  ByteReader fields(content);
  Schema schema;
  schema.id = fields.take<std::uint16_t>();
  schema.name = fields.takeText();
  schema.encoding = fields.takeText();
  schema.data = fields.takeText();
  if (schema.id == 0) return std::nullopt;
  return ifGood(fields, std::move(schema));
}

std::optional<Channel> decodeChannel(Bytes content) {
  ByteReader fields(content);
  Channel channel;
  channel.id = fields.take<std::uint16_t>();
  channel.schemaId = fields.take<std::uint16_t>();
  channel.topic = fields.takeText();
  channel.messageEncoding = fields.takeText();
  if (!takeMap(fields, channel.metadata)) return std::nullopt;
  return ifGood(fields, std::move(channel));
}

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

std::optional<ChunkHead> decodeChunkHead(Bytes content) {
  ByteReader fields(content);
  ChunkHead head;
  head.start = takeInstant(fields);
  head.end = takeInstant(fields);
  head.uncompressedBytes = fields.take<std::uint64_t>();
  head.uncompressedCrc = fields.take<std::uint32_t>();
  head.compression = fields.takeText();
  head.recordsBytes = fields.take<std::uint64_t>();
  return ifGood(fields, std::move(head));
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

std::optional<ChunkIndex> decodeChunkIndex(Bytes content) {
  ByteReader fields(content);
  ChunkIndex index;
  index.start = takeInstant(fields);
  index.end = takeInstant(fields);
  index.chunkOffset = fields.take<std::uint64_t>();
  index.chunkLength = fields.take<std::uint64_t>();
  const bool offsetsGood = takeNumbers(fields, [&](std::uint16_t channel, std::uint64_t offset) {
    index.messageIndexOffsets.emplace_back(channel, offset);
  });
  if (!offsetsGood) return std::nullopt;
  index.messageIndexLength = fields.take<std::uint64_t>();
  index.compression = fields.takeText();
  index.compressedBytes = fields.take<std::uint64_t>();
  index.uncompressedBytes = fields.take<std::uint64_t>();
  return ifGood(fields, std::move(index));
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
  if (fields.good()) result.crcFits = crc == 0 || crc == crc32(content.first(checked));
  return ifGood(fields, std::move(result));
}

std::optional<AttachmentIndex> decodeAttachmentIndex(Bytes content) {
  ByteReader fields(content);
  AttachmentIndex index;
  index.offset = fields.take<std::uint64_t>();
  index.length = fields.take<std::uint64_t>();
  index.logTime = takeInstant(fields);
  index.createTime = takeInstant(fields);
  index.dataBytes = fields.take<std::uint64_t>();
  index.name = fields.takeText();
  index.mediaType = fields.takeText();
  return ifGood(fields, std::move(index));
}

std::optional<Statistics> decodeStatistics(Bytes content) {
  ByteReader fields(content);
  Statistics statistics;
  statistics.messageCount = fields.take<std::uint64_t>();
  statistics.schemaCount = fields.take<std::uint16_t>();
  statistics.channelCount = fields.take<std::uint32_t>();
  statistics.attachmentCount = fields.take<std::uint32_t>();
  statistics.metadataCount = fields.take<std::uint32_t>();
  statistics.chunkCount = fields.take<std::uint32_t>();
  statistics.messageStart = takeInstant(fields);
  statistics.messageEnd = takeInstant(fields);
  const bool countsGood = takeNumbers(fields, [&](std::uint16_t channel, std::uint64_t count) {
    statistics.channelMessageCounts[channel] = count;
  });
  if (!countsGood) return std::nullopt;
  return ifGood(fields, std::move(statistics));
}

std::optional<Metadata> decodeMetadata(Bytes content) {
  ByteReader fields(content);
  Metadata metadata;
  metadata.name = fields.takeText();
  if (!takeMap(fields, metadata.values)) return std::nullopt;
  return ifGood(fields, std::move(metadata));
}

std::optional<MetadataIndex> decodeMetadataIndex(Bytes content) {
  ByteReader fields(content);
  MetadataIndex index;
  index.offset = fields.take<std::uint64_t>();
  index.length = fields.take<std::uint64_t>();
  index.name = fields.takeText();
  return ifGood(fields, std::move(index));
}

std::optional<SummaryOffset> decodeSummaryOffset(Bytes content) {
  ByteReader fields(content);
  SummaryOffset offset;
  offset.group = static_cast<Opcode>(fields.take<std::uint8_t>());
  offset.start = fields.take<std::uint64_t>();
  offset.length = fields.take<std::uint64_t>();
  return ifGood(fields, offset);
}

std::optional<DataEnd> decodeDataEnd(Bytes content) {
  ByteReader fields(content);
  return ifGood(fields, DataEnd{fields.take<std::uint32_t>()});
}

}  // namespace logplayer::mcap
