// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/meshes/PolylineMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace simcore {
namespace {

using robotlink::Vector2;

constexpr std::size_t kMaxCorners = 1000;
constexpr double kSameCorner = 1e-9;  // m

/// Twice the area of a triangle, positive if it is counterclockwise.
double turn(const Vector2& a, const Vector2& b, const Vector2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool contains(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& point) {
  return turn(a, b, point) >= 0 && turn(b, c, point) >= 0 && turn(c, a, point) >= 0;
}

double twiceArea(const std::vector<Vector2>& corners) {
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    area += a.x() * b.y() - a.y() * b.x();
  }
  return area;
}

/// Whether two sides of the polygon cross; those that only touch do not.
bool crossesItself(const std::vector<Vector2>& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 &a = corners[i], &b = corners[(i + 1) % n];
    for (std::size_t j = i + 2; j < n; ++j) {
      const Vector2 &c = corners[j], &d = corners[(j + 1) % n];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) return true;
    }
  }
  return false;
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Whether the corner `at` of the remaining ones can be cut off.
bool isEar(const std::vector<Vector2>& corners, const std::vector<std::uint32_t>& left, std::size_t at) {
  const std::size_t n = left.size();
  const std::uint32_t i = left[(at + n - 1) % n], j = left[at], k = left[(at + 1) % n];
  if (turn(corners[i], corners[j], corners[k]) <= 0) return false;
  return std::ranges::none_of(left, [&](std::uint32_t other) {
    return other != i && other != j && other != k &&
           contains(corners[i], corners[j], corners[k], corners[other]);
  });
}

/// Empty if the polygon crosses itself. Each search for an ear continues where the last one ended: from the
/// beginning, a spiral takes time with the cube of its corners.
Triangles triangulated(const std::vector<Vector2>& corners) {
  std::vector<std::uint32_t> left(corners.size());
  std::iota(left.begin(), left.end(), 0U);
  Triangles triangles;
  std::size_t at = 0;
  while (left.size() > 3) {
    const std::size_t n = left.size();
    std::size_t tried = 0;
    for (at %= n; tried < n && !isEar(corners, left, at); ++tried) at = (at + 1) % n;
    if (tried == n) return {};
    triangles.push_back({left[(at + n - 1) % n], left[at], left[(at + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

void addFloor(Mesh& mesh, const std::vector<Vector2>& corners, const Triangles& triangles, float z, bool up) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector2& corner : corners) {
    mesh.vertices.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()), z);
    mesh.normals.emplace_back(0.F, 0.F, up ? 1.F : -1.F);
  }
  for (const auto& t : triangles)
    mesh.triangles.push_back({first + t[0], first + t[up ? 1 : 2], first + t[up ? 2 : 1]});
}

void addWall(Mesh& mesh, const Vector2& from, const Vector2& to, float height) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const Eigen::Vector2f a = from.cast<float>(), b = to.cast<float>();
  const Eigen::Vector2f along = (b - a).normalized();
  mesh.vertices.insert(
      mesh.vertices.end(),
      {{a.x(), a.y(), 0}, {b.x(), b.y(), 0}, {b.x(), b.y(), height}, {a.x(), a.y(), height}});
  mesh.normals.insert(mesh.normals.end(), 4, Eigen::Vector3f(along.y(), -along.x(), 0));
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

}  // namespace

tl::expected<Mesh, std::string> extrudedMesh(std::vector<Vector2> corners, double height) {
  const auto same = [](const Vector2& a, const Vector2& b) { return (a - b).norm() < kSameCorner; };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  if (corners.size() > 1 && same(corners.front(), corners.back())) corners.pop_back();
  if (corners.size() < 3 || corners.size() > kMaxCorners)
    return tl::unexpected("it has " + std::to_string(corners.size()));
  const bool finite = std::ranges::all_of(corners, [](const Vector2& one) { return one.allFinite(); });
  const double area = finite ? twiceArea(corners) : 0;
  if (!(std::abs(area) > 0)) return tl::unexpected(std::string("it has no area"));
  if (area < 0) std::ranges::reverse(corners);
  // Some of these can be cut into ears all the same.
  const Triangles triangles = crossesItself(corners) ? Triangles() : triangulated(corners);
  if (triangles.empty()) return tl::unexpected(std::string("it crosses itself"));
  Mesh mesh;
  const auto top = static_cast<float>(height);
  addFloor(mesh, corners, triangles, 0, false);
  addFloor(mesh, corners, triangles, top, true);
  for (std::size_t i = 0; i < corners.size(); ++i)
    addWall(mesh, corners[i], corners[(i + 1) % corners.size()], top);
  return mesh;
}

Mesh coneMesh(float radius, float length, int sides) {
  const auto count = static_cast<std::uint32_t>(std::max(3, sides));
  const float half = length / 2, slant = std::hypot(radius, length);
  Mesh mesh;
  for (std::uint32_t side = 0; side < count; ++side) {
    const float angle =
        static_cast<float>(2 * robotlink::kPi) * static_cast<float>(side) / static_cast<float>(count);
    const Eigen::Vector3f out(std::cos(angle), std::sin(angle), 0);
    const Eigen::Vector3f slope = (out * length + Eigen::Vector3f::UnitZ() * radius) / slant;
    const Eigen::Vector3f rim = out * radius - Eigen::Vector3f::UnitZ() * half;
    mesh.vertices.insert(mesh.vertices.end(), {rim, Eigen::Vector3f(0, 0, half), rim});
    mesh.normals.insert(mesh.normals.end(), {slope, slope, -Eigen::Vector3f::UnitZ()});
    const std::uint32_t next = (side + 1) % count;
    mesh.triangles.push_back({3 * side, 3 * next, 3 * side + 1});
    mesh.triangles.push_back({3 * count, 3 * next + 2, 3 * side + 2});
  }
  mesh.vertices.emplace_back(0, 0, -half);
  mesh.normals.emplace_back(0, 0, -1);
  return mesh;
}

}  // namespace simcore
