// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/rendering/Float8.h"
#include "simcore/rendering/KernelTypes.h"

// Transforms a mesh and selects the triangles that may cover pixels, before anything else is computed of
// them. Included only by the two Kernels*.cpp.
//
// Most triangles end here: they show their inner side, or lie between the centers of pixels. Of the others
// the box of pixels is known then. It is found from the range of each vertex, four numbers of 16 bits, whose
// minima over the corners are the box.
namespace simcore::rendering {
namespace {

/// The projection's rounding errors are far smaller, pixels.
constexpr float kPixelMargin = 0.001F;
/// Larger images do not fit into 16 bits.
constexpr int kMaxBoundedSize = 32000;

using Short16 = std::int16_t __attribute__((vector_size(32)));
using Long4 = std::int64_t __attribute__((vector_size(32)));
using ULong4 = std::uint64_t __attribute__((vector_size(32)));

/// Fills the last group of eight with repeated numbers.
SIMCORE_INLINE void padCandidates(std::int32_t* candidates, int count) {
  for (int i = 0; i < 7 && count > 0; ++i) candidates[count + i] = candidates[count - 1];
}

/// Collects the indices of triangles whose outer side faces the camera, and repeats the last one to fill a
/// group of eight; returns their number.
SIMCORE_INLINE int collectFrontFaces(const DrawJob& job, std::int32_t* candidates) {
  const MeshStreams& mesh = *job.mesh;
  // In the mesh's frame, so that planes need not be transformed.
  const Vector8 camera = splatVector(job.cameraInMesh);
  Int8 index = {0, 1, 2, 3, 4, 5, 6, 7};
  int count = 0;
  // The camera sees a triangle's outer side if it is above the triangle's plane. The position of the camera
  // relative to the planes of eight triangles at a time.
  for (int at = 0; at < mesh.triangleGroups * 8; at += 8, index += 8) {
    const auto height = load<Float8>(mesh.plane[0] + at) * camera.x +
                        load<Float8>(mesh.plane[1] + at) * camera.y +
                        load<Float8>(mesh.plane[2] + at) * camera.z - load<Float8>(mesh.plane[3] + at);
    count += storeSelected(candidates + count, index, bits(height > splat(0)));
  }
  padCandidates(candidates, count);
  return count;
}

/// Stores eight points as four floats each; the fourth is 0.
SIMCORE_INLINE void storeTransposed(float* to, Float8 x, Float8 y, Float8 z) {
  const Rows4 t = transposed(x, y, z, splat(0));
  for (int i = 0; i < 4; ++i) {
    store(to + 4 * i, lowHalf(t.rows[i]));
    store(to + 4 * (i + 4), highHalf(t.rows[i]));
  }
}

/// Stores the first column and row whose pixels' centers are not before each of eight points, and the negated
/// last ones whose centers are not beyond it; those of points beside the image are beside it, too.
SIMCORE_INLINE void storeRanges(const VisibilityBuffer& buffer, Float8 x, Float8 y, Float8 z,
                                std::int64_t* to) {
  const auto width = static_cast<float>(buffer.width), height = static_cast<float>(buffer.height);
  const Float8 inverse = 1.0F / x, half = splat(0.5F - kPixelMargin), zero = splat(0);
  const Float8 px = width / 2 - buffer.focalX * y * inverse, py = height / 2 - buffer.focalY * z * inverse;
  const Int8 firstX = truncated(maximum(minimum(px + half, splat(width)), zero));
  const Int8 firstY = truncated(maximum(minimum(py + half, splat(height)), zero));
  const Float8 endX = px - half, endY = py - half;
  const Int8 one = splatInt(1);
  const Int8 lastX = endX < zero ? one : -truncated(minimum(endX, splat(width - 1)));
  const Int8 lastY = endY < zero ? one : -truncated(minimum(endY, splat(height - 1)));
  const Int8 first = firstX | firstY << 16, last = (lastX & 0xFFFF) | lastY << 16;
  store(to, __builtin_shufflevector(first, last, 0, 8, 1, 9, 2, 10, 3, 11));
  store(to + 4, __builtin_shufflevector(first, last, 4, 12, 5, 13, 6, 14, 7, 15));
}

/// Transforms the mesh's vertices to the camera's frame, four floats each, and projects them if `ranges` is
/// not null.
SIMCORE_INLINE void transformVertices(const DrawJob& job, const VisibilityBuffer& buffer,
                                      std::int64_t* ranges) {
  const MeshStreams& mesh = *job.mesh;
  // The matrix with each element in all lanes.
  Float8 m[3][4];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) m[i][k] = splat(job.meshInCamera[i][k]);
  }
  for (int at = 0; at < mesh.vertexGroups * 8; at += 8) {
    const auto x = load<Float8>(mesh.position[0] + at), y = load<Float8>(mesh.position[1] + at),
               z = load<Float8>(mesh.position[2] + at);
    Vector8 v;
    v.x = m[0][0] * x + m[0][1] * y + m[0][2] * z + m[0][3];
    v.y = m[1][0] * x + m[1][1] * y + m[1][2] * z + m[1][3];
    v.z = m[2][0] * x + m[2][1] * y + m[2][2] * z + m[2][3];
    storeTransposed(buffer.positions + 4 * at, v.x, v.y, v.z);
    if (ranges != nullptr) storeRanges(buffer, v.x, v.y, v.z, ranges + at);
  }
}

