// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <tuple>
#include <type_traits>

#include "logplayer/mcap/FileRecords.h"

// The fields of records in the order in which files have them, for encoding as well as decoding. Messages,
// message indexes and attachments are not among them: they have data whose size counts. Internal to the
// codec.
namespace logplayer::mcap {

/// A record to be read or to be filled in.
template <typename T, typename Record>
concept Fields = std::same_as<std::remove_const_t<T>, Record>;

auto fieldsOf(Fields<Header> auto& r) {
  return std::tie(r.profile, r.library);
}
auto fieldsOf(Fields<Footer> auto& r) {
  return std::tie(r.summaryStart, r.summaryOffsetStart, r.summaryCrc);
}
auto fieldsOf(Fields<Schema> auto& r) {
  return std::tie(r.id, r.name, r.encoding, r.data);
}
auto fieldsOf(Fields<Channel> auto& r) {
  return std::tie(r.id, r.schemaId, r.topic, r.messageEncoding, r.metadata);
}
auto fieldsOf(Fields<ChunkHead> auto& r) {
  return std::tie(r.start, r.end, r.uncompressedBytes, r.uncompressedCrc, r.compression, r.recordsBytes);
}
auto fieldsOf(Fields<ChunkIndex> auto& r) {
  return std::tie(r.start, r.end, r.chunkOffset, r.chunkLength, r.messageIndexOffsets, r.messageIndexLength,
                  r.compression, r.compressedBytes, r.uncompressedBytes);
}
auto fieldsOf(Fields<AttachmentIndex> auto& r) {
  return std::tie(r.offset, r.length, r.logTime, r.createTime, r.dataBytes, r.name, r.mediaType);
}
auto fieldsOf(Fields<Statistics> auto& r) {
  return std::tie(r.messageCount, r.schemaCount, r.channelCount, r.attachmentCount, r.metadataCount,
                  r.chunkCount, r.messageStart, r.messageEnd, r.channelMessageCounts);
}
auto fieldsOf(Fields<Metadata> auto& r) {
  return std::tie(r.name, r.values);
}
auto fieldsOf(Fields<MetadataIndex> auto& r) {
  return std::tie(r.offset, r.length, r.name);
}
auto fieldsOf(Fields<SummaryOffset> auto& r) {
  return std::tie(r.group, r.start, r.length);
}
auto fieldsOf(Fields<DataEnd> auto& r) {
  return std::tie(r.dataCrc);
}

}  // namespace logplayer::mcap
