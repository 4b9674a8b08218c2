// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "logplayer/mcap/Records.h"

// The values that a Reader takes and returns. Plain values.
namespace logplayer::mcap {

/// A part of a file that could not be read.
struct Damage {
  /// The offset in the file at which the damage begins.
  std::uint64_t offset = 0;
  /// Number of bytes that were skipped, without zeros at the end of the file.
  std::uint64_t bytes = 0;
  /// A sentence for the user.
  std::string what;
  /// Number of chunks that were lost here, as far as known.
  std::uint64_t chunks = 0;
};

/// The position of a message: sufficient to read it and to compare the order of messages. Positions are
/// ordered by time; equal times by the order in the file.
struct MessagePosition {
  Instant time;
  /// Offset of the chunk in the file.
  std::uint64_t chunkOffset = 0;
  /// Offset within the chunk's decompressed records.
  std::uint64_t offset = 0;
  std::uint16_t channelId = 0;
  /// Positions are ordered by time, equal times as in the file.
  auto operator<=>(const MessagePosition&) const = default;
};

/// Limits and callbacks of a Reader.
struct ReadOptions {
  /// Maximum size of the decompressed chunks in the cache.
  std::size_t cacheBytes = 64U << 20U;
  /// Larger chunks, attachments and records are not read, whatever size they claim.
  std::size_t maxRecordBytes = 1U << 30U;
  /// Called repeatedly during a scan with the share done in [0, 1]; false cancels it with the error
  /// "log.given-up".
  std::function<bool(double)> progress;
};

/// Position, size and times of a chunk.
struct ChunkInfo {
  /// Offset of its record in the file.
  std::uint64_t offset = 0;
  /// Size of its record, including opcode and length.
  std::uint64_t length = 0;
  Instant start, end;
  Compression compression = Compression::kNone;
  std::uint64_t compressedBytes = 0;
  std::uint64_t uncompressedBytes = 0;
  /// Number of messages, as far as known.
  std::uint64_t messages = 0;
};

/// A message that keeps alive the chunk to which its data refers.
struct MessageData {
  Message message;
  std::shared_ptr<const std::vector<std::uint8_t>> owner;
};

}  // namespace logplayer::mcap
