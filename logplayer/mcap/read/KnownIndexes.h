// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <tuple>

#include "logplayer/mcap/read/FileIndex.h"

namespace logplayer::mcap {

/// The indexes of the files that are open, so that they are not made again when a file is opened twice: a
/// file without a summary must be read to its end. There is one object for the whole program, as files
/// concern it as a whole. Any thread.
class KnownIndexes {
 public:
  static KnownIndexes& all();

  /// Null if this file, as it is now, is not open.
  std::shared_ptr<const FileIndex> find(const Source& source, std::size_t maxRecordBytes);
  /// Known as long as the returned pointer is held.
  std::shared_ptr<const FileIndex> add(const Source& source, std::size_t maxRecordBytes, FileIndex index);

 private:
  using Key = std::pair<Source::Identity, std::size_t>;

  std::mutex mutex_;  // protects indexes_
  std::map<Key, std::weak_ptr<const FileIndex>> indexes_;
};

}  // namespace logplayer::mcap
