// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SceneAssembly.h"

#include <QPalette>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "foxglove/Scene.pb.h"
#include "widgets/Theme.h"
#include "widgets/drawings/CurrentDrawings.h"
#include "widgets/field/GroundProbe.h"
#include "widgets/scene/render/SceneShapes.h"

namespace widgets {
namespace {

constexpr char kFixedFrame[] = "field";  // the frame of what cannot be moved
/// The color saturation of solids.
constexpr double kMovingSaturation = 0.38, kFixedSaturation = 0.1;
/// A model is wide from this many times the size of what moves, m, within these limits.
constexpr double kTimesWider = 3, kMinWide = 1, kMaxWide = 3;
constexpr int kWidthDirections = 18;

/// Gives all surfaces one color.
void paintOver(SceneShape& shape, const QColor& color) {
  const std::array<std::uint8_t, 4> rgba{static_cast<std::uint8_t>(color.red()),
                                         static_cast<std::uint8_t>(color.green()),
                                         static_cast<std::uint8_t>(color.blue()), std::uint8_t{255}};
  for (SceneMesh* mesh : {&shape.opaque, &shape.translucent})
    for (auto& vertex : mesh->vertices) vertex.color = rgba;
}

/// Calls `found` with the places of all corners of a body in the field's frame, m.
template <typename Found>
void forEachCorner(const SceneBody& body, Found found) {
  for (const SceneMesh* mesh : {&body.shape->opaque, &body.shape->translucent})
    for (const auto& vertex : mesh->vertices)
      found(robotlink::Vector3(body.inField *
                               Eigen::Map<const Eigen::Vector3f>(vertex.position.data()).cast<double>()));
}

/// The width of a model on the ground, in the direction in which it is narrowest.
double leastWidthOf(const std::string& model, const std::vector<SceneBody>& bodies) {
  std::array<Eigen::AlignedBox1d, kWidthDirections> widths;
  std::array<robotlink::Vector2, kWidthDirections> directions;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double angle = static_cast<double>(i) * robotlink::kPi / kWidthDirections;
    directions[i] = {std::cos(angle), std::sin(angle)};
  }
  for (const SceneBody& body : bodies) {
    if (!isPartOf(body, model)) continue;
    forEachCorner(body, [&](const robotlink::Vector3& corner) {
      for (std::size_t i = 0; i < directions.size(); ++i)
        widths[i].extend(Eigen::Matrix<double, 1, 1>(directions[i].dot(corner.head<2>())));
    });
  }
  double least = std::numeric_limits<double>::infinity();
  for (const auto& width : widths) least = std::min(least, width.isEmpty() ? 0 : width.sizes()[0]);
  return least;
}

/// The size on the ground of the largest model that moves, m; 0: none does.
double largestMoving(const std::vector<SceneBody>& bodies) {
  std::map<std::string, Eigen::AlignedBox3d> boxes;
  for (const SceneBody& body : bodies) {
    if (body.model.empty()) continue;
    forEachCorner(body, [&box = boxes[body.model]](const robotlink::Vector3& corner) { box.extend(corner); });
  }
  double largest = 0;
  for (const auto& [model, box] : boxes)
    if (!box.isEmpty()) largest = std::max(largest, box.sizes().head<2>().maxCoeff());
  return largest;
}

}  // namespace

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

std::vector<SceneBody> SceneAssembly::solids(const robotlink::PackagePtr& message, const SceneState& scene,
                                             const QPalette* calm) {
  const QColor color = calm == nullptr ? QColor() : calmColor(0, kMovingSaturation, *calm);
  if (message != solidsMessage_ || color != solidsColor_) {
    solidsMessage_ = message;
    solidsColor_ = color;
    solids_.clear();
    if (const auto* update = dynamic_cast<const foxglove::SceneUpdate*>(message.get()))
      readSolids(*update, calm);
  }
  std::vector<SceneBody> bodies;
  for (const Solid& solid : solids_) {
    const auto pose = scene.framePose(solid.entity->frame_id());
    if (!pose) continue;
    bodies.push_back({solid.shape, *pose, {}});
    bodies.back().object = solid.object;
  }
  return bodies;
}

void SceneAssembly::readSolids(const foxglove::SceneUpdate& update, const QPalette* calm) {
  std::map<std::string, int> models;  // their numbers, in the order of the message
  for (const auto& entity : update.entities()) {
    const std::string* path = metadataOf(entity, "object");
    SceneShape shape = shapeOf(entity);
    if (calm != nullptr) {
      const std::string model = path == nullptr ? std::string() : path->substr(0, path->find('/'));
      const int number = models.try_emplace(model, static_cast<int>(models.size())).first->second;
      const bool isFixed = entity.frame_id() == kFixedFrame;
      paintOver(shape, calmColor(number, isFixed ? kFixedSaturation : kMovingSaturation, *calm));
    }
    solids_.push_back({&entity, std::make_shared<const SceneShape>(std::move(shape)),
                       path == nullptr ? nullptr : std::make_shared<const std::string>(*path)});
  }
}

std::vector<SceneBody> SceneAssembly::drawings(const std::vector<WorldDrawing>& drawings) {
  std::vector<SceneBody> bodies;
  bodies.reserve(drawings.size());
  for (const WorldDrawing& drawing : drawings) {
    const auto opacity = static_cast<float>(drawingOpacity(drawing.id, drawing.old));
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

bool isSurroundings(const std::string& model, const std::vector<SceneBody>& bodies) {
  const bool canMove =
      std::ranges::any_of(bodies, [&](const SceneBody& body) { return body.model == model; });
  if (model.empty() || canMove) return false;
  const double wide = std::clamp(kTimesWider * largestMoving(bodies), kMinWide, kMaxWide);
  return leastWidthOf(model, bodies) >= wide;
}

}  // namespace widgets
