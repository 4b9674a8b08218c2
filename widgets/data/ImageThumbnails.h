// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <map>
#include <string>

#include "robotlink/process/Link.h"

namespace widgets {

/// Small pictures of the images in streams, each made when it is painted and kept until the stream has
/// another image; remade a few times a second at most. GUI thread.
class ImageThumbnails {
 public:
  /// Call this in each tick, 30 times a second.
  void tick() { ++ticks_; }
  /// Null if the message is no image, or one that cannot be read. `height` in pixels.
  QImage of(const std::string& stream, const robotlink::PackagePtr& message, int height);
  /// Forgets all.
  void clear() { kept_.clear(); }

 private:
  struct Kept {
    /// Keeps the message alive, so that no other one has its address.
    robotlink::PackagePtr message;
    QImage image;
    std::uint64_t madeAt = 0;
  };
  std::map<std::string, Kept> kept_;
  std::uint64_t ticks_ = 0;
};

/// The image in a message in its full size; null if it is not an image.
QImage imageOf(const google::protobuf::Message& message);

}  // namespace widgets
