// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/MeshBuilder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace widgets {
namespace {

using robotlink::kPi;
using robotlink::Pose3;
using robotlink::Vector3;

constexpr int kAround = 32;  // corners of a circle
constexpr int kSlices = 16;  // slices of a sphere from pole to pole
constexpr double kSmoothAngle = robotlink::radians(40);

Vector3 unitNormal(const Vector3& v) {
  const double length = v.norm();
  return length > 1e-15 ? Vector3(v / length) : Vector3(Vector3::UnitZ());
}

/// Key of a corner's place: corners within a tenth of a millimeter are the same.
std::array<std::int64_t, 3> gridPlace(const Vector3& v) {
  constexpr double kCell = 1e-4;
  return {std::llround(v.x() / kCell), std::llround(v.y() / kCell), std::llround(v.z() / kCell)};
}

}  // namespace

std::uint32_t MeshBuilder::add(const Vector3& position, const Vector3& normal, Color color) {
  to_.vertices.push_back({packed(position), packed(normal), color});
  return static_cast<std::uint32_t>(to_.vertices.size() - 1);
}

void MeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  to_.indices.insert(to_.indices.end(), {a, b, c});
}

void MeshBuilder::box(const Pose3& pose, const Vector3& size, Color color) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const int first = side > 0 ? (axis + 1) % 3 : (axis + 2) % 3,
                second = side > 0 ? (axis + 2) % 3 : (axis + 1) % 3;
      const Vector3 normal = pose.linear() * (side * Vector3::Unit(axis));
      std::array<std::uint32_t, 4> corners{};
      for (std::size_t i = 0; i < 4; ++i) {
        Vector3 corner = side * size[axis] / 2 * Vector3::Unit(axis);
        corner[first] = (i == 1 || i == 2 ? 0.5 : -0.5) * size[first];
        corner[second] = (i >= 2 ? 0.5 : -0.5) * size[second];
        corners[i] = add(pose * corner, normal, color);
      }
      triangle(corners[0], corners[1], corners[2]);
      triangle(corners[0], corners[2], corners[3]);
    }
  }
}

void MeshBuilder::sphere(const Pose3& pose, const Vector3& size, Color color) {
  const auto first = static_cast<std::uint32_t>(to_.vertices.size());
  const Vector3 radii = size / 2;
  for (int slice = 0; slice <= kSlices; ++slice) {
    const double polar = kPi * slice / kSlices;
    for (int i = 0; i <= kAround; ++i) {
      const double angle = 2 * kPi * i / kAround;
      const Vector3 unit(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                         std::cos(polar));
      add(pose * Vector3(radii.cwiseProduct(unit)),
          pose.linear() * unitNormal(unit.cwiseQuotient(radii.cwiseMax(1e-6))), color);
    }
  }
  constexpr std::uint32_t kRow = kAround + 1;
  for (std::uint32_t slice = 0; slice < kSlices; ++slice) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t a = first + slice * kRow + i;
      triangle(a, a + kRow, a + kRow + 1);
      triangle(a, a + kRow + 1, a + 1);
    }
  }
}

void MeshBuilder::disc(const Pose3& pose, const Vector3& size, double z, double scale, Color color) {
  if (scale <= 0) return;
  const Vector3 normal = pose.linear() * Vector3(0, 0, z > 0 ? 1 : -1);
  const std::uint32_t middle = add(pose * Vector3(0, 0, z), normal, color);
  for (int i = 0; i <= kAround; ++i) {
    const double angle = 2 * kPi * i / kAround;
    const std::uint32_t corner =
        add(pose * Vector3(scale * size.x() / 2 * std::cos(angle), scale * size.y() / 2 * std::sin(angle), z),
            normal, color);
    if (i > 0) z > 0 ? triangle(middle, corner - 1, corner) : triangle(middle, corner, corner - 1);
  }
}

void MeshBuilder::cylinder(const Pose3& pose, const Vector3& size, double bottomScale, double topScale,
                           Color color) {
  const auto first = static_cast<std::uint32_t>(to_.vertices.size());
  const double slope = (bottomScale - topScale) * (size.x() + size.y()) / 4 / std::max(1e-9, size.z());
  for (int i = 0; i <= kAround; ++i) {
    const double angle = 2 * kPi * i / kAround;
    const Vector3 around(std::cos(angle), std::sin(angle), 0);
    const Vector3 normal = pose.linear() * unitNormal(around + Vector3(0, 0, slope));
    const Vector3 rim(size.x() / 2 * around.x(), size.y() / 2 * around.y(), 0);
    add(pose * Vector3(bottomScale * rim - Vector3(0, 0, size.z() / 2)), normal, color);
    add(pose * Vector3(topScale * rim + Vector3(0, 0, size.z() / 2)), normal, color);
  }
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const std::uint32_t a = first + 2 * i;
    triangle(a, a + 2, a + 3);
    triangle(a, a + 3, a + 1);
  }
  disc(pose, size, -size.z() / 2, bottomScale, color);
  disc(pose, size, size.z() / 2, topScale, color);
}

void MeshBuilder::triangles(std::span<const Vector3> corners, std::span<const Color> colors) {
  const std::size_t count = corners.size() / 3;
  std::vector<Vector3> normals;  // length is twice the triangle's area
  std::map<std::array<std::int64_t, 3>, std::vector<std::size_t>> meeting;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3& a = corners[3 * i];
    normals.push_back((corners[3 * i + 1] - a).cross(corners[3 * i + 2] - a));
    for (std::size_t corner = 3 * i; corner < 3 * i + 3; ++corner)
      meeting[gridPlace(corners[corner])].push_back(i);
  }
  // Corners with equal place, normal and color become one vertex.
  std::map<std::tuple<std::array<std::int64_t, 3>, std::array<std::int64_t, 3>, Color>, std::uint32_t> made;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 own = unitNormal(normals[i]);
    for (std::size_t corner = 3 * i; corner < 3 * i + 3; ++corner) {
      Vector3 sum = Vector3::Zero();
      for (const std::size_t other : meeting[gridPlace(corners[corner])]) {
        if (unitNormal(normals[other]).dot(own) > std::cos(kSmoothAngle)) sum += normals[other];
      }
      const Vector3 normal = unitNormal(sum);
      const auto [found, isNew] =
          made.try_emplace({gridPlace(corners[corner]), gridPlace(normal), colors[i]}, 0);
      if (isNew) found->second = add(corners[corner], normal, colors[i]);
      to_.indices.push_back(found->second);
    }
  }
}

}  // namespace widgets
