// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "simcore/RenderScene.h"
#include "simcore/rendering/BodyTree.h"
#include "simcore/rendering/DrawableMesh.h"
#include "simcore/rendering/KernelTypes.h"
#include "simcore/rendering/LampGrid.h"

namespace simcore::rendering {

/// What keeps the lamps' light from the pixels: the tree for the rays and, for each lamp, the grid that
/// spares most of them. One thread at a time; the scene and its drawable meshes must outlive it.
class ShadowCaster {
 public:
  ShadowCaster(const RenderScene& scene, std::span<const DrawableMesh> meshes);

  void setPoses(std::span<const Pose3> bodyInWorld);
  const LampCell* cells(std::size_t lamp) const { return grids_[lamp].cells(); }
  /// Adds the light of those rays that arrive to light[pixel]; `stride` pixels make a row of the strip,
  /// `pixels` all.
  ///
  /// Of every four pixels one has its ray traced at once. The others do as their neighbours among those where
  /// these lie on the same convex instance and agree, and have their own ray elsewhere: at the edges of
  /// shadows and bodies.
  void addUnshadowed(std::size_t lamp, const RayList& rays, int stride, int pixels, float* light);

 private:
  class Packet;
  int witness(const RayList& rays, int ray, int stride) const;

  const RenderScene& scene_;
  std::span<const DrawableMesh> meshes_;
  BodyTree tree_;
  std::vector<LampGrid> grids_;
  /// By pixel of a strip with a row more on either side: 0, or where a ray was traced 2 * instance + 2, and 1
  /// if it arrived.
  std::vector<std::int32_t> traced_;
};

}  // namespace simcore::rendering
