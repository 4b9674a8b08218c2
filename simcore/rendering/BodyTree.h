// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <span>
#include <vector>

#include "simcore/RenderScene.h"

namespace simcore::rendering {

/// A device for scenes that one thread uses; its settings are in the source.
RTCDevice newRayDevice();

enum class Contents {
  kCasters,  ///< instances that cast shadows
  kEverything,
};

/// A tree over the wanted instances of a body, in the body's frame, or null if there are none. The caller
/// releases it.
RTCScene newBodyScene(RTCDevice device, const RenderScene& scene, int body, Contents contents);

/// One more than the largest index of a body that the scene names or uses.
int bodyCount(const RenderScene& scene);

/// Bounding-volume trees of Embree over what casts shadows in a scene: one for each body, in the body's frame
/// and built once, and one over the bodies, built anew when they have moved.
///
/// setPoses() is cheap; the tree over the bodies is built by the next call of scene(). One thread at a time.
class BodyTree {
 public:
  explicit BodyTree(const RenderScene& scene);
  ~BodyTree();
  BodyTree(const BodyTree&) = delete;
  BodyTree& operator=(const BodyTree&) = delete;

  /// By body index; pose 0, the world's, is not looked at. Bodies past the end of the span stay where they
  /// are.
  void setPoses(std::span<const Pose3> bodyInWorld);
  /// The tree over the bodies, where they are now.
  RTCScene scene();

 private:
  struct Body {
    RTCGeometry geometry = nullptr;
    int index = 0;
  };
  void addBody(const RenderScene& scene, int body);

  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::vector<Body> bodies_;
  bool changed_ = true;
};

}  // namespace simcore::rendering
