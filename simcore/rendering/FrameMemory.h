// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/rendering/KernelTypes.h"
#include "simcore/world/CameraModel.h"

namespace simcore::rendering {

/// The memory that drawing an image takes, kept from image to image and grown only when something larger is
/// drawn. What it hands out points into it and lives until the next begin().
class FrameMemory {
 public:
  /// The largest mesh, the sum of all triangles, and the number of lamps that an image may have.
  FrameMemory(int vertices, int meshTriangles, int allTriangles, std::size_t lamps);

  /// An empty image: nothing drawn, the background's colour everywhere.
  VisibilityBuffer& begin(const CameraModel& camera, const float (&background)[3]);
  /// The image that was begun last; empty before the first.
  const VisibilityBuffer& last() const { return buffer_; }
  /// Rows that are lit at a time: so many that they stay in the cache.
  int rowsPerStrip() const { return rowsPerStrip_; }
  /// A strip without rows yet.
  Strip strip();
  /// By lamp.
  std::vector<UnsurePixels>& unsure() { return unsure_; }

 private:
  void resize(const CameraModel& camera);

  VisibilityBuffer buffer_;
  std::vector<TriangleRecord> records_;
  std::vector<float> positions_, normals_, inverseDepths_, columns_, rows_;
  std::vector<std::int32_t> candidates_, triangles_;
  int rowsPerStrip_ = 1;
  std::vector<float> light_, color_[3];
  std::vector<UnsurePixels> unsure_;
  std::vector<UnsureGroup> groups_;
  std::vector<float> unsureFloats_;
  std::vector<std::int32_t> seen_;
};

}  // namespace simcore::rendering
