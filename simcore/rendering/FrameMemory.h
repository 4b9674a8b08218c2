// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/rendering/CacheLines.h"
#include "simcore/rendering/KernelTypes.h"
#include "simcore/world/CameraModel.h"

namespace simcore::rendering {

/// The memory for rendering an image, kept from image to image and reallocated only for another size.
/// Everything it returns points into it and is valid until the next begin(). One thread at a time.
class FrameMemory {
 public:
  /// Reserves for the largest mesh (vertices and triangles), the sum of all triangles, and the number of
  /// lamps.
  FrameMemory(int vertices, int meshTriangles, int allTriangles, std::size_t lamps);

  /// Starts an image: nothing is drawn, the background's color is everywhere.
  VisibilityBuffer& begin(const CameraModel& camera, const float (&background)[3]);
  /// The image of the last begin(); empty before the first.
  const VisibilityBuffer& last() const { return buffer_; }
  /// How many rows are lit at a time, such that their data stay in the cache.
  int rowsPerStrip() const { return rowsPerStrip_; }
  /// A strip whose rows the caller sets.
  Strip strip();
  /// The lists of unsure pixels, one per lamp.
  std::vector<UnsurePixels>& unsure() { return unsure_; }

 private:
  /// Allocates for a new image size.
  void resize(const CameraModel& camera);

  VisibilityBuffer buffer_;
  // The memory to which buffer_ points.
  std::vector<TriangleRecord> records_;
  CacheLines<float> positions_, inverseDepths_, columns_, rows_;
  /// candidates_ is by triangle of the largest mesh, triangles_ by pixel.
  CacheLines<std::int32_t> candidates_, triangles_;
  // ranges_ is by vertex, boxes_ by triangle of the largest mesh.
  CacheLines<std::int64_t> ranges_, boxes_;
  int rowsPerStrip_ = 1;
  // The memory of a strip.
  CacheLines<float> light_, color_[3];
  // The memory of the lists of unsure pixels.
  std::vector<UnsurePixels> unsure_;
  std::vector<UnsureGroup> groups_;
  CacheLines<float> unsureFloats_;
  std::vector<std::int32_t> seen_;
};

}  // namespace simcore::rendering
