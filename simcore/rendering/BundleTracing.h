// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <embree3/rtcore.h>

#include <span>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "simcore/rendering/RayBundle.h"

namespace simcore::rendering {

/// A tree of triangles at its place, for bundles of rays.
struct BundleTarget {
  RTCScene tree = nullptr;
  /// In the bundle's frame: the center of its bounding sphere.
  Eigen::Vector3f center;
  float radius = 0;
  /// The least distance at which a ray may meet it, and the angle under which its sphere is seen; all
  /// directions meet it if it is around the origin.
  float nearest = 0, cosSeen = 0, sinSeen = 1;
  bool around = false;
  /// The instance of each geometry of the tree.
  const std::vector<std::int32_t>* instances = nullptr;
  const robotlink::Pose3 *treeInWorld = nullptr, *bundleInWorld = nullptr;
  /// The rotation from the bundle's frame to that of the tree, after prepare().
  Eigen::Matrix3f rotation;
  Eigen::Vector3f origin;
  bool isPrepared = false;

  /// The poses and the instances must outlive it.
  BundleTarget(RTCScene of, const Eigen::Vector3d& centerInBundle, double radiusOf,
               const robotlink::Pose3& treeInWorldOf, const robotlink::Pose3& bundleInWorldOf,
               const std::vector<std::int32_t>& instancesOf);
  /// Call this before rays are traced to it; most targets are never met.
  void prepare();
};

/// Sets hits[i] to the first hit of ray i before `maximum`. The packets are pruned by the cones around groups
/// of rays, so that few of them meet each tree.
void traceBundle(const RayBundle& bundle, std::vector<BundleTarget>& targets, float maximum,
                 std::span<BundleHit> hits);

}  // namespace simcore::rendering
