// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/Summary.h"

#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/RecordBytes.h"

namespace logplayer::mcap {
namespace {

/// Encodes groups of records of the same type and stores their offsets.
class Groups {
 public:
  Groups(Buffer& out, std::uint64_t start) : out_(out), start_(start) {}

  template <typename Encode>
  void add(Opcode opcode, Encode encodeAll) {
    const std::size_t before = out_.size();
    encodeAll();
    if (out_.size() != before) offsets_.push_back({opcode, start_ + before, out_.size() - before});
  }
  const std::vector<SummaryOffset>& offsets() const { return offsets_; }

 private:
  Buffer& out_;
  std::uint64_t start_;
  std::vector<SummaryOffset> offsets_;
};

template <typename Record, typename Add>
bool added(Bytes content, Add add) {
  auto record = decode<Record>(content);
  if (record) add(std::move(*record));
  return record.has_value();
}

bool addRecord(Summary& summary, const RecordView& record) {
  const Bytes content = record.content;
  const auto append = [](auto& to) { return [&to](auto&& index) { to.push_back(std::move(index)); }; };
  const auto addById = [](auto& to) { return [&to](auto&& one) { to.emplace(one.id, std::move(one)); }; };
  switch (static_cast<Opcode>(record.opcode)) {
    case Opcode::kSchema:
      return added<Schema>(content, addById(summary.schemas));
    case Opcode::kChannel:
      return added<Channel>(content, addById(summary.channels));
    case Opcode::kStatistics:
      summary.hasStatistics = true;
      return added<Statistics>(content, [&](Statistics&& s) { summary.statistics = std::move(s); });
    case Opcode::kChunkIndex:
      return added<ChunkIndex>(content, append(summary.chunks));
    case Opcode::kAttachmentIndex:
      return added<AttachmentIndex>(content, append(summary.attachments));
    case Opcode::kMetadataIndex:
      return added<MetadataIndex>(content, append(summary.metadata));
    default:
      return true;
  }
}

}  // namespace

Buffer encodeEnd(const Summary& summary, std::uint64_t start, bool crc) {
  Buffer out;
  Groups groups(out, start);
  const auto addAll = [&](Opcode opcode, const auto& records) {
    groups.add(opcode, [&] {
      for (const auto& record : records) encode(out, record);
    });
  };
  const auto addValues = [&](Opcode opcode, const auto& records) {
    groups.add(opcode, [&] {
      for (const auto& [id, record] : records) encode(out, record);
    });
  };
  addValues(Opcode::kSchema, summary.schemas);
  addValues(Opcode::kChannel, summary.channels);
  groups.add(Opcode::kStatistics, [&] { encode(out, summary.statistics); });
  addAll(Opcode::kMetadataIndex, summary.metadata);
  addAll(Opcode::kAttachmentIndex, summary.attachments);
  addAll(Opcode::kChunkIndex, summary.chunks);
  const std::uint64_t offsetStart = start + out.size();
  for (const SummaryOffset& offset : groups.offsets()) encode(out, offset);

  encode(out, Footer{start, offsetStart, 0});
  if (crc) {
    std::uint8_t* const field = out.data() + out.size() - 4;
    storeNumber(field, crc32(Bytes(out).first(out.size() - 4)));
  }
  out.insert(out.end(), std::begin(kMagic), std::end(kMagic));
  return out;
}

std::optional<Summary> decodeSummary(Bytes records) {
  Summary summary;
  while (!records.empty()) {
    const std::optional<RecordView> record = firstRecord(records);
    if (!record || !addRecord(summary, *record)) return std::nullopt;
    records = records.subspan(record->bytes());
  }
  return summary;
}

}  // namespace logplayer::mcap