/// The boxes of pixels that four triangles may cover, each as four numbers.
SIMCORE_INLINE Long4 boxesOf(const MeshStreams& mesh, const std::int64_t* ranges,
                             const std::int32_t* triangles) {
  Short16 corner[3];
  for (int k = 0; k < 3; ++k) {
    const std::int32_t* const index = mesh.index[k];
    const Long4 four = {ranges[index[triangles[0]]], ranges[index[triangles[1]]], ranges[index[triangles[2]]],
                        ranges[index[triangles[3]]]};
    corner[k] = reinterpret_cast<Short16>(four);
  }
  const Short16 two = corner[0] < corner[1] ? corner[0] : corner[1];
  return reinterpret_cast<Long4>(two < corner[2] ? two : corner[2]);
}

/// A bit for each of four boxes that is not empty.
SIMCORE_INLINE unsigned nonempty(Long4 boxes) {
  // In the upper half of each lane the first column and row minus the last ones.
  const Short16 difference = reinterpret_cast<Short16>(boxes << 32) + reinterpret_cast<Short16>(boxes);
  const Short16 empty = difference > 0;
  const auto isEmpty = reinterpret_cast<ULong4>(empty) >> 32 == 0;
  return bits(reinterpret_cast<Mask4>(isEmpty));
}

/// Removes the candidates that cover no pixel's center, and stores the boxes of the others; returns their
/// number.
SIMCORE_INLINE int selectCovering(const DrawJob& job, const VisibilityBuffer& buffer, int count) {
  std::int32_t* const candidates = buffer.candidates;
  int selected = 0;
  // Without branches on which candidates remain, which the processor could hardly predict.
  for (int i = 0; i < count; i += 8) {
    const auto triangles = load<Int8>(candidates + i);
    const Long4 low = boxesOf(*job.mesh, buffer.ranges, candidates + i),
                high = boxesOf(*job.mesh, buffer.ranges, candidates + i + 4);
    unsigned lanes = nonempty(low) | nonempty(high) << 4;
    if (count - i < 8) lanes &= (1U << (count - i)) - 1;
    // Except where all are smaller than pixels.
    if (lanes == 0) continue;
    storeSelected(candidates + selected, triangles, lanes);
    selected += storeSelected(buffer.boxes + selected, low, lanes & 15);
    selected += storeSelected(buffer.boxes + selected, high, lanes >> 4);
  }
  padCandidates(candidates, selected);
  return selected;
}

}  // namespace
}  // namespace simcore::rendering
