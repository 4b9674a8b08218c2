// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/rendering/DrawableMesh.h"
#include "simcore/rendering/KernelTypes.h"
#include "simcore/world/RenderScene.h"

namespace simcore::rendering {

/// What a lamp sees around it, coarsely: for each cell of a cube's six faces, how near anything that casts
/// shadows may come. A point nearer than that is lit without asking for a ray. All bounds err to the side of
/// asking.
///
/// Faces are +x, -x, +y, -y, +z, -z of the world; a direction's cell coordinates (u, v) are its other two
/// components, in the order x, y, z, divided by the largest. One thread at a time.
class LampGrid {
 public:
  static constexpr int kSize = 96;

  explicit LampGrid(Eigen::Vector3d lampInWorld);

  /// A caster that never moves, by its triangles; before the first call of beginMoving().
  void addStatic(const Mesh& mesh, const Pose3& meshInWorld, int instance);
  /// Forgets the moving casters.
  void beginMoving();
  void addMoving(const Sphere& sphereInWorld, int instance);

  const LampCell* cells() const { return cells_.data(); }
  /// Squared lower bound for the rays in the direction of a point, leaving out one instance (or -1); for
  /// tests.
  double nearest(const Eigen::Vector3d& pointInWorld, int withoutInstance) const;

 private:
  struct Rectangle {
    int face, u0, u1, v0, v1;
  };
  struct Triangle {
    Eigen::Vector3d a, b, c;  ///< relative to the lamp
  };
  static std::size_t rectanglesAround(const Eigen::Vector3d& center, double radius,
                                      Rectangle (&rectangles)[6]);
  void addTriangle(const Triangle& t, int instance, int depth);
  void addPiece(const Triangle& t, int instance);

  Eigen::Vector3d lamp_;
  std::vector<LampCell> static_;
  std::vector<LampCell> cells_;
  std::vector<Rectangle> touched_;
  bool moving_ = false;
};

}  // namespace simcore::rendering
