// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <span>
#include <vector>

#include "simcore/world/RenderScene.h"

namespace simcore::rendering {

/// The instruction sets by which rays are traced. Results differ in the last bits for some rays.
enum class RayInstructions { kAvx2, kSse2 };
/// AVX2 if the processor has it.
RayInstructions fastestRayInstructions();
/// Creates an Embree device for scenes that one thread uses; its settings are in the source. The processor
/// must have the instructions. The caller releases it.
RTCDevice newRayDevice(RayInstructions instructions = fastestRayInstructions());

/// Selects the instances of a body that a tree contains.
enum class Contents {
  /// Only instances that cast shadows, for shadow rays.
  kCasters,
  /// All instances, for range sensors.
  kEverything,
};

/// Builds Embree trees of the instances on bodies, each in its body's frame. Bodies that look alike, such as
/// the same parts of several robots, share one tree, so that it stays in the processor's cache. Device and
/// scene must outlive it. One thread at a time.
class BodyTrees {
 public:
  BodyTrees(RTCDevice device, const RenderScene& scene, Contents contents)
      : device_(device), scene_(scene), contents_(contents) {}
  ~BodyTrees();
  BodyTrees(const BodyTrees&) = delete;
  BodyTrees& operator=(const BodyTrees&) = delete;

  /// The tree of a body; null if the body has no instances of the wanted kind. The caller releases it,
  /// whether it is shared or not.
  RTCScene treeOf(int body);

 private:
  /// Identifies what is on a body: mesh index and pose of each instance, one after the other.
  using Content = std::vector<double>;
  /// A finished tree and what it was built from.
  struct Tree {
    Content content;
    /// Released by the destructor; callers have references of their own.
    RTCScene scene;
  };
  bool isWanted(const RenderInstance& instance, int body) const;
  /// The key by which equal bodies are found.
  Content contentOf(int body) const;
  /// Builds a new tree.
  RTCScene build(int body) const;

  RTCDevice device_;
  const RenderScene& scene_;
  Contents contents_;
  /// Few enough for a linear search.
  std::vector<Tree> trees_;
};

/// The number of bodies that the scene names or uses.
int bodyCount(const RenderScene& scene);

/// Bounding-volume trees of Embree over the casters of shadows in a scene: one for each body, in the body's
/// frame and built once, and one over all bodies, rebuilt when they have moved.
///
/// setPoses() is cheap; the tree over the bodies is rebuilt by the next call of scene(). One thread at a
/// time.
class BodyTree {
 public:
  /// The scene is needed only during construction.
  explicit BodyTree(const RenderScene& scene);
  ~BodyTree();
  BodyTree(const BodyTree&) = delete;
  BodyTree& operator=(const BodyTree&) = delete;

  /// Sets poses by body index; pose 0, that of the world, is ignored. Bodies beyond the end of the span keep
  /// their poses.
  void setPoses(std::span<const Pose3> bodyInWorld);
  /// The tree over the bodies at their present poses; valid until the next setPoses().
  RTCScene scene();

 private:
  /// An instance of a body's tree in scene_.
  struct Body {
    RTCGeometry geometry = nullptr;
    int index = 0;
  };
  /// Adds a body, unless it has no casters.
  void addBody(BodyTrees& trees, int body);

  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::vector<Body> bodies_;
  /// Whether scene_ must be committed before it is used.
  bool changed_ = true;
};

}  // namespace simcore::rendering
