// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <span>
#include <vector>

#include "simcore/world/RenderScene.h"

namespace simcore::rendering {

/// A device for scenes that one thread uses; its settings are in the source.
RTCDevice newRayDevice();

enum class Contents {
  kCasters,  ///< instances that cast shadows
  kEverything,
};

/// Makes trees over the wanted instances of bodies, each in its body's frame. Bodies that look alike, as the
/// same parts of several robots do, share one tree, so that it stays in the processor's cache. Device and
/// scene must outlive it.
class BodyTrees {
 public:
  BodyTrees(RTCDevice device, const RenderScene& scene, Contents contents)
      : device_(device), scene_(scene), contents_(contents) {}
  ~BodyTrees();
  BodyTrees(const BodyTrees&) = delete;
  BodyTrees& operator=(const BodyTrees&) = delete;

  /// The tree of a body, or null if nothing of it is wanted. The caller releases it, whether it is shared or
  /// not.
  RTCScene treeOf(int body);

 private:
  /// What is on a body: mesh and pose of each instance, one after the other.
  using Content = std::vector<double>;
  struct Tree {
    Content content;
    RTCScene scene;
  };
  bool isWanted(const RenderInstance& instance, int body) const;
  Content contentOf(int body) const;
  RTCScene build(int body) const;

  RTCDevice device_;
  const RenderScene& scene_;
  Contents contents_;
  std::vector<Tree> trees_;
};

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
  void addBody(BodyTrees& trees, int body);

  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::vector<Body> bodies_;
  bool changed_ = true;
};

}  // namespace simcore::rendering
