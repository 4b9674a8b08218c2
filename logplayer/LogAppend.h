// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

#include "logplayer/mcap/Writer.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// Appends to a complete log what `write` writes. If that fails, because the disk is full, say, the log gets
/// back the end that it had.
robotlink::Result<void> appendToLog(const std::filesystem::path& log,
                                    const std::function<robotlink::Result<void>(mcap::Writer&)>& write);

}  // namespace logplayer
