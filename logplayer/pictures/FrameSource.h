// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/process/Link.h"

namespace logplayer {

/// Images one after the other, such as those of a video file. One thread.
class FrameSource {
 public:
  struct Frame {
    /// The time since the first frame.
    robotlink::Duration time{};
    /// A foxglove.RawImage or foxglove.CompressedImage, with this time as its timestamp.
    robotlink::PackagePtr image = {};
    /// Pixels.
    int width = 0, height = 0;
  };

  virtual ~FrameSource() = default;
  /// Returns the format of the source, for users: "video".
  virtual std::string format() const = 0;
  /// The next frame; empty at the end. Fails if it cannot be read; later ones may be readable.
  virtual robotlink::Result<std::optional<Frame>> next() = 0;
  /// The share that was read, 0 to 1.
  virtual double share() const = 0;
};

}  // namespace logplayer
