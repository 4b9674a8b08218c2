// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace simcore {

/// Rays from one point in any directions, arranged in rows and columns, such as the pixels of a camera or the
/// facettes of an eye. Neighbors are traced together. Immutable.
class RayBundle {
 public:
  /// Eight rays and the cone around them.
  struct Packet {
    /// Unit vectors in the bundle's frame; lanes beyond the last ray repeat it.
    std::array<std::array<float, 8>, 3> direction;
    std::array<std::int32_t, 8> ray;
    int count = 0;
  };
  /// The directions within an angle around an axis.
  struct Cone {
    Eigen::Vector3f axis;
    float cosHalf = 1, sinHalf = 0;
    /// Half a right angle or more: then everything counts as inside.
    bool wide = false;
  };
  /// Neighboring packets.
  struct Group {
    std::size_t first = 0, last = 0;
    Cone cone;
  };

  /// `directions`, row by row, are rows * columns vectors of any length but 0.
  RayBundle(int rows, int columns, const std::vector<Eigen::Vector3d>& directions);

  std::size_t size() const { return size_; }
  const std::vector<Packet>& packets() const { return packets_; }
  const std::vector<Cone>& cones() const { return cones_; }
  const std::vector<Group>& groups() const { return groups_; }

 private:
  std::size_t size_ = 0;
  std::vector<Packet> packets_;
  /// Keyed by packet.
  std::vector<Cone> cones_;
  std::vector<Group> groups_;
};

/// The hit of a ray of a bundle.
struct BundleHit {
  /// The maximum if there is no hit.
  float distance = 0;
  /// Index in RenderScene::instances; -1 if there is no hit.
  std::int32_t instance = -1;
  /// The triangle of the instance's mesh, and where it was hit: the point is (1 - u - v) * a + u * b + v * c.
  std::uint32_t triangle = 0;
  float u = 0, v = 0;
};

}  // namespace simcore
