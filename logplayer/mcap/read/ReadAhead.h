// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "logplayer/mcap/MessageRecords.h"
#include "logplayer/mcap/read/ChunkLoader.h"

namespace logplayer::mcap {

/// Loads the sections that will be requested next in threads of its own, while the current one is visited.
/// The threads are started by the first sections that are worth it. Each holds one section of at most
/// `maxBytes`, and the list of its messages. The source must outlive this object, whose functions are for one
/// thread.
class ReadAhead {
 public:
  /// How many sections are loaded at the same time, so that decompressing is faster, too.
  static constexpr std::size_t kSections = 2;
  /// The result of ChunkLoader::load().
  using Outcome = tl::expected<void, std::string>;

  ReadAhead(const Source& source, std::size_t maxRecordBytes, std::size_t maxBytes);
  ~ReadAhead();
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// Begins to load a section, in place of the one that was begun kSections ago. Ignored if that is not done,
  /// or if this section is too small or too large. `listed`: the channels whose messages are listed, too, if
  /// not null.
  void begin(std::size_t number, const Section& section, std::shared_ptr<const ChannelSet> listed = nullptr);
  /// The outcome of loading a section; waits for it if necessary. Its records are exchanged for those in
  /// `records`, whose memory is reused, and so is the list of its messages for `listing`, if it is not null
  /// and its channels are those listed. Empty if this section is not being loaded.
  std::optional<Outcome> take(std::size_t number, Buffer& records, Listing* listing = nullptr);
  /// Call this when sections have got other numbers.
  void forget();

 private:
  struct Place;
  /// Null if nothing of this number was begun.
  Place* find(std::size_t number);

  const Source& source_;
  const std::size_t maxRecordBytes_, maxBytes_;
  /// Null until they are needed.
  std::array<std::unique_ptr<Place>, kSections> places_;
  /// The one that is used next.
  std::size_t next_ = 0;
};

}  // namespace logplayer::mcap
