// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/ImageEncoding.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

namespace robotlink::websocket {

void ImageEncoding::post(ChannelPtr channel, Instant time, PackagePtr image, const ImageEncoder& encoder) {
  const ServerChannel* const of = channel.get();
  std::optional<Job> leftOut;
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({std::move(channel), time, std::move(image), encoder});
    const auto isOfChannel = [of](const Job& job) { return job.channel.get() == of; };
    if (std::ranges::count_if(waiting_, isOfChannel) > static_cast<std::ptrdiff_t>(kMaxWaiting)) {
      const auto oldest = std::ranges::find_if(waiting_, isOfChannel);
      leftOut = std::move(*oldest);
      waiting_.erase(oldest);
    }
  }
  if (leftOut) leftOut->channel->noteThinned();
  worker_.post({});
}

/// Encodes images until a stop is requested. Posting requests one, too; the rest is done in the next call.
void ImageEncoding::work(const std::stop_token& stop) {
  do {
    std::optional<Job> job;
    {
      const std::lock_guard lock(mutex_);
      if (waiting_.empty()) return;
      job = std::move(waiting_.front());
      waiting_.pop_front();
    }
    if (job->channel->isWanted()) encode(*job);
  } while (!stop.stop_requested());
}

void ImageEncoding::encode(const Job& job) {
  try {
    if (const PackagePtr encoded = job.encoder(*job.image))
      job.channel->publish(job.time, encoded->SerializeAsString());
  } catch (const std::exception&) {
    // Memory ran out, say; the next image may be smaller.
    job.channel->noteThinned();
  }
}

}  // namespace robotlink::websocket
