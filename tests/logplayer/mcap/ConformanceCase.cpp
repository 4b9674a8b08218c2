// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/logplayer/mcap/ConformanceCase.h"

#include <nlohmann/json.hpp>

#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/read/ChunkLoader.h"

namespace logplayer::mcap::test {
namespace {

/// A record's fields by name. Numbers are strings in the known answers.
class Fields {
 public:
  explicit Fields(const nlohmann::json& fields) {
    for (const auto& field : fields) fields_[field[0].get<std::string>()] = field[1];
  }

  template <typename Number>
  Number number(const std::string& name) const {
    return static_cast<Number>(std::stoull(fields_.at(name).get<std::string>()));
  }
  Instant time(const std::string& name) const { return instantOf(number<std::uint64_t>(name)); }
  std::string text(const std::string& name) const { return fields_.at(name).get<std::string>(); }
  std::string bytes(const std::string& name) const {
    std::string bytes;
    for (const auto& byte : fields_.at(name))
      bytes.push_back(static_cast<char>(std::stoi(byte.get<std::string>())));
    return bytes;
  }
  std::map<std::string, std::string> map(const std::string& name) const {
    return fields_.at(name).get<std::map<std::string, std::string>>();
  }
  std::map<std::uint16_t, std::uint64_t> numbers(const std::string& name) const {
    std::map<std::uint16_t, std::uint64_t> numbers;
    for (const auto& [key, value] : map(name))
      numbers[static_cast<std::uint16_t>(std::stoul(key))] = std::stoull(value);
    return numbers;
  }

