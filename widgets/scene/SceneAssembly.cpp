// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SceneAssembly.h"

#include "foxglove/Scene.pb.h"
#include "widgets/drawings/CurrentDrawings.h"
#include "widgets/field/GroundProbe.h"
#include "widgets/scene/render/SceneShapes.h"

namespace widgets {

std::vector<SceneBody> SceneAssembly::bodies(const SceneState& scene) {
  std::vector<SceneBody> bodies;
  for (const auto& [id, item] : scene.items()) {
    const auto pose = scene.framePose(item.entity->frame_id());
    if (!pose) continue;
    bodies.push_back({shape(sceneShapes_, item.entity, item.keep), *pose, item.model});
    bodies.back().object = item.object;
  }
  forgetUnused(sceneShapes_);
  return bodies;
}

std::vector<SceneBody> SceneAssembly::solids(const robotlink::PackagePtr& message, const SceneState& scene) {
  std::vector<SceneBody> bodies;
  const auto* update = dynamic_cast<const foxglove::SceneUpdate*>(message.get());
  if (message != solidsMessage_) {
    solidsMessage_ = message;
    solidShapes_.clear();
    solidObjects_.clear();
  }
  if (update == nullptr) return bodies;
  for (const auto& entity : update->entities()) {
    const auto pose = scene.framePose(entity.frame_id());
    if (!pose) continue;
    bodies.push_back({shape(solidShapes_, &entity, message), *pose, {}});
    auto& object = solidObjects_[&entity];
    const std::string* path = metadataOf(entity, "object");
    if (!object && path != nullptr) object = std::make_shared<const std::string>(*path);
    bodies.back().object = object;
  }
  return bodies;
}

std::vector<SceneBody> SceneAssembly::drawings(const std::vector<WorldDrawing>& drawings) {
  std::vector<SceneBody> bodies;
  bodies.reserve(drawings.size());
  for (const WorldDrawing& drawing : drawings) {
    const auto opacity = static_cast<float>(drawing.old ? kOldDrawingOpacity : 1);
    bodies.push_back({shape(drawingShapes_, drawing.entity, drawing.keep),
                      drawing.frameInField,
                      {},
                      opacity,
                      {drawing.id, drawing.robot, entityValues(*drawing.entity, drawing.id)}});
  }
  forgetUnused(drawingShapes_);
  return bodies;
}

std::vector<SceneLabel> SceneAssembly::labels(const std::vector<SceneBody>& drawings) {
  std::vector<SceneLabel> labels;
  for (const SceneBody& body : drawings) {
    for (const SceneText& text : body.shape->texts) {
      QColor color(text.color[0], text.color[1], text.color[2], text.color[3]);
      color.setAlphaF(color.alphaF() * static_cast<double>(body.opacity));
      labels.push_back(
          {body.inField * text.position, QString::fromStdString(text.text), color, text.size, false});
    }
  }
  return labels;
}

const std::shared_ptr<const SceneShape>& SceneAssembly::shape(Shapes& shapes,
                                                              const foxglove::SceneEntity* entity,
                                                              const robotlink::PackagePtr& keep) {
  const auto [found, isNew] = shapes.try_emplace(entity);
  if (isNew) found->second = {keep, std::make_shared<const SceneShape>(shapeOf(*entity)), true};
  found->second.used = true;
  return found->second.shape;
}

void SceneAssembly::forgetUnused(Shapes& shapes) {
  std::erase_if(shapes, [](const auto& entry) { return !entry.second.used; });
  for (auto& [entity, shape] : shapes) shape.used = false;
}

std::optional<SceneHit> firstHit(const std::vector<SceneBody>& bodies, const Ray& ray) {
  std::optional<SceneHit> hit;
  double nearest = 1e9;
  for (const SceneBody& body : bodies) {
    const robotlink::Pose3 fieldInBody = body.inField.inverse();
    const auto distance =
        distanceTo(body.shape->opaque, {fieldInBody * ray.origin, fieldInBody.linear() * ray.direction});
    if (!distance || *distance >= nearest) continue;
    nearest = *distance;
    hit = SceneHit{body.model, ray.at(nearest), body.object ? *body.object : std::string()};
  }
  return hit;
}

}  // namespace widgets
