// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/MeasuredSpeed.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "foxglove/Geometry.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/StreamStore.h"

namespace widgets {
namespace {

std::optional<robotlink::Pose2> poseOf(const robotlink::StreamMessage& message, const std::string& robot) {
  const auto* transforms = dynamic_cast<const foxglove::FrameTransforms*>(message.value.get());
  if (transforms == nullptr) return {};
  for (const auto& transform : transforms->transforms()) {
    if (transform.child_frame_id() != robot || transform.parent_frame_id() != "field") continue;
    const auto& q = transform.rotation();
    const double heading =
        std::atan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()));
    return robotlink::Pose2{transform.translation().x(), transform.translation().y(), heading};
  }
  return {};
}

/// Whether no robot could have moved that far in that time.
bool isPlaced(const robotlink::Pose2& before, const robotlink::Pose2& after, robotlink::Duration elapsed) {
  constexpr double kFastest = 10, kSlack = 0.05;  // m/s, m
  const double distance = (after.translation() - before.translation()).norm();
  return distance > kFastest * robotlink::seconds(elapsed) + kSlack;
}

}  // namespace

Speed speedBetween(const robotlink::Pose2& before, const robotlink::Pose2& after,
                   robotlink::Duration elapsed) {
  const double seconds = robotlink::seconds(elapsed);
  const double turned = robotlink::normalizedAngle(after.heading - before.heading);
  const double heading = before.heading + turned / 2;
  const double dx = (after.x - before.x) / seconds, dy = (after.y - before.y) / seconds;
  return {std::cos(heading) * dx + std::sin(heading) * dy, -std::sin(heading) * dx + std::cos(heading) * dy,
          turned / seconds};
}

std::optional<Speed> measuredSpeed(const robotlink::StreamStore& store, const std::string& robot,
                                   robotlink::Instant time, robotlink::Duration window) {
  const auto* stream = store.find(robotlink::streams::kTransforms);
  if (stream == nullptr) return {};
  std::optional<robotlink::Pose2> after, before;
  robotlink::Instant afterTime, beforeTime;
  const auto later = std::ranges::upper_bound(stream->messages, time, {}, &robotlink::StreamMessage::time);
  for (auto at = std::make_reverse_iterator(later); at != stream->messages.rend(); ++at) {
    const auto& message = *at;
    const auto pose = poseOf(message, robot);
    if (!pose) continue;
    // A robot that was placed in another pose has not driven there.
    if (before && isPlaced(*pose, *before, beforeTime - message.time)) break;
    if (!after) {
      after = pose;
      afterTime = message.time;
    }
    before = pose;
    beforeTime = message.time;
    if (afterTime - beforeTime >= window) break;
  }
  if (!after || afterTime - beforeTime < window / 2 || afterTime <= beforeTime) return {};
  return speedBetween(*before, *after, afterTime - beforeTime);
}

}  // namespace widgets
