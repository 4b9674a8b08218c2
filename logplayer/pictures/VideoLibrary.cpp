// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/pictures/VideoLibrary.h"

#include "robotlink/base/OptionalModule.h"

namespace logplayer {

const VideoLibrary& videoLibrary() {
  static const VideoLibrary kLoaded = [] {
    robotlink::OptionalModule module("robotcontrol_video.so");
    VideoLibrary loaded{module.function<OpenVideo>(kOpenVideo), module.function<CreateVideo>(kCreateVideo),
                        module.problem()};
    return loaded.problem.empty() ? loaded : VideoLibrary{nullptr, nullptr, loaded.problem};
  }();
  return kLoaded;
}

}  // namespace logplayer
