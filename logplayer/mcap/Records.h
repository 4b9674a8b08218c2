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

// The records of an MCAP file as plain values, as the specification at https://mcap.dev/spec names them.
// Times in a file are unsigned 64-bit ns; here they are instants, and the codec takes what does not fit as
// the largest that does.

using robotlink::Instant;
using Bytes = std::span<const std::uint8_t>;

enum class Compression : std::uint8_t { kNone, kLz4, kZstd };

struct Header {
  std::string profile;
  std::string library;
  bool operator==(const Header&) const = default;
};

struct Schema {
  std::uint16_t id = 0;  ///< not 0
  std::string name;
  std::string encoding;  ///< "protobuf"
  std::string data;      ///< for protobuf a serialised FileDescriptorSet
  bool operator==(const Schema&) const = default;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schemaId = 0;  ///< 0: none
  std::string topic;
  std::string messageEncoding;
  std::map<std::string, std::string> metadata;
  bool operator==(const Channel&) const = default;
};

/// A message's fields with a view on its data, which belongs to whoever handed the message out.
struct Message {
  std::uint16_t channelId = 0;
  std::uint32_t sequence = 0;
  Instant logTime;
  Instant publishTime;
  Bytes data;
};

struct Attachment {
  Instant logTime;
  Instant createTime;
  std::string name;
  std::string mediaType;
  std::string data;
  bool operator==(const Attachment&) const = default;
};

struct Metadata {
  std::string name;
  std::map<std::string, std::string> values;
  bool operator==(const Metadata&) const = default;
};

struct Statistics {
  std::uint64_t messageCount = 0;
  std::uint16_t schemaCount = 0;
  std::uint32_t channelCount = 0;
  std::uint32_t attachmentCount = 0;
  std::uint32_t metadataCount = 0;
  std::uint32_t chunkCount = 0;
  Instant messageStart;
  Instant messageEnd;
  std::map<std::uint16_t, std::uint64_t> channelMessageCounts;
  bool operator==(const Statistics&) const = default;
};

}  // namespace logplayer::mcap
