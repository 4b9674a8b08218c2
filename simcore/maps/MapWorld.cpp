// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/maps/MapWorld.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "simcore/maps/WallBoxes.h"

namespace simcore {
namespace {

using robotlink::GroundMap;
using robotlink::Vector2;

constexpr double kWallHeight = 1;
/// Width of the floor around everything, m.
constexpr double kFloorMargin = 1;
constexpr double kWallFriction = 0.4;
/// The drawn walls are split into tiles of this size, so that cameras skip those out of view.
constexpr double kTileSize = 8;
constexpr std::size_t kMaxPieces = 100'000;
constexpr std::size_t kMaxPoints = 2'000'000;

constexpr Rgb kWallColor{176, 180, 188}, kFloorColor{226, 222, 212}, kSkyColor{200, 216, 232};

Pose3 boxPoseOf(const WallBox& box) {
  return Eigen::Translation3d(box.center.x(), box.center.y(), kWallHeight / 2) *
         Eigen::AngleAxisd(box.angle, Vector3::UnitZ());
}

Shape shapeOf(const WallBox& box) {
  Shape shape;
  shape.size = {box.size.x(), box.size.y(), kWallHeight};
  return shape;
}

/// Adds the sides and the top of a box, but not its bottom, which stands on the floor.
void appendBox(Mesh& mesh, const WallBox& box) {
  const Pose3 pose = boxPoseOf(box);
  const auto addFace = [&](const Vector3& middle, const Vector3& right, const Vector3& up) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      mesh.vertices.push_back((pose * (middle + x * right + y * up)).cast<float>());
      mesh.normals.push_back((pose.linear() * middle.normalized()).cast<float>());
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  };
  const Vector3 x(box.size.x() / 2, 0, 0), y(0, box.size.y() / 2, 0), z(0, 0, kWallHeight / 2);
  addFace(x, y, z);
  addFace(-x, -y, z);
  addFace(y, -x, z);
  addFace(-y, x, z);
  addFace(z, x, y);
}

ModelInstance staticModel(const std::string& name, LinkDescription link, const std::string& file) {
  auto type = std::make_shared<ModelDescription>();
  type->file = file;
  type->name = name;
  type->isStatic = true;
  link.name = name;
  type->links.push_back(std::move(link));
  ModelInstance model;
  model.name = name;
  model.type = std::move(type);
  model.where = {file, 0, 0};
  return model;
}

LinkDescription floorLink(const GroundMap::Bounds& bounds) {
  LinkDescription link;
  Shape plane;
  plane.kind = Shape::Kind::kPlane;
  const Vector2 size = bounds.high - bounds.low, middle = (bounds.low + bounds.high) / 2;
  plane.size = {size.x() + 2 * kFloorMargin, size.y() + 2 * kFloorMargin, 0};
  CollisionDescription& collision = link.collisions.emplace_back();
  collision.name = "floor";
  collision.shape = plane;
  VisualDescription& visual = link.visuals.emplace_back();
  visual.name = "floor";
  visual.poseInLink = Eigen::Translation3d(middle.x(), middle.y(), 0) * Pose3::Identity();
  visual.shape = plane;
  visual.color = kFloorColor;
  visual.castsShadow = false;
  return link;
}

LinkDescription wallLink(const std::vector<WallBox>& boxes) {
  LinkDescription link;
  link.collisions.reserve(boxes.size());
  std::map<std::pair<int, int>, std::shared_ptr<Mesh>> tiles;
  for (const WallBox& box : boxes) {
    CollisionDescription& collision = link.collisions.emplace_back();
    collision.name = "wall" + std::to_string(link.collisions.size());
    collision.poseInLink = boxPoseOf(box);
    collision.shape = shapeOf(box);
    collision.friction = kWallFriction;
    const auto tileOf = [](double coordinate) {
      return static_cast<int>(std::floor(coordinate / kTileSize));
    };
    auto& tile = tiles[{tileOf(box.center.x()), tileOf(box.center.y())}];
    if (!tile) tile = std::make_shared<Mesh>();
    appendBox(*tile, box);
  }
  for (auto& [place, mesh] : tiles) {
    VisualDescription& visual = link.visuals.emplace_back();
    visual.name = "walls" + std::to_string(place.first) + "," + std::to_string(place.second);
    visual.shape.kind = Shape::Kind::kMesh;
    visual.shape.mesh = std::move(mesh);
    visual.color = kWallColor;
  }
  return link;
}

}  // namespace

robotlink::Result<WorldDescription> mapWorld(const GroundMap& map, const std::string& file) {
  const auto tooLarge = [&](const std::string& what) {
    return robotlink::failure("scene.map-size",
                              "the map has too many " + what + " to be simulated: leave out some of it",
                              {file, 0, 0}, {what});
  };
  if (map.points.size() > kMaxPoints) return tooLarge("points");
  const std::vector<WallBox> boxes = wallBoxes(map);
  if (boxes.size() > kMaxPieces) return tooLarge("walls");
  const GroundMap::Bounds bounds = map.bounds();
  WorldDescription world;
  world.name = map.name;
  world.ambient = 0.6F;
  world.background = kSkyColor;
  // Like the sun: so high that the whole building is lit evenly, and not vertically.
  const Vector2 middle = (bounds.low + bounds.high) / 2;
  const double height = 20 + (bounds.high - bounds.low).norm();
  Lamp lamp;
  lamp.position = Vector3(middle.x() - height / 2, middle.y() - height / 3, height).cast<float>();
  lamp.intensity = 0.5F;
  world.lamps.push_back(lamp);
  world.models.push_back(staticModel("floor", floorLink(bounds), file));
  if (!boxes.empty()) world.models.push_back(staticModel("walls", wallLink(boxes), file));
  return world;
}

}  // namespace simcore
