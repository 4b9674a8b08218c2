// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/Codec.h"

#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/RecordBytes.h"

namespace logplayer::mcap {
namespace {

/// A record that is being appended; close() fills in its length.
struct OpenRecord {
  Buffer& out;
  std::size_t start;
  ByteWriter fields;

  OpenRecord(Buffer& buffer, Opcode opcode) : out(buffer), start(buffer.size()), fields(buffer) {
    fields.put(static_cast<std::uint8_t>(opcode));
    fields.put(std::uint64_t{0});
  }
  void close(Bytes padding, std::uint64_t bytesToCome = 0) {
    fields.put(padding);
    storeNumber(out.data() + start + 1, out.size() - start - kRecordHeadBytes + bytesToCome);
  }
};

void put(ByteWriter& fields, Instant instant) {
  fields.put(nanosecondsOf(instant));
}

void put(ByteWriter& fields, const std::map<std::string, std::string>& map) {
  std::size_t bytes = 0;
  for (const auto& [key, value] : map) bytes += 8 + key.size() + value.size();
  fields.put(static_cast<std::uint32_t>(bytes));
  for (const auto& [key, value] : map) {
    fields.put(std::string_view(key));
    fields.put(std::string_view(value));
  }
}

template <typename Pairs>
void putNumbers(ByteWriter& fields, const Pairs& pairs) {
  fields.put(static_cast<std::uint32_t>(pairs.size() * 10));
  for (const auto& [key, value] : pairs) {
    fields.put(key);
    fields.put(value);
  }
}

}  // namespace

void encode(Buffer& out, const Header& header, Bytes padding) {
  OpenRecord record(out, Opcode::kHeader);
  record.fields.put(std::string_view(header.profile));
  record.fields.put(std::string_view(header.library));
  record.close(padding);
}

void encode(Buffer& out, const Footer& footer) {
  OpenRecord record(out, Opcode::kFooter);
  record.fields.put(footer.summaryStart);
  record.fields.put(footer.summaryOffsetStart);
  record.fields.put(footer.summaryCrc);
  record.close({});
}

void encode(Buffer& out, const Schema& schema, Bytes padding) {
  OpenRecord record(out, Opcode::kSchema);
  record.fields.put(schema.id);
  record.fields.put(std::string_view(schema.name));
  record.fields.put(std::string_view(schema.encoding));
  record.fields.put(std::string_view(schema.data));
  record.close(padding);
}

void encode(Buffer& out, const Channel& channel, Bytes padding) {
  OpenRecord record(out, Opcode::kChannel);
  record.fields.put(channel.id);
  record.fields.put(channel.schemaId);
  record.fields.put(std::string_view(channel.topic));
  record.fields.put(std::string_view(channel.messageEncoding));
  put(record.fields, channel.metadata);
  record.close(padding);
}

void encode(Buffer& out, const Message& message) {
  std::uint8_t head[kMessageHeadBytes];
  head[0] = static_cast<std::uint8_t>(Opcode::kMessage);
  storeNumber(head + 1, std::uint64_t{kMessageHeadBytes - kRecordHeadBytes + message.data.size()});
  storeNumber(head + 9, message.channelId);
  storeNumber(head + 11, message.sequence);
  storeNumber(head + 15, nanosecondsOf(message.logTime));
  storeNumber(head + 23, nanosecondsOf(message.publishTime));
  out.insert(out.end(), head, head + sizeof head);
  out.insert(out.end(), message.data.begin(), message.data.end());
}

void encode(Buffer& out, const ChunkHead& head) {
  OpenRecord record(out, Opcode::kChunk);
  put(record.fields, head.start);
  put(record.fields, head.end);
  record.fields.put(head.uncompressedBytes);
  record.fields.put(head.uncompressedCrc);
  record.fields.put(std::string_view(head.compression));
  record.fields.put(head.recordsBytes);
  record.close({}, head.recordsBytes);
}

void encode(Buffer& out, const MessageIndex& index, Bytes padding) {
  OpenRecord record(out, Opcode::kMessageIndex);
  record.fields.put(index.channelId);
  record.fields.put(static_cast<std::uint32_t>(index.entries.size() * 16));
  const std::size_t at = out.size();
  out.resize(at + index.entries.size() * 16);
  std::uint8_t* to = out.data() + at;
  for (const MessageIndexEntry& entry : index.entries) {
    storeNumber(to, entry.time);
    storeNumber(to + 8, entry.offset);
    to += 16;
  }
  record.close(padding);
}

void encode(Buffer& out, const ChunkIndex& index, Bytes padding) {
  OpenRecord record(out, Opcode::kChunkIndex);
  put(record.fields, index.start);
  put(record.fields, index.end);
  record.fields.put(index.chunkOffset);
  record.fields.put(index.chunkLength);
  putNumbers(record.fields, index.messageIndexOffsets);
  record.fields.put(index.messageIndexLength);
  record.fields.put(std::string_view(index.compression));
  record.fields.put(index.compressedBytes);
  record.fields.put(index.uncompressedBytes);
  record.close(padding);
}

void encode(Buffer& out, const Attachment& attachment, bool crc, Bytes padding) {
  OpenRecord record(out, Opcode::kAttachment);
  const std::size_t content = out.size();
  put(record.fields, attachment.logTime);
  put(record.fields, attachment.createTime);
  record.fields.put(std::string_view(attachment.name));
  record.fields.put(std::string_view(attachment.mediaType));
  record.fields.put(std::uint64_t{attachment.data.size()});
  record.fields.put(bytesOf(attachment.data));
  record.fields.put(crc ? crc32(Bytes(out).subspan(content)) : 0U);
  record.close(padding);
}

void encode(Buffer& out, const AttachmentIndex& index, Bytes padding) {
  OpenRecord record(out, Opcode::kAttachmentIndex);
  record.fields.put(index.offset);
  record.fields.put(index.length);
  put(record.fields, index.logTime);
  put(record.fields, index.createTime);
  record.fields.put(index.dataBytes);
  record.fields.put(std::string_view(index.name));
  record.fields.put(std::string_view(index.mediaType));
  record.close(padding);
}

void encode(Buffer& out, const Statistics& statistics, Bytes padding) {
  OpenRecord record(out, Opcode::kStatistics);
  record.fields.put(statistics.messageCount);
  record.fields.put(statistics.schemaCount);
  record.fields.put(statistics.channelCount);
  record.fields.put(statistics.attachmentCount);
  record.fields.put(statistics.metadataCount);
  record.fields.put(statistics.chunkCount);
  put(record.fields, statistics.messageStart);
  put(record.fields, statistics.messageEnd);
  putNumbers(record.fields, statistics.channelMessageCounts);
  record.close(padding);
}

void encode(Buffer& out, const Metadata& metadata, Bytes padding) {
  OpenRecord record(out, Opcode::kMetadata);
  record.fields.put(std::string_view(metadata.name));
  put(record.fields, metadata.values);
  record.close(padding);
}

void encode(Buffer& out, const MetadataIndex& index, Bytes padding) {
  OpenRecord record(out, Opcode::kMetadataIndex);
  record.fields.put(index.offset);
  record.fields.put(index.length);
  record.fields.put(std::string_view(index.name));
  record.close(padding);
}

void encode(Buffer& out, const SummaryOffset& offset, Bytes padding) {
  OpenRecord record(out, Opcode::kSummaryOffset);
  record.fields.put(static_cast<std::uint8_t>(offset.group));
  record.fields.put(offset.start);
  record.fields.put(offset.length);
  record.close(padding);
}

void encode(Buffer& out, const DataEnd& end) {
  OpenRecord record(out, Opcode::kDataEnd);
  record.fields.put(end.dataCrc);
  record.close({});
}

std::string_view compressionName(Compression compression) {
  switch (compression) {
    case Compression::kLz4:
      return "lz4";
    case Compression::kZstd:
      return "zstd";
    case Compression::kNone:
      break;
  }
  return "";
}

bool compressionOf(std::string_view name, Compression& compression) {
  for (const Compression known : {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    if (name != compressionName(known)) continue;
    compression = known;
    return true;
  }
  return false;
}

}  // namespace logplayer::mcap
