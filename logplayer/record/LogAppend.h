// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

#include "logplayer/mcap/write/Writer.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// Appends to a complete log what `write` writes. If that fails, for example because the disk is full, the
/// original end of the log is restored. A signal that ends the program meanwhile ends it after this.
robotlink::Result<void> appendToLog(const std::filesystem::path& log,
                                    const std::function<robotlink::Result<void>(mcap::Writer&)>& write);

}  // namespace logplayer
