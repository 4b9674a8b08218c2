// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/read/FileIndex.h"

namespace logplayer::mcap {

/// Builds the index of a file without its summary, from record to record. Chunks are decompressed only if
/// they have no message index, or if it refers to channels that are not yet known. After damage the scan
/// continues at the next plausible chunk (or message, if messages lie outside of chunks); skipped places are
/// in the index's damage. Canceled if options.progress returns false; see FileIndex::givenUp.
FileIndex indexByScan(const Source& source, const ReadOptions& options);

}  // namespace logplayer::mcap
