// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <variant>
#include <vector>

#include "logplayer/mcap/Codec.h"

namespace logplayer::mcap::test {

/// A message that owns its data.
struct OwnedMessage {
  std::uint16_t channelId = 0;
  std::uint32_t sequence = 0;
  std::uint64_t logTime = 0;
  std::uint64_t publishTime = 0;
  std::string data;
  bool operator==(const OwnedMessage&) const = default;

  Message view() const;
  static OwnedMessage of(const Message& message);
};

using Record = std::variant<Header, Footer, Schema, Channel, OwnedMessage, ChunkIndex, Attachment,
                            AttachmentIndex, Statistics, Metadata, MetadataIndex, SummaryOffset, DataEnd>;

/// One file of the MCAP project's conformance suite, as described by its expected results.
///
/// Features: ch all in a chunk, mx message indexes, st statistics, rsh and rch schemas and channels repeated
/// in the summary, ax, mdx and chx indexes of attachments, metadata and chunks, sum summary offsets, pad
/// unknown bytes behind the content of records.
struct ConformanceCase {
  std::string name;
  std::set<std::string> features;
  /// In the order of the file, those of a chunk at its place; chunks and message indexes themselves are
  /// omitted.
  std::vector<Record> records;

  bool has(const std::string& feature) const { return features.contains(feature); }
};

/// Parses the JSON text of the expected results.
std::vector<ConformanceCase> conformanceCases(const std::string& json);

/// The file of a case, written from its schemas, channels, messages, attachments and metadata only;
/// everything else, including CRCs, is computed.
Buffer writtenBy(const ConformanceCase& conformance);

/// All records of a file, as in ConformanceCase; empty if something cannot be decoded.
std::optional<std::vector<Record>> recordsIn(Bytes file);

}  // namespace logplayer::mcap::test
