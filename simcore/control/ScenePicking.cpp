// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/control/ScenePicking.h"

#include <cmath>

#include <Eigen/Geometry>

namespace simcore {
namespace {

using robotlink::Vector3;

/// The distance at which a ray hits a triangle; negative if it does not.
double distanceTo(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& origin,
                  const Vector3& direction) {
  const Vector3 ab = b - a, ac = c - a, p = direction.cross(ac);
  const double determinant = ab.dot(p);
  if (determinant == 0 || !std::isfinite(determinant)) return -1;
  const Vector3 t = origin - a, q = t.cross(ab);
  const double u = t.dot(p) / determinant, v = direction.dot(q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 ? ac.dot(q) / determinant : -1;
}

}  // namespace

std::optional<PickedInstance> pickInstance(const RenderScene& scene, std::span<const Pose3> bodyInWorld,
                                           const Vector3& origin, const Vector3& direction) {
  std::optional<PickedInstance> best;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const RenderInstance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    const Pose3 worldInMesh =
        (bodyInWorld[static_cast<std::size_t>(instance.body)] * instance.meshInBody).inverse(Eigen::Isometry);
    const Vector3 from = worldInMesh * origin, along = worldInMesh.linear() * direction;
    for (const auto& triangle : mesh.triangles) {
      const auto corner = [&](std::size_t k) -> Vector3 { return mesh.vertices[triangle[k]].cast<double>(); };
      const double distance = distanceTo(corner(0), corner(1), corner(2), from, along);
      if (distance > 0 && (!best || distance < best->distance)) best = PickedInstance{i, distance};
    }
  }
  return best;
}

}  // namespace simcore
