// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "simcore/world/RenderScene.h"

namespace simcore {

/// The first instance that a ray hits.
struct PickedInstance {
  /// Index in RenderScene::instances.
  std::size_t instance = 0;
  /// Along the ray, in lengths of its direction.
  double distance = 0;
};

/// Finds the first drawn triangle, seen from either side, that a ray hits in front of its origin; the world's
/// frame, poses by body index. Looks at all triangles (some ms in a scene of 300,000), which is cheap enough
/// for what a person points at (Moeller and Trumbore, "Fast, minimum storage ray/triangle intersection",
/// 1997).
std::optional<PickedInstance> pickInstance(const RenderScene& scene, std::span<const Pose3> bodyInWorld,
                                           const robotlink::Vector3& origin,
                                           const robotlink::Vector3& direction);

}  // namespace simcore
