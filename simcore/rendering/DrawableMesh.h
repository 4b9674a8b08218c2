// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/rendering/KernelTypes.h"
#include "simcore/world/RenderScene.h"

namespace simcore::rendering {

/// A sphere in some frame, metres.
struct Sphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0;
};

/// A mesh in the form that the kernels read, with what is known about its shape. Immutable; its frame is the
/// mesh's. Triangles without an area, or with an index past the vertices, are left out.
class DrawableMesh {
 public:
  explicit DrawableMesh(const Mesh& mesh);
  DrawableMesh(const DrawableMesh&) = delete;
  DrawableMesh(DrawableMesh&&) = default;

  const MeshStreams& streams() const { return streams_; }
  /// Encloses all vertices.
  const Sphere& bound() const { return bound_; }
  /// A few smaller spheres that together enclose the mesh.
  const std::vector<Sphere>& cover() const { return cover_; }
  /// Closed round a convex body, so that no lamp-facing part of it is in its own shadow.
  bool convex() const { return convex_; }

 private:
  void fillVertices(const Mesh& mesh);
  void fillTriangles(const Mesh& mesh);
  void findBounds(const Mesh& mesh);
  void findConvexity(const Mesh& mesh);

  MeshStreams streams_;
  std::vector<float> floats_[10];
  std::vector<std::int32_t> indices_[3];
  std::vector<std::uint8_t> flat_;
  Sphere bound_;
  std::vector<Sphere> cover_;
  bool convex_ = false;
};

}  // namespace simcore::rendering
