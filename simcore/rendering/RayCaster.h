// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "simcore/rendering/RayFan.h"
#include "simcore/world/RenderScene.h"

namespace simcore {

/// Measures distances in a scene, as a PSD, a sonar, or a laser does: how far it is along a ray to the first
/// surface, seen from either side, of the drawn triangles (shadow or not). Units are metres, everything is in
/// the world's frame.
///
/// A few rays cost about a microsecond each, and new poses cost next to nothing: each body has its tree in
/// its own frame, built once; there is none over the bodies. Any number of threads may ask at once; none may
/// while setPoses() runs.
class RayCaster {
 public:
  struct Hit {
    double distance = 0;
    int body = 0;  ///< index in RenderScene::bodies
  };

  /// Copies what it needs of the scene.
  explicit RayCaster(const std::shared_ptr<const RenderScene>& scene);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// Where the bodies are now, by body index; at first all are at the origin. The world, body 0, stays there.
  void setPoses(std::span<const Pose3> bodyInWorld);

  /// The first hit at a distance in (0, maximum]. The direction's length does not matter, but must not be 0.
  /// Bodies in `excluded` (those of the robot that measures, say) let rays pass.
  std::optional<Hit> firstHit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double maximum,
                              std::span<const int> excluded = {}) const;

  /// The first hits of all rays of a fan in the plane of `frame`'s x and y, from its origin; hits.size() must
  /// be fan.size(). `excluded` bodies, from the first to before the last, let rays pass. Some 0.1
  /// microseconds a ray.
  struct BodyRange {
    int first = 0, last = 0;
  };
  void castFan(const RayFan& fan, const Pose3& frameInWorld, double maximum, BodyRange excluded,
               std::span<FanHit> hits) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace simcore
