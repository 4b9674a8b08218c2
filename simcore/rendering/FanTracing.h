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

/// A fan in the frame of the tree that it meets. The fan must outlive it.
struct LocalFan {
  const RayFan& fan;
  Eigen::Vector3d origin, x, y;

  LocalFan(const RayFan& rays, const Pose3& frameInTree)
      : fan(rays),
        origin(frameInTree.translation()),
        x(frameInTree.linear().col(0)),
        y(frameInTree.linear().col(1)) {}
  Eigen::Vector3d direction(int ray) const {
    const Eigen::Vector2d& d = fan.directions()[static_cast<std::size_t>(ray)];
    return d.x() * x + d.y() * y;
  }
};

/// Lets the rays from `first` to `last` meet a tree of which nothing is nearer than `nearest`; hits that are
/// nearer than those before take their places.
void traceFan(RTCScene tree, const LocalFan& fan, int first, int last, double nearest,
              std::span<FanHit> hits);

/// Where spheres in the world are, seen from a fan. Fan and frame must outlive it.
class FanView {
 public:
  FanView(const RayFan& fan, const Pose3& frameInWorld);

  /// Quickly and often right: false only if no ray meets the sphere before `maximum`.
  bool mayMeet(const Sphere& sphere, double maximum) const {
    const Eigen::Vector3d toCenter = sphere.center - origin_;
    const double farthest = maximum + sphere.radius;
    if (toCenter.squaredNorm() > farthest * farthest) return false;
    return !narrow_ ||
           (toCenter.dot(pastStart_) >= -sphere.radius && toCenter.dot(beforeEnd_) >= -sphere.radius);
  }

  /// False if no ray can meet the sphere; else the rest is about this sphere.
  bool look(const Sphere& sphere);
  double nearest() const { return nearest_; }  ///< at which a ray may meet it
  /// Calls `trace(first, last)` for each stretch of rays that may meet it.
  template <typename Trace>
  void forRays(Trace trace) const {
    const int last = static_cast<int>(fan_.size()) - 1;
    if (half_ >= robotlink::kPi) return trace(0, last);
    for (int turn = -1; turn <= 1; ++turn) {
      const double middle = middle_ + turn * 2 * robotlink::kPi - fan_.start();
      // A ray alone lies at 0.
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
  Eigen::Vector3d origin_, pastStart_, beforeEnd_;  // normals of the fan's edges, to its inside
  bool narrow_ = false;  // half a turn at most: it is what lies inside of both edges
  double nearest_ = 0, half_ = 0, middle_ = 0;
};

}  // namespace simcore::rendering
