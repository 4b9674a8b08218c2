// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/SceneState.h"

#include <algorithm>

#include "foxglove/Scene.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/StreamStore.h"

namespace widgets {
namespace {

using robotlink::Pose3;

constexpr char kField[] = "field";

std::string modelOf(const foxglove::SceneEntity& entity) {
  const std::string* model = metadataOf(entity, "model");
  return model == nullptr ? std::string() : *model;
}

std::shared_ptr<const std::string> objectOf(const foxglove::SceneEntity& entity) {
  const std::string* path = metadataOf(entity, "object");
  return path == nullptr ? nullptr : std::make_shared<const std::string>(*path);
}

/// Messages that are published once may be later than the shown instant if that is before the history begins;
/// then the first one counts.
const robotlink::StreamMessage* latestOrFirst(const robotlink::StreamStore& store, const char* path,
                                              robotlink::Instant shown) {
  const auto* message = store.latest(path, shown);
  const auto* stream = store.find(path);
  if (message == nullptr && stream != nullptr && !stream->messages.empty())
    message = &stream->messages.front();
  return message;
}

}  // namespace

const std::string* metadataOf(const foxglove::SceneEntity& entity, const char* key) {
  for (const auto& pair : entity.metadata())
    if (pair.key() == key) return &pair.value();
  return nullptr;
}

void SceneState::update(const robotlink::StreamStore& store, robotlink::Instant shown) {
  updateItems(store, shown);
  const auto* transforms = store.latest(robotlink::streams::kTransforms, shown);
  const auto value = transforms != nullptr ? transforms->value : nullptr;
  if (value != transforms_) {
    transforms_ = value;
    poses_.clear();
    const auto* typed = dynamic_cast<const foxglove::FrameTransforms*>(value.get());
    if (typed != nullptr) updatePoses(*typed);
  }
  tree_.update(store, shown);
  collectModels(store, shown);
}

void SceneState::updateItems(const robotlink::StreamStore& store, robotlink::Instant shown) {
  const auto* newest = latestOrFirst(store, robotlink::streams::kScene, shown);
  const auto value = newest != nullptr ? newest->value : nullptr;
  if (value == newestScene_) return;
  newestScene_ = value;
  items_.clear();
  status_.reset();
  if (newest == nullptr) return;
  for (const auto& message : store.find(robotlink::streams::kScene)->messages) {
    const auto* update = dynamic_cast<const foxglove::SceneUpdate*>(message.value.get());
    if (update != nullptr) apply(*update, message.value);
    if (message.value == value) break;
  }
}

void SceneState::apply(const foxglove::SceneUpdate& update, const robotlink::PackagePtr& keep) {
  for (const auto& deletion : update.deletions()) {
    if (deletion.type() == foxglove::SceneEntityDeletion::ALL) {
      items_.clear();
    } else {
      items_.erase(deletion.id());
    }
  }
  for (const auto& entity : update.entities())
    items_[entity.id()] = {&entity, modelOf(entity), objectOf(entity), keep};
}

/// Parents may follow their children in the message, so the transforms are scanned until no more can be
/// resolved.
void SceneState::updatePoses(const foxglove::FrameTransforms& transforms) {
  std::vector<const foxglove::FrameTransform*> open;
  for (const auto& transform : transforms.transforms()) open.push_back(&transform);
  std::size_t before = 0;
  while (!open.empty() && open.size() != before) {
    before = open.size();
    std::erase_if(open, [&](const foxglove::FrameTransform* transform) {
      const auto parent = framePose(transform->parent_frame_id());
      if (parent) poses_[transform->child_frame_id()] = *parent * poseInParent(*transform);
      return parent.has_value();
    });
  }
}

void SceneState::collectModels(const robotlink::StreamStore& store, robotlink::Instant shown) {
  const auto* message = store.latest(robotlink::streams::kSimulation, shown);
  const auto value = message != nullptr ? message->value : nullptr;
  if (value == status_ && value != nullptr) return;
  status_ = value;
  models_.clear();
  if (const auto* status = dynamic_cast<const robotcontrol::SimulationStatus*>(value.get())) {
    models_.assign(status->models().begin(), status->models().end());
  }
  for (const auto& [id, item] : items_) {
    if (!item.model.empty()) models_.push_back(item.model);
  }
  std::ranges::sort(models_);
  models_.erase(std::unique(models_.begin(), models_.end()), models_.end());
}

std::optional<Pose3> SceneState::framePose(const std::string& frame, const std::string& robot) const {
  const auto found = poses_.find(frame);
  if (found != poses_.end()) return found->second;
  return frame.empty() || frame == kField ? std::optional(Pose3::Identity()) : tree_.pose(robot, frame);
}

std::string SceneState::modelFrame(const std::string& model) const {
  if (poses_.contains(model)) return model;
  for (const auto& [id, item] : items_) {
    if (item.model == model && !model.empty()) return item.entity->frame_id();
  }
  return {};
}

std::optional<Pose3> SceneState::modelPose(const std::string& model) const {
  const std::string frame = modelFrame(model);
  return frame.empty() ? std::nullopt : framePose(frame);
}

}  // namespace widgets
