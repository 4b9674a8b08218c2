// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/rendering/Float8.h"
#include "simcore/rendering/KernelTypes.h"

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

/// Eight triangles after setup, ready to be drawn.
struct Setup {
  /// Component k of edge i: a pixel with ray d is inside where edge * d > threshold.
  float edge[3][3][8];
  /// Just below 0 for edges that own the pixels on them, otherwise 0.
  float threshold[3][8];
  /// 1 / depth = plane * d.
  float plane[3][8];
  // The box of pixels that may be covered, inclusive.
  std::int32_t x0[8], x1[8], y0[8], y1[8];
  // Index of the triangle in the mesh.
  std::int32_t triangle[8];
};

/// The cross product of two points, computed such that it is exactly negated when they are exchanged, and
/// precise when they are close together. So two triangles that share an edge leave no gap and no overlap.
SIMCORE_INLINE Vector8 edgeBetween(const Vector8& a, const Vector8& b) {
  return cross(a + b, b - a);
}

/// Collects the indices of triangles whose outer side faces the camera, and repeats the last one to fill a
/// group of eight; returns their number.
SIMCORE_INLINE int collectFrontFaces(const DrawJob& job, std::int32_t* candidates) {
  const MeshStreams& mesh = *job.mesh;
  // In the mesh's frame, so that planes need not be transformed.
  const Vector8 camera = splatVector(job.cameraInMesh);
  int count = 0;
  // The camera sees a triangle's outer side if it is above the triangle's plane.
  // The position of the camera relative to the planes of eight triangles at a time.
  for (int group = 0; group < mesh.triangleGroups; ++group) {
    const int at = group * 8;
    const auto height = load<Float8>(mesh.plane[0] + at) * camera.x +
                        load<Float8>(mesh.plane[1] + at) * camera.y +
                        load<Float8>(mesh.plane[2] + at) * camera.z - load<Float8>(mesh.plane[3] + at);
    // Compacts the lanes above their plane to a list of indices.
    for (unsigned left = bits(height > splat(0)); left != 0; left &= left - 1) {
      candidates[count++] = at + __builtin_ctz(left);
    }
  }
  // Padding: setUp() always reads eight.
  for (int i = 0; i < 7 && count > 0; ++i) candidates[count + i] = candidates[count - 1];
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

/// Transforms the mesh's vertices and normals to the camera's frame, four floats each.
SIMCORE_INLINE void transformVertices(const DrawJob& job, float* positions, float* normals) {
  const MeshStreams& mesh = *job.mesh;
  // The matrix with each element in all lanes.
  Float8 m[3][4];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) m[i][k] = splat(job.meshInCamera[i][k]);
  }
  for (int group = 0; group < mesh.vertexGroups; ++group) {
    const int at = group * 8;
    const auto x = load<Float8>(mesh.position[0] + at), y = load<Float8>(mesh.position[1] + at),
               z = load<Float8>(mesh.position[2] + at);
    storeTransposed(positions + 4 * at, m[0][0] * x + m[0][1] * y + m[0][2] * z + m[0][3],
                    m[1][0] * x + m[1][1] * y + m[1][2] * z + m[1][3],
                    m[2][0] * x + m[2][1] * y + m[2][2] * z + m[2][3]);
    // Normals are only rotated.
    const auto nx = load<Float8>(mesh.normal[0] + at), ny = load<Float8>(mesh.normal[1] + at),
               nz = load<Float8>(mesh.normal[2] + at);
    storeTransposed(normals + 4 * at, m[0][0] * nx + m[0][1] * ny + m[0][2] * nz,
                    m[1][0] * nx + m[1][1] * ny + m[1][2] * nz, m[2][0] * nx + m[2][1] * ny + m[2][2] * nz);
  }
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
/// not empty.
SIMCORE_INLINE Int8 boundPixels(const Vector8 (&v)[3], const VisibilityBuffer& buffer, bool inFront,
                                Setup& setup) {
  constexpr float kMargin = 0.001F;  // pixels; rounding errors of the projection are far smaller
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
  const Float8 half = splat(0.5F - kMargin);
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

/// Stores a vector's components in separate arrays.
SIMCORE_INLINE void storeVector(float (&to)[3][8], const Vector8& v) {
  store(to[0], v.x);
  store(to[1], v.y);
  store(to[2], v.z);
}

/// Sets up eight triangles; returns a bit for each one that may cover pixels.
SIMCORE_INLINE unsigned setUp(const DrawJob& job, const VisibilityBuffer& buffer,
                              const std::int32_t* triangles, Setup& setup) {
  const MeshStreams& mesh = *job.mesh;
  // The corners in camera space.
  const Vector8 v[3] = {loadCorner(buffer.positions, mesh.index[0], triangles),
                        loadCorner(buffer.positions, mesh.index[1], triangles),
                        loadCorner(buffer.positions, mesh.index[2], triangles)};
  const Int8 covers = boundPixels(v, buffer, job.inFront, setup);
  // Most groups of small or distant meshes end here.
  if (bits(covers) == 0) return 0;
  // The plane through the corners, scaled such that plane * point = 1 on it.
  const Vector8 inward = cross(v[2] - v[0], v[1] - v[0]);
  const Float8 volume = dot(inward, v[0]);
  const Float8 inverse = 1.0F / volume;
  storeVector(setup.plane, {inward.x * inverse, inward.y * inverse, inward.z * inverse});
  // Opposite to corner 0, 1 and 2, so that each is also the barycentric weight of its corner.
  const Vector8 edges[3] = {edgeBetween(v[2], v[1]), edgeBetween(v[0], v[2]), edgeBetween(v[1], v[0])};
  for (int i = 0; i < 3; ++i) {
    storeVector(setup.edge[i], edges[i]);
    store(setup.threshold[i], thresholdOf(edges[i]));
  }
  store(setup.triangle, load<Int8>(triangles));
  // A triangle with no positive volume shows its inner side or has no area.
  return bits(covers & (volume > splat(0)));
}

/// One triangle of a setup while its rows are being drawn; scalars for the components of its edges.
struct Edges {
  // The components of each edge's normal.
  float x[3], y[3], z[3];
  float threshold[3];
  float plane[3];
  // Number of its TriangleRecord.
  std::int32_t id;
};

/// Extracts one triangle.
SIMCORE_INLINE Edges selectLane(const Setup& setup, int lane, std::int32_t id) {
  Edges e;
  for (int i = 0; i < 3; ++i) {
    e.x[i] = setup.edge[i][0][lane];
    e.y[i] = setup.edge[i][1][lane];
    e.z[i] = setup.edge[i][2][lane];
    e.threshold[i] = setup.threshold[i][lane];
    e.plane[i] = setup.plane[i][lane];
  }
  e.id = id;
  return e;
}

/// Draws eight pixels of a row from x on. `base` are the edge functions and `depth` is 1 / depth at column 0.
/// Returns the mask of pixels that were covered and nearer than before.
SIMCORE_INLINE Int8 drawEight(const Edges& e, const float (&base)[3], float depth,
                              const VisibilityBuffer& buffer, std::ptrdiff_t rowStart, int x) {
  const auto column = load<Float8>(buffer.column + x);
  // Stores may touch up to seven pixels beyond the row, hence the stride.
  float* const depths = buffer.inverseDepth + rowStart + x;
  const auto old = load<Float8>(depths);
  // 1 / depth is linear in the image; a larger value is nearer.
  const Float8 now = splat(depth) + splat(e.plane[1]) * column;
  const Int8 mask = (splat(base[0]) + splat(e.y[0]) * column > splat(e.threshold[0])) &
                    (splat(base[1]) + splat(e.y[1]) * column > splat(e.threshold[1])) &
                    (splat(base[2]) + splat(e.y[2]) * column > splat(e.threshold[2])) & (now > old);
  // Without a branch, which the processor could hardly predict.
  store(depths, mask ? now : old);
  std::int32_t* const ids = buffer.triangle + rowStart + x;
  store(ids, mask ? splatInt(e.id) : load<Int8>(ids));
  return mask;
}

/// Narrows [from, to] to the pixels of a row that are inside all edges, with a margin of one pixel.
SIMCORE_INLINE void narrow(const Edges& e, const float (&base)[3], const float (&slope)[3], float center,
                           float& from, float& to) {
  for (int i = 0; i < 3; ++i) {
    // The column where the edge function is 0.
    const float crossing = center + base[i] * slope[i];
    // Columns decrease to the right: where e.y is negative, the edge bounds the row on the left. Edges with
    // e.y = 0 bound only rows, and drawEight() tests them.
    if (e.y[i] < 0 && crossing - 1 > from) from = crossing - 1;
    if (e.y[i] > 0 && crossing + 1 < to) to = crossing + 1;
  }
}

/// The edge functions, and 1 / depth, of a row at column 0.
struct RowStart {
  float edge[3];
  float depth;
  // Index of the row's first pixel.
  std::ptrdiff_t pixel;

  SIMCORE_INLINE RowStart(const Edges& e, const VisibilityBuffer& buffer, int y)
      : edge{e.x[0] + e.z[0] * buffer.row[y], e.x[1] + e.z[1] * buffer.row[y],
             e.x[2] + e.z[2] * buffer.row[y]},
        depth(e.plane[0] + e.plane[2] * buffer.row[y]),
        pixel(static_cast<std::ptrdiff_t>(y) * buffer.stride) {}
};

/// Draws a triangle at most eight pixels wide.
SIMCORE_INLINE Int8 drawNarrow(const Edges& e, const VisibilityBuffer& buffer, int x0, int y0, int y1) {
  // Collects the masks of all rows; only whether there is any pixel matters.
  Int8 any = splatInt(0);
  for (int y = y0; y <= y1; ++y) {
    const RowStart start(e, buffer, y);
    any |= drawEight(e, start.edge, start.depth, buffer, start.pixel, x0);
  }
  return any;
}

/// Draws a wider triangle, eight pixels at a time. Each row is narrowed first, because large triangles leave
/// most of their box empty.
SIMCORE_INLINE Int8 drawWide(const Edges& e, const VisibilityBuffer& buffer, int x0, int x1, int y0, int y1) {
  // The pixel coordinate at which column is 0, and pixels per edge function.
  const float center = static_cast<float>(buffer.width) / 2 - 0.5F;
  const float slope[3] = {buffer.focalX / e.y[0], buffer.focalX / e.y[1], buffer.focalX / e.y[2]};
  Int8 any = splatInt(0);
  for (int y = y0; y <= y1; ++y) {
    const RowStart start(e, buffer, y);
    auto from = static_cast<float>(x0), to = static_cast<float>(x1);
    narrow(e, start.edge, slope, center, from, to);
    // The row is outside the triangle; also false for NaN.
    if (!(from <= to)) continue;
    for (int x = static_cast<int>(from), last = static_cast<int>(to); x <= last; x += 8) {
      any |= drawEight(e, start.edge, start.depth, buffer, start.pixel, x);
    }
  }
  return any;
}

/// Returns whether the triangle has at least one visible pixel.
SIMCORE_INLINE bool drawTriangle(const Edges& e, const Setup& setup, int lane,
                                 const VisibilityBuffer& buffer) {
  const int x0 = setup.x0[lane], x1 = setup.x1[lane], y0 = setup.y0[lane], y1 = setup.y1[lane];
  return bits(x1 - x0 < 8 ? drawNarrow(e, buffer, x0, y0, y1) : drawWide(e, buffer, x0, x1, y0, y1)) != 0;
}

/// Writes what the lighting needs to know about a triangle.
SIMCORE_INLINE void writeRecord(const DrawJob& job, const VisibilityBuffer& buffer, const Edges& e,
                                std::int32_t triangle) {
  TriangleRecord& record = buffer.records[e.id];
  Float4 normal[3];
  for (int i = 0; i < 3; ++i) normal[i] = load<Float4>(buffer.normals + 4 * job.mesh->index[i][triangle]);
  // Normals are interpolated with the edge functions as weights; only their direction matters.
  const float* const edges[3] = {e.x, e.y, e.z};
  const bool flat = job.mesh->flat[triangle] != 0;
  for (int k = 0; k < 3; ++k) {
    Float4 linear = normal[0] * edges[k][0] + normal[1] * edges[k][1] + normal[2] * edges[k][2];
    // A flat triangle has the same normal everywhere.
    if (flat) linear = normal[0] * (k == 0 ? 1.0F : 0.0F);
    // The fourth component holds the plane, so that one load gives both.
    linear[3] = e.plane[k];
    store(record.linear[k], linear);
    record.color[k] = job.color[k];
  }
  record.self = job.self;
}

/// Draws the front-facing triangles of a mesh, and appends a record for each visible one.
void draw(const DrawJob& job, VisibilityBuffer& buffer) {
  const int count = collectFrontFaces(job, buffer.candidates);
  if (count == 0) return;
  // Only now, because many meshes have no front-facing triangle.
  transformVertices(job, buffer.positions, buffer.normals);
  Setup setup;
  for (int first = 0; first < count; first += 8) {
    unsigned lanes = setUp(job, buffer, buffer.candidates + first, setup);
    // The last group contains repeated triangles, which must not be drawn twice.
    if (count - first < 8) lanes &= (1U << (count - first)) - 1;
    for (; lanes != 0; lanes &= lanes - 1) {
      const int lane = __builtin_ctz(lanes);
      const Edges edges = selectLane(setup, lane, buffer.recordCount);
      // No record for a triangle that is hidden: the number is reused.
      if (!drawTriangle(edges, setup, lane, buffer)) continue;
      writeRecord(job, buffer, edges, setup.triangle[lane]);
      ++buffer.recordCount;
    }
  }
}

}  // namespace
}  // namespace simcore::rendering
