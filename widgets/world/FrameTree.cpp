// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/FrameTree.h"

#include <algorithm>

#include "foxglove/Geometry.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/StreamStore.h"
#include "widgets/TypedStreams.h"

namespace widgets {

using robotlink::Instant;
using robotlink::Pose3;
using robotlink::StreamMessage;

namespace {

std::optional<Pose3> poseIn(const FrameTree::Frames& frames, const std::string& frame) {
  Pose3 pose = Pose3::Identity();
  const std::string* name = &frame;
  bool isKnown = false;
  for (std::size_t depth = 0; depth <= frames.size(); ++depth) {
    const auto found = frames.find(*name);
    if (found == frames.end()) {
      // The root is known only as a parent.
      const auto isParent = [&](const auto& each) { return each.second.parent == *name; };
      if (!isKnown && std::ranges::none_of(frames, isParent)) return std::nullopt;
      return pose;
    }
    isKnown = true;
    pose = found->second.inParent * pose;
    name = &found->second.parent;
  }
  return std::nullopt;
}

}  // namespace

Pose3 poseInParent(const foxglove::FrameTransform& transform) {
  foxglove::Pose pose;
  *pose.mutable_position() = transform.translation();
  if (transform.has_rotation()) *pose.mutable_orientation() = transform.rotation();
  return robotlink::pose3(pose);
}

std::vector<const foxglove::FrameTransform*> transformsOf(const google::protobuf::Message& message) {
  std::vector<const foxglove::FrameTransform*> found;
  if (const auto* one = dynamic_cast<const foxglove::FrameTransform*>(&message)) found.push_back(one);
  if (const auto* all = dynamic_cast<const foxglove::FrameTransforms*>(&message))
    for (const auto& each : all->transforms()) found.push_back(&each);
  return found;
}

void FrameTree::update(const robotlink::StreamStore& store, Instant shown) {
  if (generation_ != store.generation() ||
      std::ranges::any_of(read_, [&](const auto& each) { return each.second.time > shown; })) {
    generation_ = store.generation();
    trees_.clear();
    read_.clear();
  }
  const std::string& one = foxglove::FrameTransform::descriptor()->full_name();
  const std::string& several = foxglove::FrameTransforms::descriptor()->full_name();
  for (const auto* stream : store.streams()) {
    if (stream->type != one && stream->type != several) continue;
    if (stream->path == robotlink::streams::kTransforms) continue;
    const StreamMessage* newest = store.latest(stream->path, shown);
    if (newest == nullptr) continue;
    Read& read = read_[stream->path];
    if (read.newest == newest->value) continue;
    const auto& messages = stream->messages;
    auto end = std::ranges::upper_bound(messages, shown, {}, &StreamMessage::time);
    auto begin = end - std::min<std::ptrdiff_t>(end - messages.begin(), kMaxMessages);
    if (read.newest != nullptr)
      begin = std::lower_bound(begin, end, read.time, [](const auto& m, Instant t) { return m.time < t; });
    for (; begin != end; ++begin) add(trees_[robotlink::streams::robotOf(stream->path)], begin->value);
    read = {newest->value, newest->time};
  }
}

void FrameTree::add(Frames& frames, const robotlink::PackagePtr& message) {
  for (const auto* transform : transformsOf(*message))
    frames[transform->child_frame_id()] = {transform->parent_frame_id(), poseInParent(*transform)};
}

std::optional<Pose3> FrameTree::pose(const std::string& robot, const std::string& frame) const {
  const auto own = trees_.find(robot), shared = trees_.find(std::string());
  if (own != trees_.end())
    if (auto pose = poseIn(own->second, frame)) return pose;
  if (shared != trees_.end() && shared != own)
    if (auto pose = poseIn(shared->second, frame)) return pose;
  return own == trees_.end() && trees_.size() == 1 ? poseIn(trees_.begin()->second, frame) : std::nullopt;
}

}  // namespace widgets
