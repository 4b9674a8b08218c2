// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "logplayer/mcap/Scan.h"

namespace logplayer::mcap {

robotlink::Result<FileIndex> readIndex(const Source& source, const Reader::Options& options) {
  auto index = indexBySummary(source, options.maxRecordBytes);
  if (index) return std::move(*index);

  FileIndex scanned = indexByScan(source, options);
  if (scanned.givenUp) {
    return robotlink::failure("log.given-up", "given up while it was looked through", {source.file().string(), 0, 0});
  }
  if (const std::string& damage = index.error().damage; !damage.empty()) {
    scanned.complete = false;
    scanned.damage.insert(scanned.damage.begin(), {0, 0, damage});
  }
  const bool nothing = scanned.sections.empty() && scanned.channels.empty() && scanned.attachments.empty();
  if (nothing && !std::ranges::equal(source.read(0, sizeof kMagic), kMagic)) {
    return robotlink::failure("mcap.none", "this is not an MCAP file, or nothing of it is left",
                              {source.file().string(), 0, 0});
  }
  return scanned;
}

}  // namespace logplayer::mcap
