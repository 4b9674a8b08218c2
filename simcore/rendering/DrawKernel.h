// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/rendering/Float8.h"
#include "simcore/rendering/KernelTypes.h"
#include "simcore/rendering/SelectKernel.h"

// Draws a mesh into the visibility buffer. Edge functions are homogeneous (Olano and Greer 1997: the sign of
// the volume spanned by a pixel's ray and an edge), so nothing is ever clipped: a triangle may pass through
// the camera. Included only by the two Kernels*.cpp.
//
// The steps for a mesh: collect the triangles that face the camera; transform the vertices; then for eight
// triangles at a time compute pixel boxes, edge functions and planes, and draw each triangle row by row,
// eight pixels at a time, where it is nearer than what was drawn before. Normals and color are not
// interpolated here: a record per triangle has what the lighting of its pixels needs.
namespace simcore::rendering {
namespace {

/// Eight triangles after setup, ready to be drawn. For each triangle there are four linear functions of a
/// pixel's ray d: those of the three edges, and 1 / depth, with the factors of d.x in x, and so on.
struct Setup {
  alignas(32) float x[8][4], y[8][4], z[8][4];
  /// A pixel is inside where the edge functions are greater: just below 0 for edges that own the pixels on
  /// them, otherwise 0.
  float threshold[8][4];
  // The box of pixels that may be covered, inclusive; only for meshes without boxes of their own.
  std::int32_t x0[8], x1[8], y0[8], y1[8];
  // Index of the triangle in the mesh.
  std::int32_t triangle[8];
};

/// Groups of eight pixels begin at multiples of eight, so that one that was stored is loaded as a whole.
constexpr int kAligned = ~7;

/// The cross product of two points, computed such that it is exactly negated when they are exchanged, and
/// precise when they are close together. So two triangles that share an edge leave no gap and no overlap.
SIMCORE_INLINE Vector8 edgeBetween(const Vector8& a, const Vector8& b) {
  return cross(a + b, b - a);
}

/// Loads corner `index` of eight triangles, one triangle a lane.
SIMCORE_INLINE Vector8 loadCorner(const float* positions, const std::int32_t* index,
                                  const std::int32_t* triangles) {
  // Four floats per vertex, so one transposition loads three components of eight vertices.
  const float* at[8];
  for (int i = 0; i < 8; ++i) at[i] = positions + 4 * index[triangles[i]];
  const Rows4 t = loadTransposed(at);
  return {t.rows[0], t.rows[1], t.rows[2]};
}

/// Computes the box of pixels whose centers may be covered, in each lane; returns the lanes in which it is
/// not empty. For meshes that are not entirely in front of the camera, and for very large images.
SIMCORE_INLINE Int8 boundPixels(const Vector8 (&v)[3], const VisibilityBuffer& buffer, bool inFront,
                                Setup& setup) {
  const Float8 zero = splat(0);
  const auto width = static_cast<float>(buffer.width), height = static_cast<float>(buffer.height);
  // Projection to pixel coordinates.
  Float8 px[3], py[3];
  for (int i = 0; i < 3; ++i) {
    // Meaningless for points behind the camera, which are handled below.
    const Float8 inverse = 1.0F / v[i].x;
    px[i] = width / 2 - buffer.focalX * v[i].y * inverse;
    py[i] = height / 2 - buffer.focalY * v[i].z * inverse;
  }
  Float8 left = minimum(px[0], px[1], px[2]), right = maximum(px[0], px[1], px[2]);
  Float8 top = minimum(py[0], py[1], py[2]), bottom = maximum(py[0], py[1], py[2]);
  // All lanes, if the whole mesh is in front of the camera.
  Int8 seen = splatInt(-1);
  if (!inFront) {
    // A triangle that crosses the camera's plane may be anywhere.
    const Int8 crosses = minimum(v[0].x, v[1].x, v[2].x) < splat(1e-4F);
    // Nothing is visible if all corners are behind the camera.
    seen = maximum(v[0].x, v[1].x, v[2].x) > zero;
    left = crosses ? zero : left;
    right = crosses ? splat(width) : right;
    top = crosses ? zero : top;
    bottom = crosses ? splat(height) : bottom;
  }
  // From coordinates to the pixels whose centers are inside; clamped before truncation.
  const Float8 half = splat(0.5F - kPixelMargin);
  const Int8 x0 = truncated(maximum(minimum(left + half, splat(width)), zero));
  const Int8 x1 = truncated(minimum(maximum(right - half, zero), splat(width - 1)));
  const Int8 y0 = truncated(maximum(minimum(top + half, splat(height)), zero));
  const Int8 y1 = truncated(minimum(maximum(bottom - half, zero), splat(height - 1)));
  store(setup.x0, x0);
  store(setup.x1, x1);
  store(setup.y0, y0);
  store(setup.y1, y1);
  // The box may be empty because the triangle lies beside the image or between the centers of pixels.
  return seen & (right > half) & (bottom > half) & (x0 <= x1) & (y0 <= y1);
}

/// The rule for pixels exactly on an edge: left edges, and horizontal ones at the top, own them; d.y and d.z
/// decrease along the image's axes.
SIMCORE_INLINE Float8 thresholdOf(const Vector8& edge) {
  constexpr float kSmallest = 1.17549435e-38F;
  const Float8 zero = splat(0);
  // A smaller threshold includes pixels whose edge function is exactly 0.
  const Int8 owns = (edge.y < zero) | ((edge.y == zero) & (edge.z < zero));
  return owns ? splat(-kSmallest) : zero;
}

/// Stores four vectors such that the four values of a lane are neighbors.
SIMCORE_INLINE void storeLanes(float (&to)[8][4], Float8 a, Float8 b, Float8 c, Float8 d) {
  const Rows4 t = transposed(a, b, c, d);
  for (int i = 0; i < 4; ++i) {
    store(to[i], lowHalf(t.rows[i]));
    store(to[i + 4], highHalf(t.rows[i]));
  }
}

/// Sets up eight triangles; returns a bit for each one that may cover pixels. `bounded` says that their boxes
/// are known, and not empty.
SIMCORE_INLINE unsigned setUp(const DrawJob& job, const VisibilityBuffer& buffer, bool bounded,
                              const std::int32_t* triangles, Setup& setup) {
  const MeshStreams& mesh = *job.mesh;
  // The corners in camera space.
  const Vector8 v[3] = {loadCorner(buffer.positions, mesh.index[0], triangles),
                        loadCorner(buffer.positions, mesh.index[1], triangles),
                        loadCorner(buffer.positions, mesh.index[2], triangles)};
  Int8 covers = splatInt(-1);
  if (!bounded) {
    covers = boundPixels(v, buffer, job.inFront, setup);
    if (bits(covers) == 0) return 0;
  }
  // The plane through the corners, scaled such that plane * point = 1 on it.
  const Vector8 inward = cross(v[2] - v[0], v[1] - v[0]);
  const Float8 volume = dot(inward, v[0]);
  // A triangle with no positive volume shows its inner side or has no area.
  const unsigned lanes = bits(covers & (volume > splat(0)));
  const Float8 inverse = 1.0F / volume;
  // Opposite to corner 0, 1 and 2, so that each is also the barycentric weight of its corner.
  const Vector8 edges[3] = {edgeBetween(v[2], v[1]), edgeBetween(v[0], v[2]), edgeBetween(v[1], v[0])};
  storeLanes(setup.x, edges[0].x, edges[1].x, edges[2].x, inward.x * inverse);
  storeLanes(setup.y, edges[0].y, edges[1].y, edges[2].y, inward.y * inverse);
  storeLanes(setup.z, edges[0].z, edges[1].z, edges[2].z, inward.z * inverse);
  storeLanes(setup.threshold, thresholdOf(edges[0]), thresholdOf(edges[1]), thresholdOf(edges[2]), splat(0));
  store(setup.triangle, load<Int8>(triangles));
  return lanes;
}

/// A triangle of a setup while its rows are being drawn; each array has the values of the three edges and
/// of 1 / depth.
struct Edges {
  const float *x, *y, *z, *threshold;
  // Number of its TriangleRecord.
  std::int32_t id;

