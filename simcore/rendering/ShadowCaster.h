// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "simcore/rendering/BodyTree.h"
#include "simcore/rendering/DrawableMesh.h"
#include "simcore/rendering/KernelTypes.h"
#include "simcore/rendering/LampGrid.h"
#include "simcore/world/RenderScene.h"

namespace simcore::rendering {

/// Decides which pixels a lamp's light reaches: it has the tree for shadow rays and, for each lamp, the grid
/// that makes most of them unnecessary. Any number of threads may use it, but one alone during setPoses(),
/// which comes first; the scene and its drawable meshes must outlive it.
class ShadowCaster {
 public:
  ShadowCaster(const RenderScene& scene, std::span<const DrawableMesh> meshes, const Kernels& kernels);

  /// Sets the present poses of the bodies, by body index.
  void setPoses(std::span<const Pose3> bodyInWorld);
  /// The grid of a lamp, for shading.
  const LampGrid& grid(std::size_t lamp) const { return grids_[lamp]; }
  /// Adds the light of those unsure pixels that see the lamp; a row of the strip has `stride` pixels.
  ///
  /// One ray is traced for every four pixels. The other pixels take the result of their neighbors if these
  /// agree, and have their own ray otherwise: at the edges of shadows.
  void addUnshadowed(std::size_t lamp, UnsurePixels& pixels, int stride, float* light) const;

 private:
  /// Eight rays that are traced together.
  class Packet;

  const RenderScene& scene_;
  std::span<const DrawableMesh> meshes_;
  const Kernels& kernels_;
  BodyTree tree_;
  /// The tree over the bodies at the present poses.
  RTCScene placed_ = nullptr;
  std::vector<LampGrid> grids_;
};

}  // namespace simcore::rendering
