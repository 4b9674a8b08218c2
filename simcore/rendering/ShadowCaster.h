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

/// What keeps the lamps' light from the pixels: the tree for the rays and, for each lamp, the grid that
/// spares most of them. One thread at a time; the scene and its drawable meshes must outlive it.
class ShadowCaster {
 public:
  ShadowCaster(const RenderScene& scene, std::span<const DrawableMesh> meshes, const Kernels& kernels);

  void setPoses(std::span<const Pose3> bodyInWorld);
  const LampCell* cells(std::size_t lamp) const { return grids_[lamp].cells(); }
  /// Adds the light of those unsure pixels that the lamp sees; `stride` pixels make a row of the strip.
  ///
  /// One ray is traced for every four pixels. The other pixels take their neighbors' result where these
  /// agree, and have their own ray elsewhere: at the edges of shadows.
  void addUnshadowed(std::size_t lamp, UnsurePixels& pixels, int stride, float* light);

 private:
  class Packet;

  const RenderScene& scene_;
  std::span<const DrawableMesh> meshes_;
  const Kernels& kernels_;
  BodyTree tree_;
  std::vector<LampGrid> grids_;
  std::vector<std::int32_t>
      traced_;  ///< as Kernels::settle() takes it, with a row and a bit more on either side
};

}  // namespace simcore::rendering
