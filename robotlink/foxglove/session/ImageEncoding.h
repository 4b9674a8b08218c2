// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <variant>

#include "robotlink/base/Worker.h"
#include "robotlink/foxglove/server/ServerChannel.h"
#include "robotlink/process/Link.h"

namespace robotlink::websocket {

/// Makes a foxglove.CompressedImage of a foxglove.RawImage; null: it cannot. Any thread.
using ImageEncoder = std::function<PackagePtr(const google::protobuf::Message& image)>;

/// Encodes images for slow links, and publishes them, in a separate thread: the owner of an image never
/// waits for that. Images of a channel keep their order. Where images come faster than they are encoded, the
/// oldest of a channel are left out, and count as thinned for its subscribers. Functions may be called from
/// any thread.
class ImageEncoding {
 public:
  /// How many images of a channel wait at most, so that images that arrive together are all encoded.
  static constexpr std::size_t kMaxWaiting = 4;

  /// Encodes an image for a channel that has subscribers.
  void post(ChannelPtr channel, Instant time, PackagePtr image, const ImageEncoder& encoder);
  /// Blocks until nothing waits.
  void finish() { worker_.finish(); }

 private:
  struct Job {
    ChannelPtr channel;
    Instant time;
    PackagePtr image;
    ImageEncoder encoder;
  };

  void work(const std::stop_token& stop);
  static void encode(const Job& job);

  /// Protects the jobs.
  std::mutex mutex_;
  std::deque<Job> waiting_;
  Worker<std::monostate> worker_{[this](std::monostate, const std::stop_token& stop) { work(stop); }};
};

}  // namespace robotlink::websocket
