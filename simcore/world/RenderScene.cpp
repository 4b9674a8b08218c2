// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/world/RenderScene.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace simcore {
namespace {

/// A point of an outline that is rotated around the z-axis, with the outline's normal there.
struct OutlinePoint {
  float radius, z;
  float normalRadius, normalZ;
};

/// Rotates an outline, given from bottom to top, around the z-axis. Points on the axis become a single
/// vertex.
class Lathe {
 public:
  explicit Lathe(int sides) : sides_(static_cast<std::uint32_t>(std::max(3, sides))) {}

  void addBand(const OutlinePoint& lower, const OutlinePoint& upper) {
    addBand(addRing(lower), addRing(upper));
  }
  void addSmooth(std::span<const OutlinePoint> outline) {
    Ring lower = addRing(outline.front());
    for (const OutlinePoint& point : outline.subspan(1)) {
      const Ring upper = addRing(point);
      addBand(lower, upper);
      lower = upper;
    }
  }
  Mesh take() { return std::move(mesh_); }

 private:
  struct Ring {
    std::uint32_t first;
    // 1 for a pole.
    std::uint32_t count;
    std::uint32_t at(std::uint32_t side) const { return first + side % count; }
  };

  Ring addRing(const OutlinePoint& point) {
    const Ring ring{static_cast<std::uint32_t>(mesh_.vertices.size()), point.radius > 0 ? sides_ : 1};
    for (std::uint32_t side = 0; side < ring.count; ++side) {
      const double angle = 2 * robotlink::kPi * side / sides_;
      const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
      mesh_.vertices.emplace_back(point.radius * c, point.radius * s, point.z);
      mesh_.normals.push_back(
          Eigen::Vector3f(point.normalRadius * c, point.normalRadius * s, point.normalZ).normalized());
    }
    return ring;
  }

  void addBand(const Ring& lower, const Ring& upper) {
    for (std::uint32_t side = 0; side < sides_; ++side) {
      if (lower.count > 1) {
        mesh_.triangles.push_back({lower.at(side), lower.at(side + 1), upper.at(side)});
      }
      if (upper.count > 1) {
        mesh_.triangles.push_back({upper.at(side), lower.at(side + 1), upper.at(side + 1)});
      }
    }
  }

  std::uint32_t sides_;
  Mesh mesh_;
};

/// Appends `steps` + 1 points of a circle around (0, z), from latitude `from` to latitude `to`; poles are
/// exactly on the axis.
void appendArc(std::vector<OutlinePoint>& outline, float radius, float z, double from, double to, int steps) {
  for (int i = 0; i <= steps; ++i) {
    const double latitude = from + (to - from) * i / steps;
    const bool pole = std::abs(latitude) > robotlink::kPi / 2 - 1e-6;
    const float c = pole ? 0.0F : static_cast<float>(std::cos(latitude));
    const auto s = static_cast<float>(std::sin(latitude));
    outline.push_back({radius * c, z + radius * s, c, s});
  }
}

}  // namespace

Mesh boxMesh(const Eigen::Vector3f& size) {
  Mesh mesh;
  const Eigen::Vector3f half = size / 2;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0F, 1.0F}) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      // The two other axes, in the order that makes the corners counterclockwise seen from outside.
      const int u = (axis + (sign > 0 ? 1 : 2)) % 3, v = (axis + (sign > 0 ? 2 : 1)) % 3;
      for (const auto& [a, b] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}) {
        Eigen::Vector3f corner;
        corner[axis] = sign * half[axis];
        corner[u] = a * half[u];
        corner[v] = b * half[v];
        mesh.vertices.push_back(corner);
        mesh.normals.emplace_back(sign * Eigen::Vector3f::Unit(axis));
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    }
  }
  return mesh;
}

Mesh sphereMesh(float radius, int rings) {
  rings = std::max(2, rings);
  std::vector<OutlinePoint> outline;
  appendArc(outline, radius, 0, -robotlink::kPi / 2, robotlink::kPi / 2, rings);
  Lathe lathe(2 * rings);
  lathe.addSmooth(outline);
  return lathe.take();
}

Mesh cylinderMesh(float radius, float length, int sides) {
  const float half = length / 2;
  Lathe lathe(sides);
  lathe.addBand({0, -half, 0, -1}, {radius, -half, 0, -1});
  lathe.addBand({radius, -half, 1, 0}, {radius, half, 1, 0});
  lathe.addBand({radius, half, 0, 1}, {0, half, 0, 1});
  return lathe.take();
}

Mesh capsuleMesh(float radius, float length, int sides) {
  const int steps = std::max(2, sides / 4);
  std::vector<OutlinePoint> outline;
  appendArc(outline, radius, -length / 2, -robotlink::kPi / 2, 0, steps);
  appendArc(outline, radius, length / 2, 0, robotlink::kPi / 2, steps);
  Lathe lathe(sides);
  lathe.addSmooth(outline);
  return lathe.take();
}

Eigen::Vector3f placeOf(const Lamp& lamp) {
  constexpr float kSunDistance = 1000;  // m
  return lamp.kind == Lamp::Kind::kDirectional ? Eigen::Vector3f(lamp.direction * -kSunDistance)
                                               : lamp.position;
}

Eigen::Vector3f tintOf(const Lamp& lamp) {
  const float peak = lamp.color.maxCoeff();
  return peak > 0 ? Eigen::Vector3f(lamp.color / peak) : Eigen::Vector3f::Ones();
}

float shareTowards(const Lamp& lamp, const Eigen::Vector3f& direction) {
  if (lamp.kind != Lamp::Kind::kSpot) return 1;
  constexpr float kSharpest = 1e-4F, kTiny = 1e-12F;
  const float cosine = direction.dot(lamp.direction) / std::max(direction.norm(), kTiny);
  const float outer = std::cos(lamp.outerAngle / 2);
  return std::clamp((cosine - outer) / std::max(kSharpest, std::cos(lamp.innerAngle / 2) - outer), 0.F, 1.F);
}

}  // namespace simcore
