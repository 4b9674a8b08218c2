// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "logplayer/mcap/ChunkLoader.h"

namespace logplayer::mcap {

/// A chunk's section from its head at `offset`, if that may be one: its lengths agree with each other and
/// with the file, its compression is known.
std::optional<Section> chunkAt(SourceWindow& window, const Source& source, std::uint64_t offset);

/// Whether a record may begin at `offset`: its opcode is defined or private, it ends within the file; or the
/// file itself ends there.
bool recordMayBeAt(SourceWindow& window, const Source& source, std::uint64_t offset);

/// Looks for where a damaged file can be read again.
class Resync {
 public:
  Resync(const Source& source, std::size_t maxRecordBytes);

  /// The first place from `offset` on where a chunk begins that can be read, with its CRC if it has one, or
  /// where several records with known channels follow each other, if `loose`. Nothing: there is none, or
  /// `goOn`, which is told every so often how far the search has come, said no.
  std::optional<std::uint64_t> find(std::uint64_t offset, bool loose,
                                    const std::map<std::uint16_t, Channel>& channels,
                                    const std::function<bool(std::uint64_t)>& goOn);
  /// Behind the last byte that is not 0 of what the last search went over; 0: there was none.
  std::uint64_t dataEnd() const { return dataEnd_; }

 private:
  bool chunkBeginsAt(std::uint64_t offset);
  bool messagesBeginAt(std::uint64_t offset, const std::map<std::uint16_t, Channel>& channels);

  const Source& source_;
  ChunkLoader loader_;
  SourceWindow window_;
  Buffer records_;
  std::uint64_t dataEnd_ = 0;
  // What may still be read of chunks that turn out to be none: a file made to look like many of them must not
  // hold us forever.
  std::uint64_t patience_;
};

}  // namespace logplayer::mcap
