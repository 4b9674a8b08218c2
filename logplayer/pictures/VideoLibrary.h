// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "logplayer/pictures/VideoModule.h"

namespace logplayer {

/// The functions of the video module. Both are null, and `problem` says why, if it could not be loaded.
struct VideoLibrary {
  OpenVideo open = nullptr;
  CreateVideo create = nullptr;
  std::string problem;
};

/// Loads the module at the first call; it is never unloaded. Any thread.
const VideoLibrary& videoLibrary();

}  // namespace logplayer
