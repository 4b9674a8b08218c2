// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/rendering/DrawableMesh.h"
#include "simcore/rendering/KernelTypes.h"
#include "simcore/world/RenderScene.h"

namespace simcore::rendering {

/// A coarse map of a lamp's surroundings: for each cell of the six faces of a cube around it, a lower bound
/// of the distance of casters of shadows. A point nearer than that is lit without tracing a ray. All bounds
/// err on the safe side: rather a ray too many.
///
/// The faces are +x, -x, +y, -y, +z, -z of the world. The cell coordinates (u, v) of a direction are its two
/// other components, in the order x, y, z, divided by the largest one. One thread at a time.
class LampGrid {
 public:
  /// Cells along the side of a face.
  static constexpr int kSize = 96;

  explicit LampGrid(Eigen::Vector3d lampInWorld);

  /// Adds a caster that never moves, by its triangles. Only before the first beginMoving().
  void addStatic(const Mesh& mesh, const Pose3& meshInWorld, int instance);
  /// Removes the moving casters of the last image.
  void beginMoving();
  /// Adds a part of a moving caster by a sphere that contains it.
  void addMoving(const Sphere& sphereInWorld, int instance);

  /// The cells of all faces, row by row, and the `nearest` of each by itself, which fits into a processor's
  /// cache; valid until the grid is destroyed.
  const LampCell* cells() const { return cells_.data(); }
  const float* nearest() const { return nearest_.data(); }
  /// For tests: the squared lower bound in the direction of a point, without one instance (or -1 for none).
  double nearest(const Eigen::Vector3d& pointInWorld, int withoutInstance) const;

 private:
  /// Cells of a face, inclusive.
  struct Rectangle {
    int face, u0, u1, v0, v1;
  };
  struct Triangle {
    /// Relative to the lamp.
    Eigen::Vector3d a, b, c;
  };
  /// The cells in which a sphere is seen.
  static std::size_t rectanglesAround(const Eigen::Vector3d& center, double radius,
                                      Rectangle (&rectangles)[6]);
  /// Splits a triangle into small pieces.
  void addTriangle(const Triangle& t, int instance, int depth);
  /// Takes cells over from the static ones.
  void restore(std::size_t first, std::size_t last);
  /// Enters a small triangle into the static cells.
  void addPiece(const Triangle& t, int instance);

  Eigen::Vector3d lamp_;
  // Static casters only, and all casters.
  std::vector<LampCell> static_;
  std::vector<LampCell> cells_;
  std::vector<float> nearest_;
  /// The cells that moving casters have changed, to restore them.
  std::vector<Rectangle> touched_;
  bool moving_ = false;
};

}  // namespace simcore::rendering
