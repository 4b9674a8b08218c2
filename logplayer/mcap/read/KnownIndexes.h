// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <tuple>

#include "logplayer/mcap/read/FileIndex.h"

namespace logplayer::mcap {

/// What was found by looking through files that are open, so that whoever opens one of them again need not do
/// it, too: a file without a summary is read to its end for that. Concerns the program as a whole, like the
/// files. Any thread.
class KnownIndexes {
 public:
  static KnownIndexes& all();

  /// Null if nobody has opened this file, as it is now.
  std::shared_ptr<const FileIndex> find(const Source& source, std::size_t maxRecordBytes);
  /// Known as long as somebody holds what is returned.
  std::shared_ptr<const FileIndex> add(const Source& source, std::size_t maxRecordBytes, FileIndex index);

 private:
  using Key = std::pair<Source::Identity, std::size_t>;

  std::mutex mutex_;  // protects what follows
  std::map<Key, std::weak_ptr<const FileIndex>> indexes_;
};

}  // namespace logplayer::mcap
