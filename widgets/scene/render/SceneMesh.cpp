// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/SceneMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/scene/render/SceneCamera.h"

namespace widgets {
namespace {

using robotlink::Vector3;

/// T. Moeller and B. Trumbore, "Fast, minimum storage ray/triangle intersection" (1997), without culling.
std::optional<double> distanceToTriangle(const Vector3& a, const Vector3& b, const Vector3& c,
                                         const Ray& ray) {
  const Vector3 ab = b - a, ac = c - a;
  const Vector3 p = ray.direction.cross(ac);
  const double determinant = ab.dot(p);
  if (std::abs(determinant) < 1e-14) return std::nullopt;
  const Vector3 t = ray.origin - a;
  const double u = t.dot(p) / determinant;
  const Vector3 q = t.cross(ab);
  const double v = ray.direction.dot(q) / determinant;
  const double distance = ac.dot(q) / determinant;
  if (u < 0 || v < 0 || u + v > 1 || distance <= 0) return std::nullopt;
  return distance;
}

}  // namespace

std::optional<double> distanceTo(const SceneMesh& mesh, const Ray& ray) {
  const auto at = [&](std::uint32_t index) {
    const auto& p = mesh.vertices[index].position;
    return Vector3(p[0], p[1], p[2]);
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto distance =
        distanceToTriangle(at(mesh.indices[i]), at(mesh.indices[i + 1]), at(mesh.indices[i + 2]), ray);
    if (distance) nearest = std::min(nearest, *distance);
  }
  return std::isfinite(nearest) ? std::optional(nearest) : std::nullopt;
}

}  // namespace widgets
