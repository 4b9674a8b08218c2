// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <cstdlib>

#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/read/ChunkLoader.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/logplayer/fuzz/McapSeeds.h"

namespace mcap_codec_fuzz {

// The input is records one after the other. What is decoded must be decoded the same after it was encoded.
using namespace logplayer::mcap;

namespace {

template <typename Record>
void checkAgain(const std::optional<Record>& record, std::optional<Record> (*decode)(Bytes)) {
  if (!record) return;
  Buffer encoded;
  encode(encoded, *record);
  const std::optional<RecordView> view = firstRecord(encoded);
  if (view && decode(view->content) == record) return;
  std::fputs("a record changes when it is encoded\n", stderr);
  std::abort();
}

void checkAttachment(Bytes content) {
  const auto decoded = decodeAttachment(content);
  if (!decoded) return;
  Buffer encoded;
  encode(encoded, decoded->attachment);
  const auto again = decodeAttachment(firstRecord(encoded)->content);
  if (again && again->crcFits && again->attachment == decoded->attachment) return;
  std::fputs("an attachment changes when it is encoded\n", stderr);
  std::abort();
}

void checkMessage(Bytes content) {
  const auto message = decodeMessage(content);
  if (!message) return;
  Buffer encoded;
  encode(encoded, *message);
  if (encoded.size() == kRecordHeadBytes + content.size()) return;
  std::fputs("a message changes its size when it is encoded\n", stderr);
  std::abort();
}

void check(const RecordView& record) {
  const Bytes content = record.content;
  switch (static_cast<Opcode>(record.opcode)) {
    case Opcode::kHeader:
      return checkAgain(decode<Header>(content), &decode<Header>);
    case Opcode::kFooter:
      return checkAgain(decode<Footer>(content), &decode<Footer>);
    case Opcode::kSchema:
      return checkAgain(decode<Schema>(content), &decode<Schema>);
    case Opcode::kChannel:
      return checkAgain(decode<Channel>(content), &decode<Channel>);
    case Opcode::kMessage:
      return checkMessage(content);
    case Opcode::kMessageIndex:
      return checkAgain(decodeMessageIndex(content), &decodeMessageIndex);
    case Opcode::kChunkIndex:
      return checkAgain(decode<ChunkIndex>(content), &decode<ChunkIndex>);
    case Opcode::kAttachment:
      return checkAttachment(content);
    case Opcode::kAttachmentIndex:
      return checkAgain(decode<AttachmentIndex>(content), &decode<AttachmentIndex>);
    case Opcode::kStatistics:
      return checkAgain(decode<Statistics>(content), &decode<Statistics>);
    case Opcode::kMetadata:
      return checkAgain(decode<Metadata>(content), &decode<Metadata>);
    case Opcode::kMetadataIndex:
      return checkAgain(decode<MetadataIndex>(content), &decode<MetadataIndex>);
    case Opcode::kSummaryOffset:
      return checkAgain(decode<SummaryOffset>(content), &decode<SummaryOffset>);
    case Opcode::kDataEnd:
      return checkAgain(decode<DataEnd>(content), &decode<DataEnd>);
    case Opcode::kChunk:
      if (const auto head = decode<ChunkHead>(content)) {
        visitRecords(content.subspan(chunkHeadBytes(head->compression.size())),
                     [](const RecordView& inner, std::size_t) { check(inner); });
      }
      return;
  }
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  visitRecords({data, size}, [](const RecordView& record, std::size_t) { check(record); });
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds = mcapSeeds();
  for (std::string& seed : seeds) seed.erase(0, sizeof kMagic);
  return seeds;
}

const FuzzRegistration kTarget({"mcap_codec", &fuzzSeeds, &runInput});

}  // namespace mcap_codec_fuzz
