// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/StaticSpace.h"

#include <algorithm>
#include <cmath>

namespace simcore {
namespace {

constexpr std::size_t kFew = 64;
constexpr double kLeafSize = 1;  // m, about a robot's
constexpr int kDeepest = 7;      // some 20 000 blocks

}  // namespace

dSpaceID newStaticSpace(const WorldDescription& world, dSpaceID parent) {
  Eigen::AlignedBox2d bounds;
  std::size_t count = 0;
  for (const ModelInstance& model : world.models) {
    if (!model.type->isStatic) continue;
    for (const LinkDescription& link : model.type->links) {
      for (const CollisionDescription& collision : link.collisions) {
        if (collision.shape.kind == Shape::Kind::kPlane) continue;
        const Pose3 pose = model.poseInWorld * link.poseInModel * collision.poseInLink;
        bounds.extend(Vector3(pose.translation()).head<2>());
        ++count;
      }
    }
  }
  if (count <= kFew) return dSimpleSpaceCreate(parent);
  const Eigen::Vector2d middle = bounds.center(), size = bounds.sizes() + Eigen::Vector2d(1, 1);
  const dVector3 center = {middle.x(), middle.y(), 0, 0};
  // Half of each edge; nothing is cut upwards.
  const dVector3 extents = {size.x() / 2, size.y() / 2, 1000, 0};
  const int depth = static_cast<int>(std::ceil(std::log2(size.maxCoeff() / kLeafSize)));
  return dQuadTreeSpaceCreate(parent, center, extents, std::clamp(depth, 1, kDeepest));
}

}  // namespace simcore
