// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/rendering/KernelTypes.h"
#include "simcore/world/RenderScene.h"

namespace simcore::rendering {

/// A sphere in a given frame, meters.
struct Sphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0;
};

/// A mesh in the form that the kernels read, with derived properties of its shape. Immutable; in the frame of
/// the mesh. Triangles without an area, or with an index beyond the vertices, are dropped.
class DrawableMesh {
 public:
  explicit DrawableMesh(const Mesh& mesh);
  DrawableMesh(const DrawableMesh&) = delete;
  /// Moving keeps streams() valid, because the vectors keep their memory.
  DrawableMesh(DrawableMesh&&) = default;

  const MeshStreams& streams() const { return streams_; }
  /// A sphere that contains all vertices.
  const Sphere& bound() const { return bound_; }
  /// A few smaller spheres that together contain the mesh.
  const std::vector<Sphere>& cover() const { return cover_; }
  /// Whether all vertices are on or behind the plane of every triangle. Then no part of the mesh that faces a
  /// lamp is in its own shadow. The mesh need not be closed. Very large meshes are not examined and count as
  /// not convex.
  bool convex() const { return convex_; }

 private:
  // The constructor's steps.
  void fillVertices(const Mesh& mesh);
  void fillTriangles(const Mesh& mesh);
  void findBounds(const Mesh& mesh);
  void findConvexity(const Mesh& mesh);

  /// Points into the vectors below.
  MeshStreams streams_;
  /// Three positions, four plane coefficients.
  std::vector<float> floats_[7];
  std::vector<float> normals_;
  /// Indices of vertices, by corner, then by triangle.
  std::vector<std::int32_t> indices_[3];
  /// 1 for each triangle whose vertices share a normal.
  std::vector<std::uint8_t> flat_;
  Sphere bound_;
  std::vector<Sphere> cover_;
  bool convex_ = false;
};

}  // namespace simcore::rendering
