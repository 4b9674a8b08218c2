// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds made from maps, with robots put into them.

#include "simcore/maps/MapWorld.h"
#include "simcore/placement/RobotPlacement.h"
#include "tests/fuzz/FuzzTarget.h"

namespace map_scene_fuzz {

using namespace simcore;
using robotlink::GroundMap;

namespace {

std::shared_ptr<const ModelDescription> bucket() {
  auto type = std::make_shared<ModelDescription>();
  type->robot = "bucket";
  Shape& shape = type->links.emplace_back().collisions.emplace_back().shape;
  shape.kind = Shape::Kind::kCylinder;
  shape.radius = 0.3;
  shape.length = 0.4;
  return type;
}

void checkSolids(const ModelInstance& model) {
  for (const CollisionDescription& collision : model.type->links.at(0).collisions) {
    require(collision.poseInLink.matrix().allFinite(), "walls are somewhere");
    if (collision.shape.kind == Shape::Kind::kBox)
      require(collision.shape.size.minCoeff() > 0, "walls have a size");
  }
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const auto map = GroundMap::parse({reinterpret_cast<const char*>(data), size}, "fuzz.map");
  if (!map) return 0;
  auto world = mapWorld(*map, "fuzz.map");
  if (!world) return 0;
  for (const ModelInstance& model : world->models) checkSolids(model);
  // Larger floors take longer, but nothing else.
  const GroundMap::Bounds bounds = map->bounds();
  if ((bounds.high - bounds.low).norm() > 30) return 0;
  const std::size_t before = world->models.size();
  if (!addRobots(*world, &*map, bucket(), {.count = 3}, {}, "fuzz.map")) return 0;
  require(world->models.size() == before + 3, "all robots are there");
  for (std::size_t i = before; i < world->models.size(); ++i) {
    require(world->models[i].poseInWorld.matrix().allFinite(), "robots are somewhere");
    for (std::size_t k = before; k < i; ++k) {
      const double apart =
          (world->models[i].poseInWorld.translation() - world->models[k].poseInWorld.translation()).norm();
      require(apart > 0.6, "robots are apart");
    }
  }
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return {
      "2D-Map\nResolution: 20\nCairn: RobotHome 1500 1500 90 \"\" ICON \"Home\"\n"
      "Cairn: ForbiddenArea 0 0 0 \"\" ICON \"\" 5000 0 8000 3000\nCairn: ForbiddenLine 0 0 0 \"\" ICON \"\" "
      "4000 4000 4000 6000\n"
      "LINES\n0 0 8000 0\n8000 0 8000 6000\n8000 6000 0 6000\n0 6000 0 0\n4000 0 4000 4000\nDATA\n2000 "
      "4000\n2020 4000\n2020 4020\n",
      "2D-Map\nResolution: 50\nDATA\n0 0\n3000 0\n3000 3000\n0 3000\n50 0\n100 0\n150 50\n",
      "2D-Map\nCairn: RobotHome 0 0 0\n"};
}

const FuzzRegistration kTarget({"map_scene", &fuzzSeeds, &runInput});

}  // namespace map_scene_fuzz
