// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <embree3/rtcore.h>

#include <cmath>
#include <span>

#include "robotlink/base/Geometry.h"
#include "simcore/rendering/DrawableMesh.h"
#include "simcore/rendering/RayFan.h"
#include "simcore/world/RenderScene.h"

namespace simcore::rendering {

/// A fan of rays in the frame of a tree. The fan must outlive it.
struct LocalFan {
  const RayFan& fan;
  /// Origin and axes of the fan's plane.
  Eigen::Vector3d origin, x, y;

  LocalFan(const RayFan& rays, const Pose3& frameInTree)
      : fan(rays),
        origin(frameInTree.translation()),
        x(frameInTree.linear().col(0)),
        y(frameInTree.linear().col(1)) {}
  /// The direction of a ray, unit length.
  Eigen::Vector3d direction(int ray) const {
    const Eigen::Vector2d& d = fan.directions()[static_cast<std::size_t>(ray)];
    return d.x() * x + d.y() * y;
  }
};

/// Intersects the rays `first` to `last` with a tree that has nothing nearer than `nearest`. Hits nearer than
/// the previous ones replace them.
void traceFan(RTCScene tree, const LocalFan& fan, int first, int last, double nearest,
              std::span<FanHit> hits);

/// The positions of spheres as seen from a fan, to select the rays that may hit them. Fan and frame must
/// outlive it. Used for one fan at a time.
class FanView {
 public:
  FanView(const RayFan& fan, const Pose3& frameInWorld);

  /// A quick test that is rarely wrong: false only if no ray meets the sphere before `maximum`.
  bool mayMeet(const Sphere& sphere, double maximum) const {
    const Eigen::Vector3d toCenter = sphere.center - origin_;
    const double farthest = maximum + sphere.radius;
    if (toCenter.squaredNorm() > farthest * farthest) return false;
    return !narrow_ ||
           (toCenter.dot(pastStart_) >= -sphere.radius && toCenter.dot(beforeEnd_) >= -sphere.radius);
  }

  /// Computes the rays that may meet a sphere; returns false if there are none. The results below are for
  /// that sphere.
  bool look(const Sphere& sphere);
  /// The least distance at which a ray may meet it.
  double nearest() const { return nearest_; }
  /// Calls `trace(first, last)` for each range of rays that may meet it.
  /// The ranges are inclusive and in increasing order of the angle within one turn.
  template <typename Trace>
  void forRays(Trace trace) const {
    const int last = static_cast<int>(fan_.size()) - 1;
    if (half_ >= robotlink::kPi) return trace(0, last);
    // The angular interval may wrap around, so it is tried one turn to either side.
    for (int turn = -1; turn <= 1; ++turn) {
      const double middle = middle_ + turn * 2 * robotlink::kPi - fan_.start();
      // A single ray is at angle 0.
      const double step = fan_.step() > 0 ? fan_.step() : 1;
      const double low = std::ceil((middle - half_) / step), high = std::floor((middle + half_) / step);
      if (high < 0 || low > last) continue;
      const int from = static_cast<int>(std::max(low, 0.0)),
                to = static_cast<int>(std::min<double>(high, last));
      if (from <= to) trace(from, to);
    }
  }

 private:
  const RayFan& fan_;
  const Pose3& frame_;
  /// pastStart_ and beforeEnd_ are the normals of the fan's edges, toward its inside.
  Eigen::Vector3d origin_, pastStart_, beforeEnd_;
  /// The fan spans at most half a turn; then its inside is what is inside both edges.
  bool narrow_ = false;
  /// Results of look(): least distance, and angular interval in the fan's plane.
  double nearest_ = 0, half_ = 0, middle_ = 0;
};

}  // namespace simcore::rendering
