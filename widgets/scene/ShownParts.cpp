// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/ShownParts.h"

#include <algorithm>

namespace widgets {

bool ShownParts::update(const robotlink::StreamStore& store) {
  if (!objects_.update(store)) return false;
  forgetFound();
  return true;
}

ObjectLooks& ShownParts::changeLooks() {
  forgetFound();
  return looks_;
}

void ShownParts::setOnly(const std::string& path) {
  only_ = path;
  forgetFound();
}

void ShownParts::forgetFound() {
  found_.clear();
  ++revision_;
}

std::optional<ObjectLook> ShownParts::lookOf(const std::string& path) const {
  if (only_.empty() && looks_.empty()) return ObjectLook{.isShown = true};
  if (!only_.empty() && !objects_.isWithin(path, only_)) return std::nullopt;
  const ObjectLook look = looks_.of(path, objects_);
  return *look.isShown ? std::optional(look) : std::nullopt;
}

std::optional<ObjectLook> ShownParts::lookOf(const SceneBody& body) {
  // For robots that no scene shows, and in old logs, only the model is known.
  if (!body.object) return lookOf(body.model);
  const auto [found, isNew] = found_.try_emplace(body.object);
  if (isNew) found->second = lookOf(*body.object);
  return found->second;
}

bool ShownParts::isShown(const std::string& path) const {
  return lookOf(path).has_value();
}

void ShownParts::apply(std::vector<SceneBody>& bodies, Surface usual) {
  if (only_.empty() && looks_.empty()) {
    if (usual != Surface::kShaded)
      for (SceneBody& body : bodies) body.surface = usual;
    return;
  }
  std::erase_if(bodies, [&](SceneBody& body) {
    const auto look = lookOf(body);
    if (!look) return true;
    body.surface = look->surface.value_or(usual);
    body.opacity = look->opacity.value_or(1);
    return false;
  });
  if (found_.size() > 2 * bodies.size() + 1000) found_.clear();  // after many changes of the scene
}

std::optional<SceneBox> ShownParts::boxAround(const std::vector<SceneBody>& bodies) {
  constexpr double kFlat = 1e-3;  // m
  Eigen::AlignedBox3d all;
  for (const SceneBody& body : bodies) {
    Eigen::AlignedBox3d box;
    for (const SceneMesh* mesh : {&body.shape->opaque, &body.shape->translucent})
      for (const auto& vertex : mesh->vertices)
        box.extend(body.inField * Eigen::Map<const Eigen::Vector3f>(vertex.position.data()).cast<double>());
    if (!box.isEmpty() && box.sizes().z() > kFlat) all.extend(box);
  }
  if (all.isEmpty()) return std::nullopt;
  return SceneBox{all.center().head<2>(), {all.sizes().x(), all.sizes().y(), std::max(0.1, all.max().z())}};
}

std::optional<ShownParts::Extent> ShownParts::extentOf(const std::string& path,
                                                       const std::vector<SceneBody>& bodies,
                                                       const SceneState& scene) const {
  const auto pose = objects_.pose(path, scene);
  if (!pose) return std::nullopt;
  const robotlink::Pose3 fieldInObject = pose->inverse();
  Eigen::AlignedBox3d box;
  for (const SceneBody& body : bodies) {
    if (!objects_.isWithin(body.object ? *body.object : body.model, path)) continue;
    const robotlink::Pose3 bodyInObject = fieldInObject * body.inField;
    for (const SceneMesh* mesh : {&body.shape->opaque, &body.shape->translucent}) {
      for (const auto& vertex : mesh->vertices) {
        const auto& p = vertex.position;
        box.extend(bodyInObject * robotlink::Vector3(double(p[0]), double(p[1]), double(p[2])));
      }
    }
  }
  if (box.isEmpty()) return std::nullopt;
  return Extent{box.center(), box.diagonal().norm() / 2};
}

}  // namespace widgets
