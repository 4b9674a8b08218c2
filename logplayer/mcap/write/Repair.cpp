// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the readable content of a damaged file to a new one.
#include <algorithm>

#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/read/Reader.h"
#include "logplayer/mcap/read/SectionCache.h"
#include "logplayer/mcap/write/Writer.h"

namespace logplayer::mcap {

using robotlink::failure;
using robotlink::Result;

namespace {

constexpr std::uint64_t kMessagesPerProgress = 1024;

/// A hash by which sequences of messages are compared.
class Digest {
 public:
  void add(const Message& message) {
    std::uint8_t fields[22];
    storeNumber(fields, message.channelId);
    storeNumber(fields + 2, message.sequence);
    storeNumber(fields + 6, nanosecondsOf(message.logTime));
    storeNumber(fields + 14, nanosecondsOf(message.publishTime));
    crc_ = crc32(message.data, crc32(fields, crc_));
    ++messages_;
  }
  std::uint64_t messages() const { return messages_; }
  bool operator==(const Digest&) const = default;

 private:
  std::uint32_t crc_ = 0;
  std::uint64_t messages_ = 0;
};

/// Copies everything readable from one file into another.
class Salvage {
 public:
  Salvage(const Source& source, FileIndex& index, const Reader::Options& options)
      : source_(source), index_(index), cache_(source, index, options), options_(options) {}

  Result<void> copyInto(Writer& writer);
  const Digest& digest() const { return digest_; }

 private:
  Result<void> copyDefinitions(Writer& writer);
  Result<void> copySection(std::size_t section, Writer& writer);
  Result<void> copyAttachments(Writer& writer);
  Result<void> copyMetadata(Writer& writer);
  std::optional<RecordView> recordAt(std::uint64_t offset, std::uint64_t length);

