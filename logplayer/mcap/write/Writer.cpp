// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/write/Writer.h"

#include <unistd.h>

#include <algorithm>

#include "logplayer/mcap/Compression.h"
#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/Summary.h"
#include "logplayer/mcap/read/FileIndex.h"
#include "logplayer/mcap/write/ChunkBuilder.h"
#include "logplayer/mcap/write/Sink.h"

namespace logplayer::mcap {

using robotlink::failure;
using robotlink::Result;

namespace {

constexpr std::size_t kMaxIds = 65535;
// Records up to this size can be read with the reader's default limits.
constexpr std::size_t kMaxRecordBytes = (1U << 30U) - (1U << 20U);
// Number of chunks that contain the definition of a channel: without a summary, a reader finds it even if one
// of the chunks is damaged.
constexpr int kDefinitions = 2;

/// In which chunks a schema or a channel has been written so far.
struct Definition {
  int copies = 0;
  std::uint64_t chunk = 0;  ///< number of the last chunk with a copy, from 1

  /// Whether a chunk must contain a copy; it then counts as containing it.
  bool neededIn(std::uint64_t number) {
    if (copies >= kDefinitions || chunk == number) return false;
    ++copies;
    chunk = number;
    return true;
  }
};

/// A chunk that is being filled.
struct OpenChunk {
  ChunkBuilder builder;
  std::uint64_t number = 0;
  Instant began;  ///< real time of the first message
};

}  // namespace

struct Writer::Implementation {
  struct ChannelState {
    const Channel* channel = nullptr;
    const Schema* schema = nullptr;
    std::uint64_t* messages = nullptr;  // counter in the statistics; null before the first message
    Definition definition;
  };
  using SchemaKey = std::tuple<std::string, std::string, std::string>;
  using ChannelKey = std::tuple<std::string, std::uint16_t, std::string, std::map<std::string, std::string>>;

  Implementation(Sink target, Options choices)
      : options(std::move(choices)),
        sink(std::move(target)),
        compressor(options.compression, options.level),
        shared{ChunkBuilder(options.crc), 1, {}},
        own{ChunkBuilder(options.crc), 0, {}},
        clock(options.clock != nullptr ? options.clock : &steadyClock) {
    crcKnown = options.crc;
  }

  Result<void> start();
  void resume(Summary&& found, std::uint32_t crc);
  void know(const Schema& schema);
  void know(const Channel& channel);

  void add(OpenChunk& chunk, const Message& message, ChannelState& state);
  Result<void> writeOpen();
  Result<void> writeIfDue();
  Result<void> writeChunk(OpenChunk& chunk);
  void takeBack(const ChunkBuilder& builder);
  Result<void> writeRecords(Bytes records);
  Result<void> writeUnusedDefinitions();
  Result<void> finish();

