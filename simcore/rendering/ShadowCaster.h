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
  /// Adds the light of those rays that arrive to light[pixel].
  void addUnshadowed(std::size_t lamp, const RayList& rays, float* light);

 private:
  const RenderScene& scene_;
  std::span<const DrawableMesh> meshes_;
  BodyTree tree_;
  std::vector<LampGrid> grids_;
};

}  // namespace simcore::rendering
