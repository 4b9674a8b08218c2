// SPDX-License-Identifier: GPL-3.0-or-later
// The encode functions of Codec.h: MCAP records to bytes.
#include "logplayer/mcap/Codec.h"

#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/RecordFields.h"

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

void put(ByteWriter& fields, Opcode opcode) {
  fields.put(static_cast<std::uint8_t>(opcode));
}

void put(ByteWriter& fields, const std::string& text) {
  fields.put(std::string_view(text));
}

template <std::unsigned_integral Number>
void put(ByteWriter& fields, Number number) {
  fields.put(number);
}

void put(ByteWriter& fields, const std::map<std::string, std::string>& map) {
  std::size_t bytes = 0;
  for (const auto& [key, value] : map) bytes += 8 + key.size() + value.size();
  fields.put(static_cast<std::uint32_t>(bytes));
  for (const auto& [key, value] : map) {
    put(fields, key);
    put(fields, value);
  }
}

/// Pairs of a channel and a number.
template <typename Pairs>
requires std::same_as<typename Pairs::value_type::second_type, std::uint64_t>
void put(ByteWriter& fields, const Pairs& pairs) {
  fields.put(static_cast<std::uint32_t>(pairs.size() * 10));
  for (const auto& [key, value] : pairs) {
    fields.put(key);
    fields.put(value);
  }
}

template <typename Record>
void encodeFields(Buffer& out, Opcode opcode, const Record& record, Bytes padding = {},
                  std::uint64_t bytesToCome = 0) {
  OpenRecord open(out, opcode);
  std::apply([&](const auto&... field) { (put(open.fields, field), ...); }, fieldsOf(record));
  open.close(padding, bytesToCome);
}

}  // namespace

void encode(Buffer& out, const Header& header, Bytes padding) {
  encodeFields(out, Opcode::kHeader, header, padding);
}

void encode(Buffer& out, const Footer& footer) {
  encodeFields(out, Opcode::kFooter, footer);
}

void encode(Buffer& out, const Schema& schema, Bytes padding) {
  encodeFields(out, Opcode::kSchema, schema, padding);
}

void encode(Buffer& out, const Channel& channel, Bytes padding) {
  encodeFields(out, Opcode::kChannel, channel, padding);
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
  encodeFields(out, Opcode::kChunk, head, {}, head.recordsBytes);
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
  encodeFields(out, Opcode::kChunkIndex, index, padding);
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
  encodeFields(out, Opcode::kAttachmentIndex, index, padding);
}

void encode(Buffer& out, const Statistics& statistics, Bytes padding) {
  encodeFields(out, Opcode::kStatistics, statistics, padding);
}

void encode(Buffer& out, const Metadata& metadata, Bytes padding) {
  encodeFields(out, Opcode::kMetadata, metadata, padding);
}

void encode(Buffer& out, const MetadataIndex& index, Bytes padding) {
  encodeFields(out, Opcode::kMetadataIndex, index, padding);
}

void encode(Buffer& out, const SummaryOffset& offset, Bytes padding) {
  encodeFields(out, Opcode::kSummaryOffset, offset, padding);
}

void encode(Buffer& out, const DataEnd& end) {
  encodeFields(out, Opcode::kDataEnd, end);
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
