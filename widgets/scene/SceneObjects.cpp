// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SceneObjects.h"

#include <algorithm>
#include <cmath>

#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/StreamStore.h"
#include "widgets/world/SceneState.h"

namespace widgets {
namespace {

constexpr std::size_t kMaxLineage = 200;  // a damaged message may have cycles

/// The path above one that is not listed; empty: none.
std::string unlistedParent(const std::string& path) {
  for (const char* part : {"/visual:", "/solid:", "/link:", "/joint:"}) {
    const std::size_t at = path.rfind(part);
    if (at != std::string::npos) return path.substr(0, at);
  }
  const std::size_t slash = path.find('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

}  // namespace

bool SceneObjects::update(const robotlink::StreamStore& store) {
  const auto* stream = store.find(robotlink::streams::kObjects);
  robotlink::PackagePtr value =
      stream == nullptr || stream->messages.empty() ? nullptr : stream->messages.back().value;
  if (value == message_) return false;
  message_ = std::move(value);
  byPath_.clear();
  if (all() == nullptr) return true;
  for (const auto& object : all()->objects()) byPath_.emplace(object.path(), &object);
  return true;
}

const robotcontrol::WorldObjects* SceneObjects::all() const {
  return dynamic_cast<const robotcontrol::WorldObjects*>(message_.get());
}

const robotcontrol::WorldObject* SceneObjects::find(const std::string& path) const {
  const auto found = byPath_.find(path);
  return found == byPath_.end() ? nullptr : found->second;
}

std::vector<std::string> SceneObjects::lineage(const std::string& path) const {
  std::vector<std::string> lineage;
  std::string at = path;
  while (!at.empty() && lineage.size() < kMaxLineage) {
    lineage.push_back(at);
    const auto* object = find(at);
    at = object == nullptr ? unlistedParent(at) : object->parent();
  }
  return lineage;
}

bool SceneObjects::isWithin(const std::string& path, const std::string& ancestor) const {
  const auto above = lineage(path);
  return std::ranges::find(above, ancestor) != above.end();
}

std::optional<robotlink::Pose3> SceneObjects::pose(const std::string& path, const SceneState& scene) const {
  for (const std::string& at : lineage(path)) {
    const auto* object = find(at);
    if (object == nullptr || !object->has_pose_in_frame()) continue;
    if (const auto frame = scene.framePose(object->frame()))
      return *frame * robotlink::pose3(object->pose_in_frame());
  }
  return std::nullopt;
}

const robotcontrol::WorldObject* SceneObjects::cameraOf(const std::string& path) const {
  if (all() == nullptr) return nullptr;
  for (const auto& object : all()->objects()) {
    if (object.has_port() && object.port().type() == "image" && object.has_pose_in_frame() &&
        isWithin(object.path(), path))
      return &object;
  }
  return nullptr;
}

const robotcontrol::WorldProperty* numbersOf(const robotcontrol::WorldObject& object, const char* name) {
  const auto found = std::ranges::find_if(object.properties(), [&](const auto& property) {
    return property.name() == name && property.values_size() > 0;
  });
  return found == object.properties().end() ? nullptr : &*found;
}

std::optional<robotlink::Vector3> vectorOf(const robotcontrol::WorldObject& object, const char* name) {
  const auto* property = numbersOf(object, name);
  if (property == nullptr || property->values_size() != 3) return std::nullopt;
  const robotlink::Vector3 vector(property->values(0), property->values(1), property->values(2));
  return vector.allFinite() ? std::optional(vector) : std::nullopt;
}

std::optional<double> numberOf(const robotcontrol::WorldObject& object, const char* name, int index) {
  const auto* property = numbersOf(object, name);
  if (property == nullptr || index >= property->values_size() || !std::isfinite(property->values(index)))
    return std::nullopt;
  return property->values(index);
}

}  // namespace widgets