 private:
  std::map<std::string, nlohmann::json> fields_;
};

ChunkIndex chunkIndexOf(const Fields& f) {
  ChunkIndex index{f.time("message_start_time"),
                   f.time("message_end_time"),
                   f.number<std::uint64_t>("chunk_start_offset"),
                   f.number<std::uint64_t>("chunk_length"),
                   {},
                   f.number<std::uint64_t>("message_index_length"),
                   f.text("compression"),
                   f.number<std::uint64_t>("compressed_size"),
                   f.number<std::uint64_t>("uncompressed_size")};
  for (const auto& [channel, offset] : f.numbers("message_index_offsets")) {
    index.messageIndexOffsets.emplace_back(channel, offset);
  }
  return index;
}

Statistics statisticsOf(const Fields& f) {
  return {f.number<std::uint64_t>("message_count"),
          f.number<std::uint16_t>("schema_count"),
          f.number<std::uint32_t>("channel_count"),
          f.number<std::uint32_t>("attachment_count"),
          f.number<std::uint32_t>("metadata_count"),
          f.number<std::uint32_t>("chunk_count"),
          f.time("message_start_time"),
          f.time("message_end_time"),
          f.numbers("channel_message_counts")};
}

Record recordOf(const std::string& type, const Fields& f) {
  if (type == "Header") return Header{f.text("profile"), f.text("library")};
  if (type == "Footer") {
    return Footer{f.number<std::uint64_t>("summary_start"), f.number<std::uint64_t>("summary_offset_start"),
                  f.number<std::uint32_t>("summary_crc")};
  }
  if (type == "Schema") {
    return Schema{f.number<std::uint16_t>("id"), f.text("name"), f.text("encoding"), f.bytes("data")};
  }
  if (type == "Channel") {
    return Channel{f.number<std::uint16_t>("id"), f.number<std::uint16_t>("schema_id"), f.text("topic"),
                   f.text("message_encoding"), f.map("metadata")};
  }
  if (type == "Message") {
    return OwnedMessage{f.number<std::uint16_t>("channel_id"), f.number<std::uint32_t>("sequence"),
                        f.number<std::uint64_t>("log_time"), f.number<std::uint64_t>("publish_time"),
                        f.bytes("data")};
  }
  if (type == "ChunkIndex") return chunkIndexOf(f);
  if (type == "Attachment") {
    return Attachment{f.time("log_time"), f.time("create_time"), f.text("name"), f.text("media_type"),
                      f.bytes("data")};
  }
  if (type == "AttachmentIndex") {
    return AttachmentIndex{f.number<std::uint64_t>("offset"),
                           f.number<std::uint64_t>("length"),
                           f.time("log_time"),
                           f.time("create_time"),
                           f.number<std::uint64_t>("data_size"),
                           f.text("name"),
                           f.text("media_type")};
  }
  if (type == "Statistics") return statisticsOf(f);
  if (type == "Metadata") return Metadata{f.text("name"), f.map("metadata")};
  if (type == "MetadataIndex") {
    return MetadataIndex{f.number<std::uint64_t>("offset"), f.number<std::uint64_t>("length"),
                         f.text("name")};
  }
  if (type == "SummaryOffset") {
    return SummaryOffset{static_cast<Opcode>(f.number<std::uint8_t>("group_opcode")),
                         f.number<std::uint64_t>("group_start"), f.number<std::uint64_t>("group_length")};
  }
  if (type == "DataEnd") return DataEnd{f.number<std::uint32_t>("data_section_crc")};
  throw std::runtime_error("unknown type of record: " + type);
}

template <typename Decoded>
bool append(std::vector<Record>& records, const std::optional<Decoded>& record) {
  if (record) records.emplace_back(*record);
  return record.has_value();
}

bool appendAll(std::vector<Record>& records, Bytes bytes);

bool appendDecoded(std::vector<Record>& records, const RecordView& record) {
  const Bytes content = record.content;
  switch (static_cast<Opcode>(record.opcode)) {
    case Opcode::kHeader:
      return append(records, decode<Header>(content));
    case Opcode::kFooter:
      return append(records, decode<Footer>(content));
    case Opcode::kSchema:
      return append(records, decode<Schema>(content));
    case Opcode::kChannel:
      return append(records, decode<Channel>(content));
    case Opcode::kChunkIndex:
      return append(records, decode<ChunkIndex>(content));
    case Opcode::kAttachmentIndex:
      return append(records, decode<AttachmentIndex>(content));
    case Opcode::kStatistics:
      return append(records, decode<Statistics>(content));
    case Opcode::kMetadata:
      return append(records, decode<Metadata>(content));
    case Opcode::kMetadataIndex:
      return append(records, decode<MetadataIndex>(content));
    case Opcode::kSummaryOffset:
      return append(records, decode<SummaryOffset>(content));
    case Opcode::kDataEnd:
      return append(records, decode<DataEnd>(content));
    case Opcode::kMessageIndex:
      return decodeMessageIndex(content).has_value();
    case Opcode::kMessage: {
      const auto message = decodeMessage(content);
      if (message) records.emplace_back(OwnedMessage::of(*message));
      return message.has_value();
    }
    case Opcode::kAttachment: {
      const auto attachment = decodeAttachment(content);
      if (attachment) records.emplace_back(attachment->attachment);
      return attachment && attachment->crcFits;
    }
    case Opcode::kChunk: {
      const auto head = decode<ChunkHead>(content);
      if (!head) return false;
      const Bytes inner = content.subspan(chunkHeadBytes(head->compression.size()));
      return inner.size() == head->recordsBytes && appendAll(records, inner);
    }
  }
  return false;
}

bool appendAll(std::vector<Record>& records, Bytes bytes) {
  bool good = true;
  return visitRecords(bytes,
                      [&](const RecordView& r, std::size_t) { good = good && appendDecoded(records, r); }) &&
         good;
}

}  // namespace

Message OwnedMessage::view() const {
  return {channelId, sequence, instantOf(logTime), instantOf(publishTime), bytesOf(data)};
}

OwnedMessage OwnedMessage::of(const Message& message) {
  return {message.channelId, message.sequence, nanosecondsOf(message.logTime),
          nanosecondsOf(message.publishTime), std::string(textOf(message.data))};
}

std::vector<ConformanceCase> conformanceCases(const std::string& json) {
  std::vector<ConformanceCase> cases;
  for (const auto& entry : nlohmann::json::parse(json)) {
    ConformanceCase& conformance = cases.emplace_back();
    conformance.name = entry["name"];
    conformance.features = entry["features"].get<std::set<std::string>>();
    for (const auto& record : entry["records"]) {
      conformance.records.push_back(recordOf(record["type"], Fields(record["fields"])));
    }
  }
  return cases;
}

std::optional<std::vector<Record>> recordsIn(Bytes file) {
  if (file.size() < 2 * sizeof kMagic) return std::nullopt;
  std::vector<Record> records;
  if (!appendAll(records, file.subspan(sizeof kMagic, file.size() - 2 * sizeof kMagic))) return std::nullopt;
  return records;
}

}  // namespace logplayer::mcap::test
