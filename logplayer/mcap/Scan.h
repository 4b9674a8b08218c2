// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/FileIndex.h"

namespace logplayer::mcap {

/// Finds out what is in a file without its summary, hopping from record to record. Chunks are decompressed
/// only where they have no message index, or where it tells of channels not yet known. After damage it goes
/// on at the next plausible chunk (or message, where messages lie outside of chunks); what was skipped is in
/// the index's damage. options.progress may give it up.
FileIndex indexByScan(const Source& source, const Reader::Options& options);

}  // namespace logplayer::mcap