  Options options;
  Sink sink;
  Compressor compressor;
  OpenChunk shared;  // for messages below ownChunkBytes
  OpenChunk own;
  Summary summary;
  std::vector<ChannelState> channels;  // indexed by id
  std::map<std::uint16_t, Definition> schemaDefinitions;
  std::map<SchemaKey, std::uint16_t> schemaIds;
  std::map<ChannelKey, std::uint16_t> channelIds;
  robotlink::SteadyClock steadyClock;
  const robotlink::Clock* clock;
  std::uint64_t chunkNumber = 1;
  std::uint32_t dataCrc = 0;
  bool crcKnown = true;
  bool inGroup = false;
  bool flushAfterGroup = false;
  bool closed = false;
  // Original end of an appended file, which is intact while nothing is written behind it; 0: a new file.
  std::uint64_t resumedAt = 0;
  Buffer head, index;  // members only to reuse their memory
};

Result<void> Writer::Implementation::start() {
  Buffer begin(std::begin(kMagic), std::end(kMagic));
  encode(begin, Header{options.profile, options.library});
  return writeRecords(begin);
}

void Writer::Implementation::resume(Summary&& found, std::uint32_t crc) {
  summary = std::move(found);
  for (const auto& [id, schema] : summary.schemas) know(schema);
  for (const auto& [id, channel] : summary.channels) know(channel);
  for (auto& [id, count] : summary.statistics.channelMessageCounts) {
    if (id < channels.size()) channels[id].messages = &count;
  }
  // The definitions are in the file already; another copy protects them, as in a file that is written in one
  // go.
  for (ChannelState& state : channels) state.definition.copies = kDefinitions - 1;
  for (auto& [id, definition] : schemaDefinitions) definition.copies = kDefinitions - 1;
  dataCrc = crc;
  crcKnown = crcKnown && crc != 0;
  resumedAt = sink.position();
}

void Writer::Implementation::know(const Schema& schema) {
  schemaIds.emplace(SchemaKey(schema.name, schema.encoding, schema.data), schema.id);
  schemaDefinitions.emplace(schema.id, Definition{});
}

void Writer::Implementation::know(const Channel& channel) {
  channelIds.emplace(ChannelKey(channel.topic, channel.schemaId, channel.messageEncoding, channel.metadata),
                     channel.id);
  if (channels.size() <= channel.id) channels.resize(std::size_t{channel.id} + 1);
  const auto schema = summary.schemas.find(channel.schemaId);
  channels[channel.id] = {&channel, schema == summary.schemas.end() ? nullptr : &schema->second, nullptr, {}};
}

void Writer::Implementation::add(OpenChunk& chunk, const Message& message, ChannelState& state) {
  if (state.definition.copies < kDefinitions && state.definition.neededIn(chunk.number)) {
    if (state.schema != nullptr && schemaDefinitions.at(state.schema->id).neededIn(chunk.number)) {
      chunk.builder.add(*state.schema);
    }
    chunk.builder.add(*state.channel);
  }
  chunk.builder.add(message);

  Statistics& statistics = summary.statistics;
  const bool first = statistics.messageCount == 0;
  statistics.messageStart = first ? message.logTime : std::min(statistics.messageStart, message.logTime);
  statistics.messageEnd = first ? message.logTime : std::max(statistics.messageEnd, message.logTime);
  ++statistics.messageCount;
  if (state.messages == nullptr) state.messages = &statistics.channelMessageCounts[message.channelId];
  ++*state.messages;
}

Result<void> Writer::Implementation::writeOpen() {
  if (shared.builder.empty()) return {};
  Result<void> written = writeChunk(shared);
  shared.builder.clear();
  shared.number = ++chunkNumber;
  return written;
}

Result<void> Writer::Implementation::writeIfDue() {
  if (inGroup || shared.builder.empty()) return {};
  const bool due = flushAfterGroup || shared.builder.records().size() >= options.chunkBytes ||
                   clock->now() - shared.began >= options.chunkAge;
  if (!due) return {};
  flushAfterGroup = false;
  return writeOpen();
}

Result<void> Writer::Implementation::writeChunk(OpenChunk& chunk) {
  ChunkBuilder& builder = chunk.builder;
  const std::optional<Bytes> compressed = compressor.compress(builder.records());
  const Bytes records = compressed.value_or(builder.records());
  ChunkHead chunkHead{builder.start(),
                      builder.end(),
                      builder.records().size(),
                      builder.crc(),
                      std::string(compressed ? compressionName(options.compression) : ""),
                      records.size()};
  head.clear();
  encode(head, chunkHead);

  ChunkIndex entry{
      builder.start(),       builder.end(),  sink.position(),         head.size() + records.size(), {}, 0,
      chunkHead.compression, records.size(), builder.records().size()};
  index.clear();
  for (const MessageIndex& channel : builder.indexes()) {
    entry.messageIndexOffsets.emplace_back(channel.channelId,
                                           entry.chunkOffset + entry.chunkLength + index.size());
    encode(index, channel);
  }
  entry.messageIndexLength = index.size();

  Result<void> written = sink.write({head, records, index});
  if (!written) {
    takeBack(builder);
    return written;
  }
  if (crcKnown) {
    dataCrc = crc32(head, dataCrc);
    dataCrc = compressed ? crc32(records, dataCrc) : joinedCrc32(dataCrc, builder.crc(), records.size());
    dataCrc = crc32(index, dataCrc);
  }
  summary.chunks.push_back(std::move(entry));
  ++summary.statistics.chunkCount;
  return {};
}

/// The statistics count what is in the file; this subtracts a chunk that was not written.
void Writer::Implementation::takeBack(const ChunkBuilder& builder) {
  Statistics& statistics = summary.statistics;
  statistics.messageCount -= builder.messages();
  for (const MessageIndex& channel : builder.indexes()) {
    *channels[channel.channelId].messages -= channel.entries.size();
  }
  statistics.messageStart = statistics.messageEnd = {};
  bool first = true;
  for (const ChunkIndex& chunk : summary.chunks) {
    if (chunk.messageIndexOffsets.empty() && chunk.end == Instant{}) continue;
    statistics.messageStart = first ? chunk.start : std::min(statistics.messageStart, chunk.start);
    statistics.messageEnd = first ? chunk.end : std::max(statistics.messageEnd, chunk.end);
    first = false;
  }
}

Result<void> Writer::Implementation::writeRecords(Bytes records) {
  Result<void> written = sink.write({records});
  if (written && crcKnown) dataCrc = crc32(records, dataCrc);
  return written;
}

/// Writes definitions that no message uses, outside of chunks.
Result<void> Writer::Implementation::writeUnusedDefinitions() {
  Buffer records;
  for (const auto& [id, schema] : summary.schemas) {
    if (schemaDefinitions.at(id).copies == 0) encode(records, schema);
  }
  for (const ChannelState& state : channels) {
    if (state.channel != nullptr && state.definition.copies == 0) encode(records, *state.channel);
  }
  return records.empty() ? Result<void>{} : writeRecords(records);
}

Result<void> Writer::Implementation::finish() {
  Buffer dataEnd;
  encode(dataEnd, DataEnd{crcKnown ? dataCrc : 0});
  return sink.write({dataEnd, encodeEnd(summary, sink.position() + dataEnd.size(), options.crc)});
}

Result<std::unique_ptr<Writer>> Writer::create(const std::filesystem::path& file, Options options) {
  Result<Sink> sink = Sink::create(file);
  if (!sink) return tl::unexpected(sink.error());
  auto implementation = std::make_unique<Implementation>(std::move(*sink), std::move(options));
  if (Result<void> started = implementation->start(); !started) {
    ::unlink(file.c_str());
    return tl::unexpected(started.error());
  }
  return std::unique_ptr<Writer>(new Writer(std::move(implementation)));
}

Result<std::unique_ptr<Writer>> Writer::append(const std::filesystem::path& file, Options options) {
  Result<Source> source = Source::open(file);
  if (!source) return tl::unexpected(source.error());
  auto index = indexBySummary(*source, kMaxRecordBytes);
  std::optional<Summary> summary = readSummary(*source, kMaxRecordBytes);
  if (!index || !summary) {
    return failure("mcap.incomplete", "only a complete log file can be appended to; repair it first",
                   {file.string(), 0, 0});
  }
  Result<Sink> sink = Sink::reopen(file, index->dataEnd);
  if (!sink) return tl::unexpected(sink.error());
  auto implementation = std::make_unique<Implementation>(std::move(*sink), std::move(options));
  implementation->resume(std::move(*summary), index->dataCrc);
  return std::unique_ptr<Writer>(new Writer(std::move(implementation)));
}

Writer::Writer(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}

Writer::~Writer() {
  static_cast<void>(close());
}

Result<std::uint16_t> Writer::addSchema(const std::string& name, const std::string& encoding,
                                        const std::string& data) {
  Implementation& self = *implementation_;
  const auto known = self.schemaIds.find({name, encoding, data});
  if (known != self.schemaIds.end()) return known->second;
  const std::size_t id =
      self.summary.schemas.empty() ? 1 : std::size_t{self.summary.schemas.rbegin()->first} + 1;
  if (id > kMaxIds) return failure("mcap.too-many", "a log file holds no more than 65,535 schemas");
  if (data.size() > kMaxRecordBytes)
    return failure("mcap.too-large", "the schema of " + name + " is too large");
  const auto schemaId = static_cast<std::uint16_t>(id);
  self.know(self.summary.schemas.emplace(schemaId, Schema{schemaId, name, encoding, data}).first->second);
  self.summary.statistics.schemaCount = static_cast<std::uint16_t>(self.summary.schemas.size());
  return schemaId;
}

Result<std::uint16_t> Writer::addChannel(const std::string& topic, std::uint16_t schemaId,
                                         const std::string& messageEncoding,
                                         const std::map<std::string, std::string>& metadata) {
  Implementation& self = *implementation_;
  const auto known = self.channelIds.find({topic, schemaId, messageEncoding, metadata});
  if (known != self.channelIds.end()) return known->second;
  if (schemaId != 0 && !self.summary.schemas.contains(schemaId)) {
    return failure("mcap.unknown-schema", "channel " + topic + " has a schema that was not added");
  }
  const std::size_t id =
      self.summary.channels.empty() ? 1 : std::size_t{self.summary.channels.rbegin()->first} + 1;
  if (id > kMaxIds) return failure("mcap.too-many", "a log file holds no more than 65,535 channels");
  const auto channelId = static_cast<std::uint16_t>(id);
  const Channel channel{channelId, schemaId, topic, messageEncoding, metadata};
  self.know(self.summary.channels.emplace(channelId, channel).first->second);
  self.summary.statistics.channelCount = static_cast<std::uint32_t>(self.summary.channels.size());
  return channelId;
}

Result<void> Writer::write(const Message& message) {
  Implementation& self = *implementation_;
  if (self.sink.error()) return tl::unexpected(*self.sink.error());
  if (self.closed) return failure("mcap.closed", "the log file is closed");
  if (message.channelId >= self.channels.size() || self.channels[message.channelId].channel == nullptr) {
    return failure("mcap.unknown-channel",
                   "a message is for channel " + std::to_string(message.channelId) + ", which was not added");
  }
  if (message.data.size() > kMaxRecordBytes) {
    return failure("mcap.too-large",
                   "a message of " + std::to_string(message.data.size()) + " bytes is too large");
  }
  Implementation::ChannelState& state = self.channels[message.channelId];
  if (message.data.size() >= self.options.ownChunkBytes) {
    self.own.number = ++self.chunkNumber;
    self.add(self.own, message, state);
    Result<void> written = self.writeChunk(self.own);
    self.own.builder.clear();
    return written;
  }
  if (self.shared.builder.empty()) self.shared.began = self.clock->now();
  self.add(self.shared, message, state);
  return self.writeIfDue();
}

void Writer::beginGroup() {
  implementation_->inGroup = true;
}

Result<void> Writer::endGroup() {
  implementation_->inGroup = false;
  return tick();
}

Result<void> Writer::tick() {
  if (implementation_->sink.error()) return tl::unexpected(*implementation_->sink.error());
  return implementation_->writeIfDue();
}

Result<void> Writer::flush() {
  if (implementation_->sink.error()) return tl::unexpected(*implementation_->sink.error());
  implementation_->flushAfterGroup = implementation_->inGroup;
  return implementation_->inGroup ? Result<void>{} : implementation_->writeOpen();
}

Result<void> Writer::attach(const Attachment& attachment) {
  Implementation& self = *implementation_;
  if (self.closed) return failure("mcap.closed", "the log file is closed");
  if (attachment.data.size() > kMaxRecordBytes) {
    return failure("mcap.too-large", "the attachment " + attachment.name + " is too large");
  }
  if (Result<void> flushed = flush(); !flushed) return flushed;
  Buffer record;
  encode(record, attachment, self.options.crc);
  const AttachmentIndex index{self.sink.position(),  record.size(),          attachment.logTime,
                              attachment.createTime, attachment.data.size(), attachment.name,
                              attachment.mediaType};
  if (Result<void> written = self.writeRecords(record); !written) return written;
  self.summary.attachments.push_back(index);
  ++self.summary.statistics.attachmentCount;
  return {};
}

Result<void> Writer::addMetadata(const Metadata& metadata) {
  Implementation& self = *implementation_;
  if (self.closed) return failure("mcap.closed", "the log file is closed");
  if (Result<void> flushed = flush(); !flushed) return flushed;
  Buffer record;
  encode(record, metadata);
  const MetadataIndex index{self.sink.position(), record.size(), metadata.name};
  if (Result<void> written = self.writeRecords(record); !written) return written;
  self.summary.metadata.push_back(index);
  ++self.summary.statistics.metadataCount;
  return {};
}

Result<void> Writer::close() {
  Implementation& self = *implementation_;
  if (!self.closed) {
    self.closed = true;
    // Errors are reported below.
    if (!self.sink.error()) static_cast<void>(self.writeOpen());
    if (!self.sink.error()) static_cast<void>(self.writeUnusedDefinitions());
    if (self.resumedAt != 0 && self.sink.position() == self.resumedAt && !self.sink.error()) return {};
    // Also after an error: on a full disk the chunk that did not fit leaves room for the summary, which makes
    // the file complete.
    if (self.sink.error()) {
      self.takeBack(self.shared.builder);
      self.sink.forgive();
    }
    if (self.finish() && self.options.sync) static_cast<void>(self.sink.sync());
  }
  if (self.sink.error()) return tl::unexpected(*self.sink.error());
  return {};
}

const Statistics& Writer::statistics() const {
  return implementation_->summary.statistics;
}
std::uint64_t Writer::bytesWritten() const {
  return implementation_->sink.position();
}
}  // namespace logplayer::mcap
