// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "logplayer/mcap/read/ChunkLoader.h"

namespace logplayer::mcap {

/// The section of a chunk whose record begins at `offset`, if there can be one: its lengths are consistent
/// with each other and with the file, and its compression is known.
std::optional<Section> chunkAt(SourceWindow& window, const Source& source, std::uint64_t offset);

/// Whether a record may begin at `offset`: its opcode is defined or private and it ends within the file; or
/// the file ends at `offset`.
bool recordMayBeAt(SourceWindow& window, const Source& source, std::uint64_t offset);

/// Finds the place where a damaged file becomes readable again. One thread; the source must outlive this
/// object.
class Resync {
 public:
  Resync(const Source& source, std::size_t maxRecordBytes);

  /// Returns the first offset from `offset` on at which a readable chunk begins (with a correct CRC, if it
  /// has one) or, if `loose`, a sequence of several records with known channels. Empty if there is none, or
  /// `proceed`, called repeatedly with the current offset, returned false.
  std::optional<std::uint64_t> find(std::uint64_t offset, bool loose,
                                    const std::map<std::uint16_t, Channel>& channels,
                                    const std::function<bool(std::uint64_t)>& proceed);
  /// Offset behind the last nonzero byte that the last search visited; 0: there was none.
  std::uint64_t dataEnd() const { return dataEnd_; }

 private:
  /// Whether a chunk at this offset can be loaded completely.
  bool chunkBeginsAt(std::uint64_t offset);
  /// Whether several records with known channels follow each other at this offset.
  bool messagesBeginAt(std::uint64_t offset, const std::map<std::uint16_t, Channel>& channels);

  const Source& source_;
  ChunkLoader loader_;
  SourceWindow window_;
  Buffer records_;
  std::uint64_t dataEnd_ = 0;
  // Number of bytes that may still be decompressed in vain: a malicious file with many fake chunks must not
  // block the search forever.
  std::uint64_t patience_;
};

}  // namespace logplayer::mcap
