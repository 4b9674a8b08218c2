// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/RecordBytes.h"
#include "tests/logplayer/mcap/ConformanceCase.h"

// How the conformance suite lays its files out, as the codec has it.
namespace logplayer::mcap::test {
namespace {

constexpr std::uint8_t kPadding[] = {0x01, 0xFF, 0xFF};

class FileOfCase {
 public:
  explicit FileOfCase(const ConformanceCase& conformance) : case_(conformance) {
    if (case_.has("pad")) padding_ = kPadding;
    for (const Record& record : case_.records) {
      if (std::holds_alternative<DataEnd>(record)) break;
      given_.push_back(&record);
    }
  }
  Buffer write();

 private:
  template <typename Kind>
  std::vector<Kind> given() const {
    std::vector<Kind> found;
    for (const Record* record : given_) {
      if (const Kind* kind = std::get_if<Kind>(record)) found.push_back(*kind);
    }
    return found;
  }

  void writeData();
  void add(const Attachment& attachment);
  void add(const Metadata& metadata);
  void addMessageRecords(Buffer& to, Bytes padding);
  void addChunk();
  void addSummary();
  void addGroup(Opcode opcode, const auto& records);
  Statistics statistics() const;

  const ConformanceCase& case_;
  Bytes padding_;
  std::vector<const Record*> given_;
  Buffer out_;
  std::vector<AttachmentIndex> attachments_;
  std::vector<MetadataIndex> metadata_;
  std::vector<ChunkIndex> chunks_;
  std::vector<SummaryOffset> offsets_;
};

Buffer FileOfCase::write() {
  out_.assign(std::begin(kMagic), std::end(kMagic));
  encode(out_, Header{"", ""}, padding_);
  writeData();
  encode(out_, DataEnd{crc32(out_)});
  addSummary();
  out_.insert(out_.end(), std::begin(kMagic), std::end(kMagic));
  return std::move(out_);
}

void FileOfCase::writeData() {
  if (!case_.has("ch")) addMessageRecords(out_, padding_);
  for (const Attachment& attachment : given<Attachment>()) add(attachment);
  for (const Metadata& metadata : given<Metadata>()) add(metadata);
  if (case_.has("ch")) addChunk();
}

void FileOfCase::add(const Attachment& attachment) {
  const std::uint64_t offset = out_.size();
  encode(out_, attachment, true, padding_);
  attachments_.push_back({offset, out_.size() - offset, attachment.logTime, attachment.createTime,
                          attachment.data.size(), attachment.name, attachment.mediaType});
}

void FileOfCase::add(const Metadata& metadata) {
  const std::uint64_t offset = out_.size();
  encode(out_, metadata, padding_);
  metadata_.push_back({offset, out_.size() - offset, metadata.name});
}

void FileOfCase::addMessageRecords(Buffer& to, Bytes padding) {
  for (const Record* record : given_) {
    if (const auto* schema = std::get_if<Schema>(record)) encode(to, *schema, padding);
    if (const auto* channel = std::get_if<Channel>(record)) encode(to, *channel, padding);
    if (const auto* message = std::get_if<OwnedMessage>(record)) encode(to, message->view());
  }
}

void FileOfCase::addChunk() {
  Buffer records;
  std::vector<MessageIndex> indexes;
  for (const Record* record : given_) {
    if (const auto* schema = std::get_if<Schema>(record)) encode(records, *schema);
    if (const auto* channel = std::get_if<Channel>(record)) {
      encode(records, *channel);
      indexes.push_back({channel->id, {}});
    }
    const auto* message = std::get_if<OwnedMessage>(record);
    if (message == nullptr) continue;
    std::ranges::find(indexes, message->channelId, &MessageIndex::channelId)
        ->entries.push_back({message->logTime, records.size()});
    encode(records, message->view());
  }
  const Statistics times = statistics();
  ChunkIndex index{times.messageStart, times.messageEnd, out_.size(), 0, {}, 0, "",
                   records.size(),     records.size()};
  encode(out_,
         ChunkHead{times.messageStart, times.messageEnd, records.size(), crc32(records), "", records.size()});
  out_.insert(out_.end(), records.begin(), records.end());
  index.chunkLength = out_.size() - index.chunkOffset;
  if (case_.has("mx")) {
    for (const MessageIndex& channel : indexes) {
      index.messageIndexOffsets.emplace_back(channel.channelId, out_.size());
      encode(out_, channel, padding_);
    }
  }
  index.messageIndexLength = out_.size() - index.chunkOffset - index.chunkLength;
  chunks_.push_back(std::move(index));
}

void FileOfCase::addGroup(Opcode opcode, const auto& records) {
  const std::uint64_t start = out_.size();
  for (const auto& record : records) encode(out_, record, padding_);
  if (out_.size() != start) offsets_.push_back({opcode, start, out_.size() - start});
}

void FileOfCase::addSummary() {
  const std::uint64_t start = out_.size();
  if (case_.has("rsh")) addGroup(Opcode::kSchema, given<Schema>());
  if (case_.has("rch")) addGroup(Opcode::kChannel, given<Channel>());
  if (case_.has("st")) addGroup(Opcode::kStatistics, std::vector{statistics()});
  if (case_.has("mdx")) addGroup(Opcode::kMetadataIndex, metadata_);
  if (case_.has("ax")) addGroup(Opcode::kAttachmentIndex, attachments_);
  if (case_.has("chx")) addGroup(Opcode::kChunkIndex, chunks_);
  const std::uint64_t offsetStart = out_.size();
  if (case_.has("sum")) {
    for (const SummaryOffset& offset : offsets_) encode(out_, offset, padding_);
  }
  Footer footer{offsetStart > start ? start : 0, out_.size() > offsetStart ? offsetStart : 0, 0};
  encode(out_, footer);
  storeNumber(out_.data() + out_.size() - 4,
              crc32(Bytes(out_).subspan(start).first(out_.size() - start - 4)));
}

Statistics FileOfCase::statistics() const {
  Statistics statistics;
  for (const OwnedMessage& message : given<OwnedMessage>()) {
    const Instant time = instantOf(message.logTime);
    const bool first = statistics.messageCount == 0;
    statistics.messageStart = first ? time : std::min(statistics.messageStart, time);
    statistics.messageEnd = first ? time : std::max(statistics.messageEnd, time);
    ++statistics.messageCount;
    ++statistics.channelMessageCounts[message.channelId];
  }
  statistics.schemaCount = static_cast<std::uint16_t>(given<Schema>().size());
  statistics.channelCount = static_cast<std::uint32_t>(given<Channel>().size());
  statistics.attachmentCount = static_cast<std::uint32_t>(attachments_.size());
  statistics.metadataCount = static_cast<std::uint32_t>(metadata_.size());
  statistics.chunkCount = static_cast<std::uint32_t>(chunks_.size());
  return statistics;
}

}  // namespace

Buffer writtenBy(const ConformanceCase& conformance) {
  return FileOfCase(conformance).write();
}

}  // namespace logplayer::mcap::test
