// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/Scan.h"

#include <algorithm>

#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/read/Resync.h"

namespace logplayer::mcap {
namespace {

/// Approximate size of sections of messages outside of chunks.
constexpr std::uint64_t kLooseBytes = 1U << 20U;
/// Number of bytes between reports of progress.
constexpr std::uint64_t kProgressBytes = 4U << 20U;
/// Number of bytes of an attachment that are read to find its name.
constexpr std::size_t kAttachmentHead = 64U << 10U;
/// A longer run of zeros at the end of a file was never written: no chunk ends like this.
constexpr std::uint64_t kZeros = 4096;

class Scanner {
 public:
  Scanner(const Source& source, const ReadOptions& options)
      : source_(source),
        options_(options),
        window_(source),
        loader_(source, options.maxRecordBytes),
        resync_(source, options.maxRecordBytes) {}

  FileIndex run();

 private:
  /// The result of processing a record.
  enum class Taken : std::uint8_t {
    kWhole,  ///< completely understood
    kPart,   ///< partly or completely skipped; only its length locates the next record
    kNot,    ///< inconsistent
  };

  bool begin();
  void hop();
  bool recover();
  bool atEnd();
  bool reportProgress(std::uint64_t at);
  Taken take(Opcode opcode, std::uint64_t length);
  Taken takeChunk(std::uint64_t length);
  Taken takeMessageIndex(std::uint64_t length);
  Taken takeMessage(std::uint64_t length);
  Taken takeAttachment(std::uint64_t length);
  Taken takeSmall(Opcode opcode, std::uint64_t length);
  void learn(const RecordView& record);
  void finishSection();
  enum class Read : std::uint8_t { kWhole, kInPart, kNot };
  Read readDefinitions(Section& section);
  bool isAt(std::uint64_t offset, Opcode opcode) {
    const Bytes byte = window_.look(offset, 1);
    return !byte.empty() && byte[0] == static_cast<std::uint8_t>(opcode);
  }
  void noteLost(std::uint64_t from, std::uint64_t to, bool goesOn, std::uint64_t chunks);
  void count(std::uint16_t channelId, std::uint64_t messages);
  void countTimes(const Section& section);
  void finish();
  void note(std::uint64_t offset, std::uint64_t bytes, std::string what) {
    index_.damage.push_back({offset, bytes, std::move(what)});
  }

