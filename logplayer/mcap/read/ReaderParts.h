// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/MessageRecords.h"
#include "logplayer/mcap/read/KnownIndexes.h"
#include "logplayer/mcap/read/SectionCache.h"
#include "logplayer/mcap/read/Walk.h"

namespace logplayer::mcap {

/// The members of a Reader, for its sources and those of MessageCursor alone. They refer to each other, so
/// that the object must not move.
struct ReaderParts {
  /// `shared`: what is known of the file to others, too; may be null.
  ReaderParts(Source from, ReadOptions choices, FileIndex found, std::shared_ptr<const FileIndex> shared)
      : options(std::move(choices)),
        source(std::move(from)),
        known(std::move(shared)),
        index(std::move(found)),
        cache(source, index, options),
        forward(Walk::Direction::kForward, index, cache),
        backward(Walk::Direction::kBackward, index, cache),
        newest(Walk::Direction::kBackward, index, cache) {
    listChunks();
  }

  /// Fills chunks from the index.
  void listChunks();
  ChannelSet knownChannels() const;
  /// If it has turned out that the summary does not fit the file, looks through the file instead, once. True:
  /// the index is another one now.
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

  ReadOptions options;
  Source source;
  const std::shared_ptr<const FileIndex> known;
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
