// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/ModelWorld.h"

#include <algorithm>
#include <limits>

#include "simcore/world/ModelGeometry.h"

namespace simcore {
namespace {

ModelInstance floorInstance() {
  auto type = std::make_shared<ModelDescription>();
  type->name = "floor";
  type->isStatic = true;
  LinkDescription& link = type->links.emplace_back();
  link.name = "floor";
  link.mass = 1;
  Shape plane;
  plane.kind = Shape::Kind::kPlane;
  plane.size = {100, 100, 0};
  link.collisions.push_back({"floor", Pose3::Identity(), plane});
  VisualDescription visual;
  visual.name = "floor";
  visual.shape = plane;
  visual.color = {150, 150, 150};
  link.visuals.push_back(visual);
  ModelInstance instance;
  instance.name = "floor";
  instance.type = std::move(type);
  return instance;
}

/// The height of the lowest point of a model's solids, in the world.
double lowestPoint(const ModelDescription& model, const Pose3& pose) {
  const std::vector<Pose3> links = linksAtStart(model);
  double low = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const CollisionDescription& solid : model.links[i].collisions) {
      if (solid.shape.kind == Shape::Kind::kPlane) continue;
      const Pose3 inWorld = pose * links[i] * solid.poseInLink;
      low =
          std::min(low, inWorld.translation().z() - reach(solid.shape, inWorld.linear(), -Vector3::UnitZ()));
    }
  }
  return low;
}

}  // namespace

WorldDescription worldOfModel(std::shared_ptr<const ModelDescription> type, const Pose3& pose) {
  WorldDescription world;
  world.name = type->name;
  Lamp sun;
  sun.kind = Lamp::Kind::kDirectional;
  sun.direction = Eigen::Vector3f(-0.5F, 0.1F, -0.9F).normalized();
  world.lamps = {sun};
  world.background = {178, 178, 178};
  const bool hasFloor = std::ranges::any_of(type->links, [](const LinkDescription& link) {
    return std::ranges::any_of(link.collisions,
                               [](const auto& one) { return one.shape.kind == Shape::Kind::kPlane; });
  });
  if (!hasFloor && type->name != "floor") world.models.push_back(floorInstance());
  ModelInstance instance;
  instance.name = type->name;
  instance.where = {type->file, 1, 0};
  instance.poseInWorld = pose;
  const double low = lowestPoint(*type, pose);
  if (!type->isStatic && low < 0) instance.poseInWorld.translation().z() -= low;
  instance.type = std::move(type);
  world.models.push_back(std::move(instance));
  return world;
}

}  // namespace simcore
