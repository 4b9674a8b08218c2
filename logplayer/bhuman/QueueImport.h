// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "logplayer/base/ImportReport.h"
#include "logplayer/bhuman/ByteSource.h"
#include "logplayer/bhuman/FrameConverter.h"

namespace logplayer::bhuman {

/// Reads a whole log of a message queue and passes its frames to `sink`. Fails if the sink fails, or with
/// "log.given-up" if `progress`, called with the share done in [0, 1], returns false.
robotlink::Result<ImportReport> importQueue(ByteSource& bytes, const std::string& robot,
                                            const FrameConverter::FrameSink& sink,
                                            const std::function<bool(double)>& progress);

}  // namespace logplayer::bhuman
