// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/Trails.h"

#include <algorithm>

#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/StreamStore.h"

namespace widgets {
namespace {

using robotlink::Duration;
using robotlink::Instant;

constexpr Duration kShortest = std::chrono::milliseconds(100);  // between two places
constexpr int kMaxPlaces = 300;

Duration stepFor(Duration reach) {
  return std::max(kShortest, Duration(reach / kMaxPlaces));
}

}  // namespace

void Trails::setReach(Duration reach) {
  if (reach == reach_) return;
  reach_ = reach;
  clear();
}

void Trails::update(const robotlink::StreamStore& store, const Sources& sources, Instant shown) {
  const Duration step = stepFor(reach_);
  if (sources != sources_ || store.generation() != generation_) {
    places_.clear();
    sources_ = sources;
    generation_ = store.generation();
  }
  if (places_.empty() || shown < last_ || shown - last_ > reach_) {
    places_.clear();
    last_ = std::max(shown - reach_, Instant());
  }
  for (Instant at = last_ + step; at <= shown; at += step) {
    add(store, sources, at);
    last_ = at;
  }
}

void Trails::addPlace(const std::string& model, const robotlink::Vector2& place) {
  auto& places = places_[model];
  places.push_back(place);
  if (places.size() > static_cast<std::size_t>(reach_ / stepFor(reach_))) places.pop_front();
}

void Trails::addBall(const robotlink::StreamStore& store, const std::string& model, const BallSource& source,
                     Instant at) {
  const auto* pose = store.latestAs<robotcontrol::RobotPose>(source.pose, at);
  const auto* ball = store.latestAs<robotcontrol::BallModel>(source.ball, at);
  if (pose == nullptr || ball == nullptr || !ball->known()) return;
  addPlace(model, robotlink::pose2(pose->robot_in_field()) * robotlink::vector2(ball->position_in_robot()));
}

/// Models are direct children of the field's frame, so there is no tree to be walked.
void Trails::add(const robotlink::StreamStore& store, const Sources& sources, Instant at) {
  for (const auto& [robot, path] : sources.estimates) {
    const auto* pose = store.latestAs<robotcontrol::RobotPose>(path, at);
    if (pose != nullptr) addPlace(robot, robotlink::pose2(pose->robot_in_field()).translation());
  }
  for (const auto& [model, source] : sources.balls) addBall(store, model, source, at);
  const auto* transforms = store.latestAs<foxglove::FrameTransforms>(robotlink::streams::kTransforms, at);
  if (transforms == nullptr) return;
  for (const auto& transform : transforms->transforms()) {
    const auto model = sources.frames.find(transform.child_frame_id());
    if (model != sources.frames.end())
      addPlace(model->second, {transform.translation().x(), transform.translation().y()});
  }
}

}  // namespace widgets
