// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/Reader.h"

#include <algorithm>

#include "logplayer/mcap/read/ReaderParts.h"

namespace logplayer::mcap {

using robotlink::failure;
using robotlink::Result;

namespace {

/// The position behind all messages of a time.
MessagePosition behind(Instant time) {
  return {time, UINT64_MAX, UINT64_MAX, UINT16_MAX};
}

}  // namespace

const Section* ReaderParts::sectionAt(std::uint64_t offset) {
  if (lastSection < index.sections.size() && index.sections[lastSection].info.offset == offset)
    return &index.sections[lastSection];
  const auto section =
      std::ranges::lower_bound(index.sections, offset, {}, [](const Section& s) { return s.info.offset; });
  if (section == index.sections.end() || section->info.offset != offset) return nullptr;
  lastSection = static_cast<std::size_t>(section - index.sections.begin());
  return &*section;
}

std::unique_ptr<Reader> Reader::of(Source source, Options options, FileIndex index,
                                   std::shared_ptr<const FileIndex> known) {
  return std::unique_ptr<Reader>(new Reader(std::make_unique<ReaderParts>(
      std::move(source), std::move(options), std::move(index), std::move(known))));
}

Result<std::unique_ptr<Reader>> Reader::open(const std::filesystem::path& file, Options options) {
  Result<Source> source = Source::open(file);
  if (!source) return tl::unexpected(source.error());
  options.maxRecordBytes = std::min(options.maxRecordBytes, kMaxReadableRecordBytes);
  // A file that several readers scan at the same time is scanned once.
  std::shared_ptr<const FileIndex> known = KnownIndexes::all().find(*source, options.maxRecordBytes);
  if (known == nullptr) {
    Result<FileIndex> index = readIndex(*source, options);
    if (!index) return tl::unexpected(index.error());
    if (index->bySummary) return of(std::move(*source), std::move(options), std::move(*index), nullptr);
    known = KnownIndexes::all().add(*source, options.maxRecordBytes, std::move(*index));
  }
  return of(std::move(*source), std::move(options), *known, known);
}

Reader::Reader(std::unique_ptr<ReaderParts> parts) : parts_(std::move(parts)) {}
Reader::~Reader() = default;

const Header& Reader::header() const {
  return parts_->index.header;
}
const std::map<std::uint16_t, Schema>& Reader::schemas() const {
  return parts_->index.schemas;
}
const std::map<std::uint16_t, Channel>& Reader::channels() const {
  return parts_->index.channels;
}
const Statistics& Reader::statistics() const {
  return parts_->index.statistics;
}
const std::vector<Reader::ChunkInfo>& Reader::chunks() const {
  return parts_->chunks;
}
bool Reader::complete() const {
  return parts_->index.complete;
}
std::uint64_t Reader::cutOffBytes() const {
  return parts_->source.cutOff();
}
const std::vector<Damage>& Reader::damage() const {
  return parts_->index.damage;
}
std::optional<MessagePosition> Reader::latest(std::uint16_t channelId, Instant time) {
  return parts_->step(parts_->newest, behind(time), {channelId});
}

std::optional<MessagePosition> Reader::next(const MessagePosition& than,
                                            const std::vector<std::uint16_t>& channels) {
  return parts_->step(parts_->forward, than, channels);
}

std::optional<MessagePosition> Reader::previous(const MessagePosition& than,
                                                const std::vector<std::uint16_t>& channels) {
  return parts_->step(parts_->backward, than, channels);
}

std::optional<MessagePosition> ReaderParts::step(Walk& walk, const MessagePosition& than,
                                                 const std::vector<std::uint16_t>& channelIds) {
  const auto found = walk.step(than, channelIds);
  return refit() ? walk.step(than, channelIds) : found;
}

std::vector<Instant> Reader::times(std::uint16_t channelId) {
  std::vector<Instant> times;
  for (std::size_t i = 0; i < parts_->index.sections.size(); ++i) {
    if (!parts_->index.sections[i].mayHold(channelId)) continue;
    const auto list = parts_->cache.messages(i);
    for (const MessageList::Entry& entry : list->of(channelId)) times.push_back(entry.time);
  }
  if (parts_->refit()) return this->times(channelId);
  if (!std::ranges::is_sorted(times)) std::ranges::sort(times);
  return times;
}

Result<Reader::MessageData> Reader::read(const MessagePosition& position) {
  auto data = parts_->read(position);
  return !data && parts_->refit() ? parts_->read(position) : std::move(data);
}

Result<Reader::MessageData> ReaderParts::read(const MessagePosition& position) {
  const Section* section = sectionAt(position.chunkOffset);
  if (section == nullptr) return problem("mcap.no-message", position.chunkOffset, "there is no message");
  const auto number = static_cast<std::size_t>(section - index.sections.data());
  const auto records = cache.records(number);
  if (!records) return problem("mcap.damaged", position.chunkOffset, records.error());
  const auto message = messageAt(**records, position.offset, position.channelId, position.time);
  if (message) return MessageData{messageIn((*records)->data(), *message), *records};
  // Positions come from a message index, which only this checks.
  cache.distrustIndexes(number);
  return problem("mcap.damaged", position.chunkOffset, "a message is not where its index says");
}

ChannelSet ReaderParts::knownChannels() const {
  ChannelSet channels;
  for (const auto& [id, channel] : index.channels) channels.set(id);
  return channels;
}

void Reader::readAll(const std::function<bool(const Message&)>& visit) {
  Buffer records;
  bool proceed = true;
  const auto& sections = parts_->index.sections;
  ChannelSet known = parts_->knownChannels();
  std::uint64_t readTo = 0;
  for (std::size_t i = 0; proceed && i < sections.size(); ++i) {
    if (!parts_->cache.readInto(i, records)) {
      if (!parts_->refit()) continue;
      // Continues with the first one that was not read.
      known = parts_->knownChannels();
      const auto next =
          std::ranges::lower_bound(sections, readTo, {}, [](const Section& s) { return s.info.offset; });
      i = static_cast<std::size_t>(next - sections.begin()) - 1;
      continue;
    }
    for (std::size_t next = 1; next <= ReadAhead::kSections; ++next) parts_->cache.expect(i + next);
    readTo = sections[i].info.offset + 1;
    const std::size_t end = visitMessages(records, known, [&](const MessageRecord& record) {
      return proceed = visit(messageIn(records.data(), record));
    });
    if (!proceed || end == records.size()) continue;
    for (const MessageRecord& record : parts_->cache.messagesOfBroken(i, records)) {
      if (record.offset < end || !known[channelOf(records.data(), record)]) continue;
      if (!(proceed = visit(messageIn(records.data(), record)))) break;
    }
  }
}

std::vector<std::string> Reader::attachmentNames() const {
  std::vector<std::string> names;
  for (const AttachmentIndex& attachment : parts_->index.attachments) names.push_back(attachment.name);
  return names;
}

Result<Attachment> Reader::attachment(const std::string& name) {
  const auto& self = *parts_;
  const auto found = std::ranges::find(self.index.attachments, name, &AttachmentIndex::name);
  if (found == self.index.attachments.end()) {
    return failure("mcap.no-attachment", "the log file has no attachment " + name,
                   {self.source.file().string(), 0, 0});
  }
  if (found->length > self.options.maxRecordBytes) {
    return self.problem("mcap.too-large", found->offset, "the attachment " + name + " is too large");
  }
  const Buffer bytes = self.source.read(found->offset, found->length);
  const std::optional<RecordView> record = firstRecord(bytes);
  auto decoded = record && record->is(Opcode::kAttachment) ? decodeAttachment(record->content) : std::nullopt;
  if (!decoded) return self.problem("mcap.damaged", found->offset, "the attachment " + name + " is damaged");
  if (!decoded->crcFits) {
    return self.problem("mcap.damaged", found->offset, "the CRC of the attachment " + name + " is wrong");
  }
  return std::move(decoded->attachment);
}

const std::vector<Metadata>& Reader::metadata() {
  auto& self = *parts_;
  if (self.metadata) return *self.metadata;
  self.metadata.emplace();
  for (const MetadataIndex& index : self.index.metadata) {
    std::optional<Metadata> metadata;
    if (index.length <= self.options.maxRecordBytes) {
      const Buffer bytes = self.source.read(index.offset, index.length);
      const std::optional<RecordView> record = firstRecord(bytes);
      if (record && record->is(Opcode::kMetadata)) metadata = decode<Metadata>(record->content);
    }
    if (metadata) {
      self.metadata->push_back(std::move(*metadata));
    } else {
      self.index.damage.push_back({index.offset, index.length, "the metadata " + index.name + " is damaged"});
    }
  }
  return *self.metadata;
}

}  // namespace logplayer::mcap
