// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/KnownIndexes.h"

namespace logplayer::mcap {

KnownIndexes& KnownIndexes::all() {
  static KnownIndexes indexes;
  return indexes;
}

std::shared_ptr<const FileIndex> KnownIndexes::find(const Source& source, std::size_t maxRecordBytes) {
  const std::lock_guard lock(mutex_);
  const auto found = indexes_.find({source.identity(), maxRecordBytes});
  return found == indexes_.end() ? nullptr : found->second.lock();
}

std::shared_ptr<const FileIndex> KnownIndexes::add(const Source& source, std::size_t maxRecordBytes,
                                                   FileIndex index) {
  auto shared = std::make_shared<const FileIndex>(std::move(index));
  const std::lock_guard lock(mutex_);
  std::erase_if(indexes_, [](const auto& entry) { return entry.second.expired(); });
  indexes_[{source.identity(), maxRecordBytes}] = shared;
  return shared;
}

}  // namespace logplayer::mcap
