// SPDX-License-Identifier: GPL-3.0-or-later
// Reader::verify(): reads a whole file and compares it with its index.
#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/read/Reader.h"
#include "logplayer/mcap/read/ReaderParts.h"

namespace logplayer::mcap {
namespace {

constexpr std::uint64_t kVerifiedPiece = 1U << 20U;

/// Reads everything that the index lists and compares it with the index.
class Verification {
 public:
  Verification(const Source& source, FileIndex& index, SectionCache& cache, const Reader::Options& options)
      : source_(source), index_(index), cache_(cache), options_(options) {}

  /// Empty if canceled.
  std::optional<Reader::Readable> run();

 private:
  /// Keyed by channel.
  using Counts = std::map<std::uint16_t, std::uint64_t>;

  bool reportProgress(std::uint64_t done);
  void checkSection(std::size_t number);
  /// The messages in the records of a section, with its message indexes checked.
  Counts countWhole(std::size_t number);
  /// Counts the records that can be found in a chunk whose records end prematurely.
  Counts countBroken(std::size_t number);
  void checkStatistics();
  std::optional<std::uint32_t> dataCrc(std::uint64_t before);
  void note(std::uint64_t offset, std::string what) { index_.damage.push_back({offset, 0, std::move(what)}); }

  const Source& source_;
  FileIndex& index_;
  SectionCache& cache_;
  const Reader::Options& options_;
  Buffer records_;
  Counts counts_;
  Reader::Readable readable_;
};

std::optional<Reader::Readable> Verification::run() {
  const std::size_t before = index_.damage.size();
  std::uint64_t done = 0;
  for (std::size_t i = 0; i < index_.sections.size(); ++i) {
    if (!reportProgress(done)) return std::nullopt;
    checkSection(i);
    done += index_.sections[i].info.length;
  }
  if (index_.damage.size() == before) checkStatistics();
  if (index_.dataEnd == 0 || index_.dataCrc == 0) return readable_;
  const std::optional<std::uint32_t> crc = dataCrc(done);
  if (!crc) return std::nullopt;
  // Damage of records with their own CRC, or inconsistencies, were reported before.
  if (*crc != index_.dataCrc && index_.damage.empty()) {
    note(0, "the CRC of the data section is wrong, because of something outside of the chunks' records");
  }
  return readable_;
}

bool Verification::reportProgress(std::uint64_t done) {
  // If there is a CRC of the whole data, everything is read twice.
  const double all = static_cast<double>(source_.bytes()) * (index_.dataCrc != 0 ? 2 : 1);
  return !options_.progress || options_.progress(std::min(1.0, static_cast<double>(done) / all));
}

void Verification::checkSection(std::size_t number) {
  if (!cache_.readInto(number, records_)) return;
  for (std::size_t next = 1; next <= ReadAhead::kSections; ++next) cache_.expect(number + next);
  const std::uint64_t offset = index_.sections[number].info.offset;
  const bool whole = visitRecords(records_, [&](const RecordView& record, std::size_t) {
    if (record.is(Opcode::kMessage) && !decodeMessage(record.content)) note(offset, "a message is too short");
  });
  for (const auto& [channel, count] : whole ? countWhole(number) : countBroken(number)) {
    counts_[channel] += count;
    readable_.messages += index_.channels.contains(channel) ? count : 0;
    if (!index_.channels.contains(channel)) {
      note(offset, std::to_string(count) + " messages are of the unknown channel " + std::to_string(channel));
    }
  }
  if (!index_.sections[number].loose) ++readable_.chunks;
}

Verification::Counts Verification::countWhole(std::size_t number) {
  const MessageList found = MessageList::fromRecords(records_);
  cache_.compareIndexes(number, found);
  Counts counts;
  for (const MessageList::Channel& channel : found.channels()) counts[channel.id] = channel.count;
  return counts;
}

Verification::Counts Verification::countBroken(std::size_t number) {
  Counts counts;
  for (const MessageRecord& message : cache_.messagesOfBroken(number, records_))
    ++counts[channelOf(records_.data(), message)];
  return counts;
}

void Verification::checkStatistics() {
  const Statistics& stated = index_.statistics;
  bool same = stated.messageCount == readable_.messages;
  for (const auto& [channel, count] : stated.channelMessageCounts) {
    const auto counted = counts_.find(channel);
    same = same && count == (counted == counts_.end() ? 0 : counted->second);
  }
  if (!same) note(0, "the statistics do not count the messages that are in the file");
}

/// Empty if canceled.
std::optional<std::uint32_t> Verification::dataCrc(std::uint64_t before) {
  std::uint32_t crc = 0;
  for (std::uint64_t offset = 0; offset < index_.dataEnd; offset += kVerifiedPiece) {
    if (!reportProgress(before + offset)) return std::nullopt;
    // Fresh memory for each piece would take longer than reading it.
    records_.resize(static_cast<std::size_t>(std::min(kVerifiedPiece, index_.dataEnd - offset)));
    if (source_.read(offset, records_)) crc = crc32(records_, crc);
  }
  return crc;
}

}  // namespace

std::optional<Reader::Readable> Reader::verify() {
  ReaderParts& self = *parts_;
  self.cache.doubtAll();
  self.refit();
  for (const std::string& name : attachmentNames()) {
    if (const auto read = attachment(name); !read) self.index.damage.push_back({0, 0, read.error().text});
  }
  metadata();
  return Verification(self.source, self.index, self.cache, self.options).run();
}

}  // namespace logplayer::mcap
