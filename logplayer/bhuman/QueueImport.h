// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "logplayer/LogImport.h"
#include "logplayer/bhuman/ByteSource.h"
#include "logplayer/bhuman/FrameConverter.h"

namespace logplayer::bhuman {

/// Reads a whole log of a message queue and hands its frames to `sink`. Fails as the sink does, or, where
/// `progress` (the share done) gives up, with the id "log.given-up".
robotlink::Result<ImportReport> importQueue(ByteSource& bytes, const std::string& robot,
                                            const FrameConverter::FrameSink& sink,
                                            const std::function<bool(double)>& progress);

}  // namespace logplayer::bhuman
