// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/Trails.h"

#include <algorithm>

#include "foxglove/Geometry.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/StreamStore.h"

namespace widgets {
namespace {

using robotlink::Duration;
using robotlink::Instant;

constexpr Duration kStep = std::chrono::milliseconds(100);
constexpr std::size_t kPlaces = 100;

}  // namespace

void Trails::update(const robotlink::StreamStore& store, const Frames& models, Instant shown) {
  const Duration reach = kStep * static_cast<int>(kPlaces);
  if (places_.empty() || shown < last_ || shown - last_ > reach) {
    places_.clear();
    last_ = std::max(shown - reach, Instant());
  }
  for (Instant at = last_ + kStep; at <= shown; at += kStep) {
    add(store, models, at);
    last_ = at;
  }
}

/// Models are children of the field itself, so no tree needs to be walked here.
void Trails::add(const robotlink::StreamStore& store, const Frames& models, Instant at) {
  const auto* transforms = store.latestAs<foxglove::FrameTransforms>(robotlink::streams::kTransforms, at);
  if (transforms == nullptr) return;
  for (const auto& transform : transforms->transforms()) {
    const auto model = models.find(transform.child_frame_id());
    if (model == models.end()) continue;
    auto& places = places_[model->second];
    places.emplace_back(transform.translation().x(), transform.translation().y());
    if (places.size() > kPlaces) places.pop_front();
  }
}

}  // namespace widgets
