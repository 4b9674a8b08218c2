// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "simcore/rendering/RayBundle.h"
#include "simcore/rendering/RayFan.h"
#include "simcore/world/RenderScene.h"

namespace simcore {

/// Measures distances in a scene as distance sensors, sonars and lasers do: along a ray to the first surface,
/// seen from either side, of the drawn triangles (shadow or not). Meters, in the world's frame.
///
/// A few single rays cost about a microsecond each, and new poses almost nothing: each body has its own tree
/// in its frame, built once, and there is no tree over the bodies. Any number of threads may measure at the
/// same time, but not during setPoses().
class RayCaster {
  /// The hit of a ray.
 public:
  struct Hit {
    double distance = 0;
    /// Index in RenderScene::bodies.
    int body = 0;
  };

  /// Copies what it needs from the scene.
  explicit RayCaster(const std::shared_ptr<const RenderScene>& scene);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// Sets the present poses of the bodies by body index; initially all are at the origin. Body 0, the world,
  /// stays there.
  void setPoses(std::span<const Pose3> bodyInWorld);

  /// The first hit at a distance in (0, maximum]. The direction may have any length but 0. Rays pass through
  /// the bodies in `excluded` (such as those of the measuring robot).
  std::optional<Hit> firstHit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double maximum,
                              std::span<const int> excluded = {}) const;

  /// Bodies `first` up to `last`, exclusive.
  struct BodyRange {
    int first = 0, last = 0;
  };
  /// Computes the first hits of all rays of a fan in the x-y plane of `frameInWorld`, from its origin;
  /// hits.size() must be fan.size(). Rays pass through the `excluded` bodies. Some 0.1 microseconds per ray.
  void castFan(const RayFan& fan, const Pose3& frameInWorld, double maximum, BodyRange excluded,
               std::span<FanHit> hits) const;
  /// Computes the first hits of all rays of a bundle from the origin of `frameInWorld`; hits.size() must be
  /// bundle.size(). Rays pass through the `excluded` bodies. Some 0.1 microseconds per ray.
  void castBundle(const RayBundle& bundle, const Pose3& frameInWorld, double maximum, BodyRange excluded,
                  std::span<BundleHit> hits) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace simcore