  SIMCORE_INLINE Edges(const Setup& setup, int lane, std::int32_t number)
      : x(setup.x[lane]), y(setup.y[lane]), z(setup.z[lane]), threshold(setup.threshold[lane]), id(number) {}
};

/// The pixels that may be covered, inclusive.
struct PixelBox {
  int x0, x1, y0, y1;
};

/// Unpacks what selectCovering() stored.
SIMCORE_INLINE PixelBox unpacked(std::int64_t box) {
  const auto part = [&](int i) { return static_cast<int>(static_cast<std::int16_t>(box >> 16 * i)); };
  return {part(0), -part(2), part(1), -part(3)};
}

/// The edge functions, and 1 / depth, of a row at column 0.
struct RowStart {
  float at[4];

  SIMCORE_INLINE RowStart(const Edges& e, float row) {
    store(at, load<Float4>(e.x) + load<Float4>(e.z) * row);
  }
};

/// Draws the eight pixels at `pixel` where `slope` has the functions' changes from column 0 on. Returns a bit
/// for each one that was covered and nearer than before.
SIMCORE_INLINE unsigned drawEight(const Edges& e, const RowStart& start, const Float8 (&slope)[4],
                                  const VisibilityBuffer& buffer, std::ptrdiff_t pixel) {
  float* const depths = buffer.inverseDepth + pixel;
  const auto old = load<Float8>(depths);
  // 1 / depth is linear in the image; a larger value is nearer.
  const Float8 now = splat(start.at[3]) + slope[3];
  const Int8 mask = (splat(start.at[0]) + slope[0] > splat(e.threshold[0])) &
                    (splat(start.at[1]) + slope[1] > splat(e.threshold[1])) &
                    (splat(start.at[2]) + slope[2] > splat(e.threshold[2])) & (now > old);
  // Without a branch, which the processor could hardly predict.
  store(depths, mask ? now : old);
  std::int32_t* const ids = buffer.triangle + pixel;
  store(ids, mask ? splatInt(e.id) : load<Int8>(ids));
  return bits(mask);
}

/// The pixels of eight rows that are inside all edges, with a margin of one pixel.
struct RowRanges {
  alignas(32) std::int32_t from[8], to[8];
  /// A bit for each row that has such pixels.
  unsigned rows = 0;
};

/// Narrows eight rows from y on to the pixels that are inside; `slope` is pixels per edge function.
SIMCORE_INLINE RowRanges narrow(const Edges& e, const VisibilityBuffer& buffer, const float (&slope)[3],
                                const PixelBox& box, int y) {
  // The pixel coordinate at which column is 0.
  const float center = static_cast<float>(buffer.width) / 2 - 0.5F;
  const auto row = load<Float8>(buffer.row + y);
  Float8 from = splat(static_cast<float>(box.x0)), to = splat(static_cast<float>(box.x1));
  for (int i = 0; i < 3; ++i) {
    // The column where the edge function is 0.
    const Float8 crossing = center + (e.x[i] + e.z[i] * row) * slope[i];
    // Columns decrease to the right: where e.y is negative, the edge bounds the row on the left. Edges with
    // e.y = 0 bound only rows, and drawEight() tests them.
    if (e.y[i] < 0) from = maximum(crossing - 1, from);
    if (e.y[i] > 0) to = minimum(crossing + 1, to);
  }
  RowRanges result;
  // Also false for NaN.
  result.rows = bits(from <= to);
  store(result.from, truncated(from));
  store(result.to, truncated(to));
  return result;
}

/// The changes of the functions from column 0 to eight columns.
SIMCORE_INLINE void slopesAt(const Edges& e, const float* columns, Float8 (&slope)[4]) {
  const auto column = load<Float8>(columns);
  for (int i = 0; i < 4; ++i) slope[i] = splat(e.y[i]) * column;
}

/// Draws a triangle all of whose pixels are in the eight columns from x on.
SIMCORE_INLINE bool drawNarrow(const Edges& e, const VisibilityBuffer& buffer, int x, int y0, int y1) {
  Float8 slope[4];
  slopesAt(e, buffer.column + x, slope);
  unsigned any = 0;
  std::ptrdiff_t pixel = static_cast<std::ptrdiff_t>(y0) * buffer.stride + x;
  for (int y = y0; y <= y1; ++y, pixel += buffer.stride) {
    any |= drawEight(e, RowStart(e, buffer.row[y]), slope, buffer, pixel);
  }
  return any != 0;
}

/// Draws a wider triangle, eight pixels at a time. The rows are narrowed first, because large triangles leave
/// most of their box empty.
SIMCORE_INLINE bool drawWide(const Edges& e, const VisibilityBuffer& buffer, const PixelBox& box) {
  const float slope[3] = {buffer.focalX / e.y[0], buffer.focalX / e.y[1], buffer.focalX / e.y[2]};
  unsigned any = 0;
  for (int first = box.y0; first <= box.y1; first += 8) {
    const RowRanges ranges = narrow(e, buffer, slope, box, first);
    unsigned rows = ranges.rows;
    if (box.y1 - first < 7) rows &= (2U << (box.y1 - first)) - 1;
    for (; rows != 0; rows &= rows - 1) {
      const int i = __builtin_ctz(rows);
      const RowStart start(e, buffer.row[first + i]);
      const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(first + i) * buffer.stride;
      for (int x = ranges.from[i] & kAligned; x <= ranges.to[i]; x += 8) {
        Float8 change[4];
        slopesAt(e, buffer.column + x, change);
        any |= drawEight(e, start, change, buffer, row + x);
      }
    }
  }
  return any != 0;
}

/// Returns whether the triangle has at least one visible pixel.
SIMCORE_INLINE bool drawTriangle(const Edges& e, const VisibilityBuffer& buffer, const PixelBox& box) {
  if (box.x1 - box.x0 >= 8) return drawWide(e, buffer, box);
  const int aligned = box.x0 & kAligned;
  return drawNarrow(e, buffer, box.x1 - aligned < 8 ? aligned : box.x0, box.y0, box.y1);
}

/// The normal of a vertex in camera space, of any length.
SIMCORE_INLINE Float4 normalOf(const DrawJob& job, const Float4 (&axes)[3], std::int32_t vertex) {
  const float* const normal = job.mesh->normal + 4 * static_cast<std::ptrdiff_t>(vertex);
  return axes[0] * normal[0] + axes[1] * normal[1] + axes[2] * normal[2];
}

/// Writes what the lighting needs to know about a triangle.
SIMCORE_INLINE void writeRecord(const DrawJob& job, const Float4 (&axes)[3], TriangleRecord& record,
                                const Edges& e, std::int32_t triangle) {
  const std::int32_t* const* index = job.mesh->index;
  const Float4 normal = normalOf(job, axes, index[0][triangle]);
  const float* const edges[3] = {e.x, e.y, e.z};
  Float4 linear[3] = {normal, {}, {}};
  // A flat triangle has the same normal everywhere.
  if (job.mesh->flat[triangle] == 0) {
    // Normals are interpolated with the edge functions as weights; only their direction matters.
    const Float4 second = normalOf(job, axes, index[1][triangle]),
                 third = normalOf(job, axes, index[2][triangle]);
    for (int k = 0; k < 3; ++k) linear[k] = normal * edges[k][0] + second * edges[k][1] + third * edges[k][2];
  }
  for (int k = 0; k < 3; ++k) {
    // The fourth component holds the plane, so that one load gives both.
    linear[k][3] = edges[k][3];
    store(record.linear[k], linear[k]);
    record.color[k] = job.color[k];
  }
  record.self = job.self;
}

/// Draws the front-facing triangles of a mesh, and appends a record for each visible one.
void draw(const DrawJob& job, VisibilityBuffer& target) {
  // A copy, which no store to the image can change.
  const VisibilityBuffer buffer = target;
  int count = collectFrontFaces(job, buffer.candidates);
  if (count == 0) return;
  const bool bounded = job.inFront && buffer.width <= kMaxBoundedSize && buffer.height <= kMaxBoundedSize;
  // Only now, because many meshes have no front-facing triangle.
  transformVertices(job, buffer, bounded ? buffer.ranges : nullptr);
  if (bounded) count = selectCovering(job, buffer, count);
  // The directions of the mesh's axes.
  const auto& m = job.meshInCamera;
  const Float4 axes[3] = {
      {m[0][0], m[1][0], m[2][0], 0}, {m[0][1], m[1][1], m[2][1], 0}, {m[0][2], m[1][2], m[2][2], 0}};
  Setup setup;
  std::int32_t record = buffer.recordCount;
  for (int first = 0; first < count; first += 8) {
    unsigned lanes = setUp(job, buffer, bounded, buffer.candidates + first, setup);
    // The last group contains repeated triangles, which must not be drawn twice.
    if (count - first < 8) lanes &= (1U << (count - first)) - 1;
    for (; lanes != 0; lanes &= lanes - 1) {
      const int lane = __builtin_ctz(lanes);
      const Edges edges(setup, lane, record);
      const PixelBox box = bounded ? unpacked(buffer.boxes[first + lane])
                                   : PixelBox{setup.x0[lane], setup.x1[lane], setup.y0[lane], setup.y1[lane]};
      // No record for a triangle that is hidden: the number is reused.
      if (!drawTriangle(edges, buffer, box)) continue;
      writeRecord(job, axes, buffer.records[record], edges, setup.triangle[lane]);
      ++record;
    }
  }
  target.recordCount = record;
}

}  // namespace
}  // namespace simcore::rendering
