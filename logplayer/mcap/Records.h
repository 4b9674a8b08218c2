// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/base/Clock.h"

namespace logplayer::mcap {

// The content records of an MCAP file as plain values, named as in the specification at
// https://mcap.dev/spec. Times in a file are unsigned 64-bit ns; here they are instants, and the codec clamps
// values out of range.

using robotlink::Instant;
// A view of bytes, not owned.
using Bytes = std::span<const std::uint8_t>;

// The compression of chunks; see compressionName().
enum class Compression : std::uint8_t { kNone, kLz4, kZstd };

// The first record of a file.
struct Header {
  // The conventions that the file follows; may be empty.
  std::string profile;
  // The software that wrote the file.
  std::string library;
  bool operator==(const Header&) const = default;
};

// The type of the messages of a channel.
struct Schema {
  // Not 0.
  std::uint16_t id = 0;
  // For protobuf the full name of the message type.
  std::string name;
  // Encoding of `data`: "protobuf", "jsonschema".
  std::string encoding;
  // For protobuf a serialized FileDescriptorSet.
  std::string data;
  bool operator==(const Schema&) const = default;
};

// A source of messages of one type on one topic.
struct Channel {
  std::uint16_t id = 0;
  // 0: the messages have no schema.
  std::uint16_t schemaId = 0;
  std::string topic;
  // Encoding of the messages: "protobuf", "json", "cdr".
  std::string messageEncoding;
  std::map<std::string, std::string> metadata;
  bool operator==(const Channel&) const = default;
};

/// The fields of a message with a view of its data, which belongs to the source of the message.
struct Message {
  std::uint16_t channelId = 0;
  // Set by the writer; this program stores the lower 32 bits of the frame number.
  std::uint32_t sequence = 0;
  // When it was recorded; the order of messages.
  Instant logTime;
  // When it was published.
  Instant publishTime;
  Bytes data;
};

// A file embedded in the log.
struct Attachment {
  Instant logTime;
  // Modification time of the original file.
  Instant createTime;
  std::string name;
  // MIME type.
  std::string mediaType;
  std::string data;
  bool operator==(const Attachment&) const = default;
};

// Named pairs of keys and values.
struct Metadata {
  std::string name;
  std::map<std::string, std::string> values;
  bool operator==(const Metadata&) const = default;
};

// The numbers of records in a file.
struct Statistics {
  std::uint64_t messageCount = 0;
  std::uint16_t schemaCount = 0;
  std::uint32_t channelCount = 0;
  std::uint32_t attachmentCount = 0;
  std::uint32_t metadataCount = 0;
  std::uint32_t chunkCount = 0;
  // Times of the earliest and the latest message; 0 without messages.
  Instant messageStart;
  Instant messageEnd;
  // Number of messages by channel id.
  std::map<std::uint16_t, std::uint64_t> channelMessageCounts;
  bool operator==(const Statistics&) const = default;
};

}  // namespace logplayer::mcap