  const Source& source_;
  FileIndex& index_;
  SectionCache cache_;
  const Reader::Options& options_;
  std::map<std::uint16_t, std::uint16_t> channelIds_;  // ids in the new file by those of the old one
  Buffer buffer_;
  Digest digest_;
};

Result<void> Salvage::copyInto(Writer& writer) {
  if (Result<void> copied = copyDefinitions(writer); !copied) return copied;
  for (std::size_t i = 0; i < index_.sections.size(); ++i) {
    const double done = static_cast<double>(i) / static_cast<double>(index_.sections.size());
    if (options_.progress && !options_.progress(0.1 + 0.5 * done)) {
      return failure("log.given-up", "the repair was canceled");
    }
    if (Result<void> copied = copySection(i, writer); !copied) return copied;
  }
  if (Result<void> copied = copyAttachments(writer); !copied) return copied;
  if (Result<void> copied = copyMetadata(writer); !copied) return copied;
  return writer.close();
}

Result<void> Salvage::copyDefinitions(Writer& writer) {
  std::map<std::uint16_t, std::uint16_t> schemaIds{{0, 0}};
  for (const auto& [id, schema] : index_.schemas) {
    const auto added = writer.addSchema(schema.name, schema.encoding, schema.data);
    if (!added) return tl::unexpected(added.error());
    schemaIds[id] = *added;
  }
  for (const auto& [id, channel] : index_.channels) {
    const auto schema = schemaIds.find(channel.schemaId);
    if (schema == schemaIds.end()) {
      index_.damage.push_back({0, 0, "the schema of channel " + channel.topic + " is lost"});
    }
    const auto added =
        writer.addChannel(channel.topic, schema == schemaIds.end() ? std::uint16_t{0} : schema->second,
                          channel.messageEncoding, channel.metadata);
    if (!added) return tl::unexpected(added.error());
    channelIds_[id] = *added;
  }
  return {};
}

/// A chunk is copied as a chunk, so that related messages stay together.
Result<void> Salvage::copySection(std::size_t section, Writer& writer) {
  if (!cache_.readInto(section, buffer_)) return {};
  Result<void> result;
  const bool isChunk = !index_.sections[section].loose;
  if (isChunk) writer.beginGroup();
  const auto copy = [&](const MessageRecord& record) {
    Message message = messageIn(buffer_.data(), record);
    const auto channel = channelIds_.find(message.channelId);
    if (channel == channelIds_.end()) return true;
    message.channelId = channel->second;
    digest_.add(message);
    result = writer.write(message);
    return result.has_value();
  };
  const std::size_t end = visitMessages(buffer_, ChannelSet().set(), copy);
  if (result && end < buffer_.size()) {
    for (const MessageRecord& record : cache_.messagesOfBroken(section, buffer_)) {
      if (record.offset >= end && !copy(record)) break;
    }
  }
  if (isChunk && result) result = writer.endGroup();
  if (isChunk && result) result = writer.flush();
  return result;
}

std::optional<RecordView> Salvage::recordAt(std::uint64_t offset, std::uint64_t length) {
  if (length > options_.maxRecordBytes) return std::nullopt;
  buffer_ = source_.read(offset, length);
  return firstRecord(buffer_);
}

Result<void> Salvage::copyAttachments(Writer& writer) {
  for (const AttachmentIndex& attachment : index_.attachments) {
    const auto record = recordAt(attachment.offset, attachment.length);
    const auto decoded =
        record && record->is(Opcode::kAttachment) ? decodeAttachment(record->content) : std::nullopt;
    if (!decoded || !decoded->crcFits) {
      index_.damage.push_back(
          {attachment.offset, attachment.length, "the attachment " + attachment.name + " is damaged"});
    } else if (Result<void> written = writer.attach(decoded->attachment); !written) {
      return written;
    }
  }
  return {};
}

Result<void> Salvage::copyMetadata(Writer& writer) {
  for (const MetadataIndex& metadata : index_.metadata) {
    const auto record = recordAt(metadata.offset, metadata.length);
    const auto decoded =
        record && record->is(Opcode::kMetadata) ? decode<Metadata>(record->content) : std::nullopt;
    if (!decoded) {
      index_.damage.push_back(
          {metadata.offset, metadata.length, "the metadata " + metadata.name + " is damaged"});
    } else if (Result<void> written = writer.addMetadata(*decoded); !written) {
      return written;
    }
  }
  return {};
}

/// Reads the new file like any reader and compares it.
Result<void> check(const std::filesystem::path& file, const Digest& expected,
                   const std::function<bool(double)>& progress) {
  Reader::Options options;
  if (progress) options.progress = [&](double share) { return progress(0.6 + 0.3 * share); };
  const auto reader = Reader::open(file, options);
  if (!reader) return tl::unexpected(reader.error());
  if (!(*reader)->verify()) return failure("log.given-up", "the repair was canceled");
  Digest digest;
  bool proceed = true;
  (*reader)->readAll([&](const Message& message) {
    digest.add(message);
    const double share = static_cast<double>(digest.messages()) / static_cast<double>(expected.messages());
    if (progress && digest.messages() % kMessagesPerProgress == 0)
      proceed = progress(0.9 + 0.1 * std::min(1.0, share));
    return proceed;
  });
  if (!proceed) return failure("log.given-up", "the repair was canceled");
  if ((*reader)->complete() && (*reader)->damage().empty() && digest == expected) return {};
  return failure("mcap.repair", "the repaired file does not read as it was written; check the disk",
                 {file.string(), 0, 0});
}

Writer::Options optionsFor(const FileIndex& index) {
  Writer::Options options;
  // All chunks get the compression of the first one; its level is unknown.
  if (!index.sections.empty()) options.compression = index.sections.front().info.compression;
  options.ownChunkBytes = SIZE_MAX;
  options.profile = index.header.profile;
  options.library = index.header.library;
  return options;
}

}  // namespace

Result<RepairReport> repair(const std::filesystem::path& from, const std::filesystem::path& to,
                            const std::function<bool(double)>& progress) {
  Reader::Options options;
  if (progress) options.progress = [&](double share) { return progress(0.1 * share); };
  Result<Source> source = Source::open(from);
  if (!source) return tl::unexpected(source.error());
  Result<FileIndex> index = readIndex(*source, options, SummaryCheck::kAll);
  if (!index) return tl::unexpected(index.error());
  Result<std::unique_ptr<Writer>> writer = Writer::create(to, optionsFor(*index));
  if (!writer) return tl::unexpected(writer.error());

  options.progress = progress;
  Salvage salvage(*source, *index, options);
  Result<void> done = salvage.copyInto(**writer);
  if (done) done = check(to, salvage.digest(), progress);
  if (!done) {
    writer->reset();
    std::error_code ignored;
    std::filesystem::remove(to, ignored);
    return tl::unexpected(done.error());
  }
  RepairReport report{salvage.digest().messages(), 0, 0, std::move(index->damage)};
  for (const Damage& damage : report.damage) {
    report.bytesLost += damage.bytes;
    report.chunksLost += damage.chunks;
  }
  return report;
}

}  // namespace logplayer::mcap
