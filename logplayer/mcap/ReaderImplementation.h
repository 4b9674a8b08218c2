// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/SectionCache.h"
#include "logplayer/mcap/Walk.h"

namespace logplayer::mcap {

/// The members of a Reader. They refer to each other, so that the object must not move.
struct Reader::Implementation {
  Implementation(Source from, Options choices, FileIndex found)
      : options(std::move(choices)),
        source(std::move(from)),
        index(std::move(found)),
        cache(source, index, options),
        forward(Walk::Direction::kForward, index, cache),
        backward(Walk::Direction::kBackward, index, cache),
        newest(Walk::Direction::kBackward, index, cache) {
    listChunks();
  }

  /// Fills chunks from the index.
  void listChunks();
  /// If the summary has turned out to be inconsistent with the file, replaces the index by that of a scan; at
  /// most once. Returns whether the index was replaced.
  bool refit();
  /// Null if no section begins at this offset.
  const Section* sectionAt(std::uint64_t offset);
  /// Advances a walk, and repeats the step if the index had to be replaced.
  std::optional<MessagePosition> step(Walk& walk, const MessagePosition& than,
                                      const std::vector<std::uint16_t>& channelIds);
  robotlink::Result<MessageData> read(const MessagePosition& position);
  /// An error with the place in the file.
  tl::unexpected<robotlink::Error> problem(const char* id, std::uint64_t offset,
                                           const std::string& what) const {
    return robotlink::failure(id, what + " (at byte " + std::to_string(offset) + ")",
                              {source.file().string(), 0, 0});
  }

  Options options;
  Source source;
  FileIndex index;
  SectionCache cache;
  /// Positions of next() and previous().
  Walk forward, backward;
  /// For latest(), so that it does not disturb previous().
  Walk newest;
  std::vector<ChunkInfo> chunks;
  /// Empty until it is read.
  std::optional<std::vector<Metadata>> metadata;
  /// Whether refit() was tried.
  bool refitted = false;
  /// The last result of sectionAt(), where the search begins.
  std::size_t lastSection = 0;
};

}  // namespace logplayer::mcap
