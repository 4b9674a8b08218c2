// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "robotlink/base/Geometry.h"
#include "widgets/scene/render/SceneMesh.h"

namespace widgets {

/// A point or a direction as the graphics card takes it.
inline std::array<float, 3> packed(const robotlink::Vector3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

/// Adds primitive shapes to a mesh, each at a pose in the mesh's frame. Meters.
class MeshBuilder {
 public:
  using Color = std::array<std::uint8_t, 4>;

  explicit MeshBuilder(SceneMesh& to) : to_(to) {}

  /// `size`: lengths along x, y and z.
  void box(const robotlink::Pose3& pose, const robotlink::Vector3& size, Color color);
  /// `size`: diameters along x, y and z.
  void sphere(const robotlink::Pose3& pose, const robotlink::Vector3& size, Color color);
  /// Along z. `size`: diameters along x and y, and height. The diameters at the lower and upper end are
  /// multiplied by the scales.
  void cylinder(const robotlink::Pose3& pose, const robotlink::Vector3& size, double bottomScale,
                double topScale, Color color);
  /// Three corners and one color per triangle. Normals are smooth where triangles meet at an angle below 40
  /// degrees.
  void triangles(std::span<const robotlink::Vector3> corners, std::span<const Color> colors);

 private:
  /// Appends a vertex and returns its index.
  std::uint32_t add(const robotlink::Vector3& position, const robotlink::Vector3& normal, Color color);
  /// Appends a triangle of three vertices.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  /// Appends the lid of a cylinder at height `z`.
  void disc(const robotlink::Pose3& pose, const robotlink::Vector3& size, double z, double scale,
            Color color);

  SceneMesh& to_;
};

}  // namespace widgets
