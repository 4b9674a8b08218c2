// SPDX-License-Identifier: GPL-3.0-or-later
// ReaderParts: adapts the index to chunks that turn out to differ from it.
#include <algorithm>

#include "logplayer/mcap/read/ReaderParts.h"

namespace logplayer::mcap {

void ReaderParts::listChunks() {
  chunks.clear();
  for (const Section& section : index.sections) {
    if (!section.loose) chunks.push_back(section.info);
  }
}

bool ReaderParts::refit() {
  if (refitted || !cache.misfit()) return false;
  refitted = true;
  ReadOptions silent = options;
  silent.progress = nullptr;  // the object of the callback may no longer exist
  std::optional<FileIndex> found = betterByScan(source, index, silent);
  if (!found) return false;
  // Damage at places where there is no chunk is not damage of the file.
  std::erase_if(index.damage, [&](const Damage& damage) {
    return std::ranges::any_of(index.sections, [&](const Section& section) {
      return (section.info.offset == damage.offset || section.indexOffset == damage.offset) &&
             !chunkIsThere(source, section, options.maxRecordBytes);
    });
  });
  found->damage.insert(found->damage.end(), index.damage.begin(), index.damage.end());
  // Users hold references to elements of these maps.
  index.schemas.merge(found->schemas);
  index.channels.merge(found->channels);
  index.statistics = std::move(found->statistics);
  index.sections = std::move(found->sections);
  index.attachments = std::move(found->attachments);
  index.metadata = std::move(found->metadata);
  index.damage = std::move(found->damage);
  index.complete = index.bySummary = false;
  metadata.reset();
  listChunks();
  cache.reset();
  return true;
}

}  // namespace logplayer::mcap
