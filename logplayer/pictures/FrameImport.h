// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "logplayer/base/ImportReport.h"
#include "logplayer/base/ImportSink.h"
#include "logplayer/pictures/FrameSource.h"
#include "robotlink/config/RobotDescription.h"

namespace logplayer {

/// Passes all frames of a source to `sink`: for each the image, the camera's pose and a FrameInfo, as streams
/// of `robot`, at times from 0 on. Frames that cannot be read are left out and reported. Fails if none can be
/// read, if the sink fails, or with "log.given-up" if `progress`, called with the share done in [0, 1],
/// returns false.
robotlink::Result<ImportReport> importFrames(FrameSource& source,
                                             const robotlink::RobotDescription::Camera& camera,
                                             const ImportSink& sink, const std::string& robot,
                                             const std::function<bool(double)>& progress);

}  // namespace logplayer