  const Source& source_;
  const ReadOptions& options_;
  SourceWindow window_;
  ChunkLoader loader_;
  Resync resync_;
  FileIndex index_;
  Buffer records_;
  std::uint64_t offset_ = 0;    // of the current record
  std::uint64_t end_ = 0;       // of the next record
  std::uint64_t certain_ = 0;   // everything before this was understood
  std::uint64_t read_ = 0;      // end of messages outside of chunks, if their lengths are right
  std::uint64_t reported_ = 0;  // last reported progress
  std::optional<std::uint64_t>
      torn_;  // the last chunk, if it could not be read completely: its length may be wrong
  std::uint64_t searchFrom_ = 0;  // behind the place where the last damage ended
  bool open_ = false;             // whether the last section may still grow
  bool unsure_ = false;           // whether indexes of the last section may be missing
  bool ended_ = false;            // whether the footer was found
  bool sawStrayIndex_ = false;
  std::map<std::uint16_t, std::uint64_t> sectionCounts_;  // of the open section
};

FileIndex Scanner::run() {
  if (begin()) {
    while (offset_ < source_.bytes() && !atEnd() && reportProgress(offset_)) hop();
  }
  unsure_ = true;
  finishSection();
  finish();
  return std::move(index_);
}

bool Scanner::begin() {
  const Bytes magic = window_.look(0, sizeof kMagic);
  if (std::ranges::equal(magic, kMagic)) {
    offset_ = certain_ = sizeof kMagic;
    return true;
  }
  return recover();
}

/// Whether the magic at the end of the file was reached. Bytes behind it do not belong to the file, but may
/// be another file.
bool Scanner::atEnd() {
  if (source_.bytes() - offset_ < sizeof kMagic) return false;
  if (!std::ranges::equal(window_.look(offset_, sizeof kMagic), kMagic)) return false;
  ended_ = ended_ && index_.dataEnd != 0;
  certain_ = offset_ = offset_ + sizeof kMagic;
  return offset_ == source_.bytes();
}

bool Scanner::reportProgress(std::uint64_t at) {
  if (!options_.progress || at - std::min(reported_, at) < kProgressBytes) return true;
  reported_ = at;
  if (options_.progress(static_cast<double>(at) / static_cast<double>(source_.bytes()))) return true;
  index_.givenUp = true;
  offset_ = certain_ = source_.bytes();
  return false;
}

void Scanner::hop() {
  const Bytes head = window_.look(offset_, kRecordHeadBytes);
  Taken taken = Taken::kNot;
  const auto opcode = static_cast<Opcode>(head.empty() ? 0 : head[0]);
  if (head.size() == kRecordHeadBytes && head[0] != 0) {
    const auto length = loadNumber<std::uint64_t>(head.data() + 1);
    if (length <= source_.bytes() - offset_ - kRecordHeadBytes) {
      end_ = offset_ + kRecordHeadBytes + length;
      taken = take(opcode, length);
      if (taken == Taken::kNot && recordMayBeAt(window_, source_, end_) && end_ != source_.bytes()) {
        note(offset_, end_ - offset_, "a record contradicts itself");
        taken = Taken::kPart;
      }
    }
  }
  if (taken == Taken::kNot) {
    if (!recover()) offset_ = source_.bytes();
    return;
  }
  offset_ = end_;
  if (taken == Taken::kWhole) certain_ = end_;
  const bool isOfSection =
      opcode == Opcode::kChunk || opcode == Opcode::kMessage || opcode == Opcode::kMessageIndex;
  if (isOfSection) return;
  // This may be a damaged message index, and others may follow.
  if (taken == Taken::kPart) unsure_ = true;
  if (taken == Taken::kWhole) finishSection();
}

/// Continues at the next readable place; returns false if there is none.
bool Scanner::recover() {
  unsure_ = true;
  finishSection();
  const bool loose = !torn_ && (index_.sections.empty() || index_.sections.back().loose);
  // If a part of a chunk is missing, the next chunk begins before the end that its length implies.
  if (torn_) certain_ = *torn_ + 1;
  // Do not find the same place again: the record there was not understood.
  certain_ = std::max(certain_, searchFrom_);
  const auto found =
      resync_.find(certain_, loose, index_.channels, [this](std::uint64_t at) { return reportProgress(at); });
  if (index_.givenUp) return false;
  const std::uint64_t next = found.value_or(source_.bytes());
  const std::uint64_t lost = torn_ ? *torn_ : next < read_ ? certain_ : std::max(certain_, read_);
  const bool ofChunk = torn_ || !loose || isAt(lost, Opcode::kChunk);
  if (torn_)
    std::erase_if(index_.damage,
                  [&](const Damage& damage) { return damage.offset == *torn_ && damage.bytes > 0; });
  // Behind the data section there are only copies of what was read.
  noteLost(lost, next, found.has_value(), ofChunk && index_.dataEnd == 0 ? 1 : 0);
  torn_.reset();
  offset_ = certain_ = next;
  searchFrom_ = next + 1;
  return found.has_value();
}

void Scanner::noteLost(std::uint64_t from, std::uint64_t to, bool goesOn, std::uint64_t chunks) {
  std::uint64_t data = goesOn ? to : std::max(from, resync_.dataEnd());
  if (to - data < kZeros) data = to;
  if (data < to) {
    note(data, 0,
         "the file continues with " + std::to_string(to - data) + " zero bytes: nothing was written there");
  }
  if (data > from) {
    note(from, data - from,
         goesOn ? "the file is damaged; reading continues after that"
                : "the file ends within a record, or is damaged to its end");
    index_.damage.back().chunks = chunks;
  }
}

Scanner::Taken Scanner::take(Opcode opcode, std::uint64_t length) {
  switch (opcode) {
    case Opcode::kChunk:
      return takeChunk(length);
    case Opcode::kMessageIndex:
      return takeMessageIndex(length);
    case Opcode::kMessage:
      return takeMessage(length);
    case Opcode::kAttachment:
      return takeAttachment(length);
    case Opcode::kHeader:
    case Opcode::kSchema:
    case Opcode::kChannel:
    case Opcode::kMetadata:
    case Opcode::kDataEnd:
    case Opcode::kFooter:
      return length > options_.maxRecordBytes ? Taken::kNot : takeSmall(opcode, length);
    default:
      return Taken::kPart;
  }
}

Scanner::Taken Scanner::takeChunk(std::uint64_t length) {
  std::optional<Section> section = chunkAt(window_, source_, offset_);
  if (!section) return Taken::kNot;
  const std::string_view name = section->unknownCompression.empty()
                                    ? compressionName(section->info.compression)
                                    : section->unknownCompression;
  const std::uint64_t understood = chunkHeadBytes(name.size()) + section->info.compressedBytes;
  finishSection();
  torn_.reset();
  open_ = true;
  unsure_ = false;
  sawStrayIndex_ = false;
  section->indexOffset = end_;
  index_.sections.push_back(std::move(*section));
  // If its length is wrong, the bytes behind its records are examined again.
  certain_ = offset_ + kRecordHeadBytes + understood;
  return understood == length ? Taken::kWhole : Taken::kPart;
}

Scanner::Taken Scanner::takeMessageIndex(std::uint64_t length) {
  if (length < 6) return Taken::kNot;
  const Bytes content = window_.look(offset_ + kRecordHeadBytes, 6);
  const auto channelId = loadNumber<std::uint16_t>(content.data());
  const auto bytes = loadNumber<std::uint32_t>(content.data() + 2);
  if (bytes > length - 6 || bytes % 16 != 0) return Taken::kNot;
  const bool follows = open_ && !index_.sections.back().loose;
  if (!follows) {
    if (!sawStrayIndex_) note(offset_, 0, "message indexes lack their chunk");
    sawStrayIndex_ = true;
    return Taken::kPart;
  }
  Section& section = index_.sections.back();
  section.indexed = true;
  section.indexLength = end_ - section.indexOffset;
  if (bytes > 0) {
    section.channels.push_back(channelId);
    section.info.messages += bytes / 16;
    sectionCounts_[channelId] += bytes / 16;
  }
  return bytes == length - 6 ? Taken::kWhole : Taken::kPart;
}

Scanner::Taken Scanner::takeMessage(std::uint64_t length) {
  if (length < kMessageHeadBytes - kRecordHeadBytes) return Taken::kNot;
  const std::optional<Message> message =
      decodeMessage(window_.look(offset_ + kRecordHeadBytes, kMessageHeadBytes - kRecordHeadBytes));
  if (!message || index_.dataEnd != 0 || !index_.channels.contains(message->channelId)) return Taken::kNot;
  // A message index with a damaged opcode looks like a message: its length is where a message has its
  // sequence.
  const bool behindChunk = open_ && !index_.sections.back().loose;
  if (behindChunk && message->sequence + std::uint64_t{6} == length) return Taken::kNot;
  const bool goesOn =
      open_ && index_.sections.back().loose && index_.sections.back().info.length + length <= kLooseBytes;
  if (!goesOn) {
    finishSection();
    Section section;
    section.loose = true;
    section.info.offset = offset_;
    section.info.start = section.info.end = message->logTime;
    index_.sections.push_back(std::move(section));
    open_ = true;
  }
  ChunkInfo& info = index_.sections.back().info;
  info.length = info.uncompressedBytes = info.compressedBytes = end_ - info.offset;
  info.start = std::min(info.start, message->logTime);
  info.end = std::max(info.end, message->logTime);
  ++info.messages;
  ++sectionCounts_[message->channelId];
  certain_ = offset_ + kMessageHeadBytes;  // only its length locates its end
  read_ = end_;
  return Taken::kPart;
}

Scanner::Taken Scanner::takeAttachment(std::uint64_t length) {
  ByteReader fields(window_.look(offset_ + kRecordHeadBytes,
                                 static_cast<std::size_t>(std::min<std::uint64_t>(length, kAttachmentHead))));
  AttachmentIndex index;
  index.offset = offset_;
  index.length = end_ - offset_;
  index.logTime = instantOf(fields.take<std::uint64_t>());
  index.createTime = instantOf(fields.take<std::uint64_t>());
  index.name = fields.takeText();
  index.mediaType = fields.takeText();
  index.dataBytes = fields.take<std::uint64_t>();
  const std::uint64_t head = 16 + 4 + index.name.size() + 4 + index.mediaType.size() + 8;
  if (!fields.good() || head + 4 > length || index.dataBytes > length - head - 4) return Taken::kNot;
  const bool whole = head + index.dataBytes + 4 == length;
  index_.attachments.push_back(std::move(index));
  return whole ? Taken::kWhole : Taken::kPart;
}

/// Processes records that are read as a whole. They count as understood if encoding them again yields the
/// same length.
Scanner::Taken Scanner::takeSmall(Opcode opcode, std::uint64_t length) {
  const Buffer content = source_.read(offset_ + kRecordHeadBytes, length);
  if (content.size() != length) return Taken::kNot;
  const auto takeAs = [&]<typename Record>(std::type_identity<Record>, auto use) {
    const auto record = decode<Record>(content);
    if (!record) return Taken::kNot;
    use(*record);
    Buffer again;
    encode(again, *record);
    return again.size() == kRecordHeadBytes + length ? Taken::kWhole : Taken::kPart;
  };
  const auto learnThis = [&](const auto&) { learn({static_cast<std::uint8_t>(opcode), content}); };
  switch (opcode) {
    case Opcode::kHeader:
      return takeAs(std::type_identity<Header>(), [&](const Header& header) { index_.header = header; });
    case Opcode::kSchema:
      return takeAs(std::type_identity<Schema>(), learnThis);
    case Opcode::kChannel:
      return takeAs(std::type_identity<Channel>(), learnThis);
    case Opcode::kMetadata:
      return takeAs(std::type_identity<Metadata>(), [&](const Metadata& metadata) {
        index_.metadata.push_back({offset_, end_ - offset_, metadata.name});
      });
    case Opcode::kDataEnd:
      if (length != kDataEndBytes - kRecordHeadBytes) return Taken::kNot;
      index_.dataEnd = offset_;
      index_.dataCrc = decode<DataEnd>(content)->dataCrc;
      return Taken::kWhole;
    default:
      ended_ = length == kFooterBytes - kRecordHeadBytes;
      return ended_ ? Taken::kWhole : Taken::kNot;
  }
}

void Scanner::learn(const RecordView& record) {
  if (record.is(Opcode::kSchema)) {
    if (auto schema = decode<Schema>(record.content)) index_.schemas.emplace(schema->id, std::move(*schema));
  } else if (record.is(Opcode::kChannel)) {
    if (auto channel = decode<Channel>(record.content))
      index_.channels.emplace(channel->id, std::move(*channel));
  }
}

/// Completes the last section.
void Scanner::finishSection() {
  if (!open_) return;
  open_ = false;
  Section& section = index_.sections.back();
  if (unsure_ && !section.loose) {
    section.indexed = false;
    section.channels.clear();
    section.info.messages = 0;
    sectionCounts_.clear();
  }
  std::ranges::sort(section.channels);
  const auto isKnown = [&](std::uint16_t id) { return index_.channels.contains(id); };
  const bool mustRead =
      !section.loose && (!section.indexed || !std::ranges::all_of(section.channels, isKnown));
  const Read read = mustRead ? readDefinitions(section) : Read::kWhole;
  if (unsure_ && read != Read::kWhole) torn_ = section.info.offset;
  if (read == Read::kNot) {
    index_.sections.pop_back();
  } else {
    countTimes(section);
    for (const auto& [channel, messages] : sectionCounts_) count(channel, messages);
  }
  sectionCounts_.clear();
}

/// Reads a chunk to find its channels, and to count its messages if it has no indexes.
Scanner::Read Scanner::readDefinitions(Section& section) {
  const auto loaded = loader_.load(section, records_);
  if (!loaded) {
    // If the search continues from its head, that reports the damage.
    note(section.info.offset, section.info.length, loaded.error());
    index_.damage.back().chunks = 1;
    return Read::kNot;
  }
  const bool counts = !section.indexed;
  const bool whole = visitRecords(records_, [&](const RecordView& record, std::size_t) {
    learn(record);
    if (!counts || !record.is(Opcode::kMessage)) return;
    if (const auto message = decodeMessage(record.content)) {
      ChunkInfo& info = section.info;
      info.start = info.messages == 0 ? message->logTime : std::min(info.start, message->logTime);
      info.end = info.messages == 0 ? message->logTime : std::max(info.end, message->logTime);
      ++info.messages;
      ++sectionCounts_[message->channelId];
    }
  });
  if (!whole) note(section.info.offset, 0, "the records of a chunk do not fill it");
  return whole ? Read::kWhole : Read::kInPart;
}

void Scanner::count(std::uint16_t channelId, std::uint64_t messages) {
  index_.statistics.messageCount += messages;
  index_.statistics.channelMessageCounts[channelId] += messages;
}

void Scanner::countTimes(const Section& section) {
  if (section.info.messages == 0) return;
  Statistics& statistics = index_.statistics;
  const bool first = statistics.messageCount == 0;
  statistics.messageStart =
      first ? section.info.start : std::min(statistics.messageStart, section.info.start);
  statistics.messageEnd = first ? section.info.end : std::max(statistics.messageEnd, section.info.end);
}

void Scanner::finish() {
  Statistics& statistics = index_.statistics;
  statistics.schemaCount = static_cast<std::uint16_t>(index_.schemas.size());
  statistics.channelCount = static_cast<std::uint32_t>(index_.channels.size());
  statistics.attachmentCount = static_cast<std::uint32_t>(index_.attachments.size());
  statistics.metadataCount = static_cast<std::uint32_t>(index_.metadata.size());
  statistics.chunkCount =
      static_cast<std::uint32_t>(std::ranges::count(index_.sections, false, &Section::loose));
  for (const auto& [channel, messages] : statistics.channelMessageCounts) {
    if (index_.channels.contains(channel)) continue;
    note(0, 0,
         std::to_string(messages) + " messages of channel " + std::to_string(channel) +
             " cannot be decoded: the channel's description is lost");
  }
  index_.complete = ended_ && index_.damage.empty();
}

}  // namespace

FileIndex indexByScan(const Source& source, const ReadOptions& options) {
  return Scanner(source, options).run();
}

}  // namespace logplayer::mcap
