// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/rendering/Float8.h"
#include "simcore/rendering/KernelTypes.h"

// Lights the pixels of a visibility buffer, eight at a time. Included only by the two Kernels*.cpp.
//
// For each group of pixels, shade() computes normals and positions from the triangles' records, and adds up
// ambient light and lamps. A lamp's light on points that a caster might shade (LampGrid) is left out; these
// pixels are collected as "unsure". ShadowCaster then traces rays for a quarter of them, settle() resolves
// those whose neighbors agree, and rays are traced for the rest.
namespace simcore::rendering {
namespace {

/// The surfaces at eight pixels.
struct Surface {
  /// In camera space, of any length.
  Vector8 normal;
  /// 1 / depth = plane * d.
  Vector8 plane;
  // 0 if nothing was drawn; larger is nearer.
  Float8 inverseDepth;
  Vector8 color;
  /// The instance if it is convex, otherwise -1.
  Int8 self;
};

/// All eight pixels show the same triangle.
SIMCORE_INLINE Surface loadOne(const TriangleRecord& record, Float8 column, float row) {
  // The same order of operations as in loadEight(), so that both give the same bits.
  const auto a = load<Float4>(record.linear[0]), b = load<Float4>(record.linear[1]),
             c = load<Float4>(record.linear[2]);
  const Float4 start = a + c * row;
  const auto at = [&](int i) { return splat(start[i]) + splat(b[i]) * column; };
  return {{at(0), at(1), at(2)},
          {splat(a[3]), splat(b[3]), splat(c[3])},
          at(3),
          splatVector(record.color),
          splatInt(record.self)};
}

/// The pixels show different triangles.
SIMCORE_INLINE Surface loadEight(const TriangleRecord* records, const std::int32_t* ids, Float8 column,
                                 float row) {
  const float* at[4][8];
  for (int i = 0; i < 8; ++i) {
    const TriangleRecord& record = records[ids[i]];
    for (int k = 0; k < 3; ++k) at[k][i] = record.linear[k];
    /// Color and self.
    at[3][i] = record.color;
  }
  const Rows4 a = loadTransposed(at[0]), b = loadTransposed(at[1]), c = loadTransposed(at[2]);
  const auto value = [&](int i) { return (a.rows[i] + c.rows[i] * row) + b.rows[i] * column; };
  const Rows4 color = loadTransposed(at[3]);
  return {{value(0), value(1), value(2)},
          {a.rows[3], b.rows[3], c.rows[3]},
          value(3),
          {color.rows[0], color.rows[1], color.rows[2]},
          reinterpret_cast<Int8>(color.rows[3])};
}

/// Rotates a vector.
SIMCORE_INLINE Vector8 rotated(const float (&m)[3][3], const Vector8& v) {
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

/// The cell of a face in the direction of two components, as multiples of the third, whose inverse is given.
SIMCORE_INLINE Int8 cellInFace(Float8 u, Float8 v, Float8 inverse, Int8 face, int gridSize) {
  const Float8 half = splat(static_cast<float>(gridSize) * 0.5F),
               last = splat(static_cast<float>(gridSize - 1));
  const Int8 cu = truncated(maximum(minimum((u * inverse + 1.0F) * half, last), splat(0)));
  const Int8 cv = truncated(maximum(minimum((v * inverse + 1.0F) * half, last), splat(0)));
  return (face * gridSize + cv) * gridSize + cu;
}

/// The cell of a lamp's grid in the direction from the lamp; LampGrid.h describes the faces.
SIMCORE_INLINE Int8 cellOf(const Vector8& direction, int gridSize) {
  const Float8 ax = absolute(direction.x), ay = absolute(direction.y), az = absolute(direction.z);
  // Directions of length 0 go to some cell rather than to NaN.
  const Float8 smallest = splat(1e-30F);
  const Int8 isZ = (ax < az) & (ay < az);
  // Most lamps hang above what they light.
  if (bits(isZ) == 0xFF) {
    const Int8 face = splatInt(4) - (direction.z < splat(0));
    return cellInFace(direction.x, direction.y, splat(1) / maximum(az, smallest), face, gridSize);
  }
  const Int8 isX = (ax >= ay) & (ax >= az);
  const Int8 isY = ~isX & (ay >= az);
  const Float8 major = isX ? direction.x : isY ? direction.y : direction.z;
  const Int8 face = (isX   ? splatInt(0)
                     : isY ? splatInt(2)
                           : splatInt(4)) +
                    ((major < splat(0)) & splatInt(1));
  return cellInFace(isX ? direction.y : direction.x, (isX | isY) ? direction.z : direction.y,
                    splat(1) / maximum(absolute(major), smallest), face, gridSize);
}

/// Selects, from lanes with points at squared distances from a lamp, those that a caster in their cell might
/// shade.
SIMCORE_INLINE Int8 mayBeShaded(const ShadeLamp& lamp, Int8 cell, Int8 self, Float8 squaredDistance,
                                Int8 lanes) {
  // In front of everything in its cell a point is lit.
  const Int8 behind = lanes & (gathered(lamp.nearest, cell) < squaredDistance);
  if (bits(behind) == 0) return behind;
  const auto* base = reinterpret_cast<const float*>(lamp.cells);
  // Three words per cell.
  const Int8 at = cell * 3;
  // The low half of the third word, with its sign.
  const Int8 nearest = reinterpret_cast<Int8>(gathered(base, at + 2)) << 16 >> 16;
  // A convex instance does not shade itself, so the second nearest caster counts.
  const Int8 own = (nearest == self) & (self >= splatInt(0));
  return behind & (~own | (gathered(base, at + 1) < squaredDistance));
}

/// Appends a group to the unsure pixels of a lamp.
SIMCORE_INLINE void append(UnsurePixels& pixels, const UnsureGroup& group, Float8 light,
                           const Vector8& direction) {
  pixels.groups[pixels.count++] = group;
  store(pixels.light + group.pixel, light);
  store(pixels.direction[0] + group.pixel, direction.x);
  store(pixels.direction[1] + group.pixel, direction.y);
  store(pixels.direction[2] + group.pixel, direction.z);
}

/// The light of a lamp on eight points, without that which depends on rays.
SIMCORE_INLINE Float8 lampLight(const Strip& strip, const ShadeLamp& lamp, const Surface& surface,
                                const Vector8& point, Float8 squaredNormal, Int8 drawn,
                                std::int32_t firstPixel, std::int32_t row) {
  constexpr float kTiny = 1e-30F;
  const Vector8 position = splatVector(lamp.inCamera);
  // Lighting is computed in camera space, shadows in the world's axes.
  const Vector8 toLamp = position - point;
  const Float8 squaredDistance = dot(toLamp, toLamp);
  const Float8 cosine =
      dot(surface.normal, toLamp) / squareRoot(maximum(squaredNormal * squaredDistance, splat(kTiny)));
  Float8 light = lamp.intensity * maximum(cosine, splat(0)) / (1.0F + squaredDistance * lamp.attenuation);
  if (lamp.spotFactor != 0) {
    const Float8 along =
        -dot(toLamp, splatVector(lamp.spotDirection)) / squareRoot(maximum(squaredDistance, splat(kTiny)));
    light = light * maximum(minimum(along * lamp.spotFactor + lamp.spotOffset, splat(1)), splat(0));
  }
  if (lamp.cells == nullptr) return light;
  // A surface whose triangle faces away from the lamp is in the shadow of its own body.
  light = dot(surface.plane, position) < splat(1) ? light : splat(0);
  // Points without light need no rays.
  const Int8 lit = drawn & (light > splat(0));
  if (bits(lit) == 0) return light;
  const Vector8 direction = rotated(strip.cameraToWorld, {-toLamp.x, -toLamp.y, -toLamp.z});
  const Int8 unsure =
      mayBeShaded(lamp, cellOf(direction, strip.gridSize), surface.self, squaredDistance, lit);
  const unsigned lanes = bits(unsure);
  if (lanes == 0) return light;
  // Each such lane is lit later, if its ray arrives.
  append(*lamp.unsure, {firstPixel, row, lanes}, light, direction);
  return unsure ? splat(0) : light;
}

/// Lights eight pixels of a row; `firstPixel` is their index in the strip.
SIMCORE_INLINE void shadeEight(const Strip& strip, const VisibilityBuffer& buffer, int x, int y,
                               std::int32_t firstPixel) {
  const std::int32_t* ids = buffer.triangle + static_cast<std::ptrdiff_t>(y) * buffer.stride + x;
  const auto column = load<Float8>(buffer.column + x);
  const float row = buffer.row[y];
  // Large triangles make this the usual case.
  const bool same = bits(load<Int8>(ids) == splatInt(ids[0])) == 0xFF;
  const Surface surface =
      same ? loadOne(buffer.records[ids[0]], column, row) : loadEight(buffer.records, ids, column, row);
  store(strip.color[0] + firstPixel, surface.color.x);
  store(strip.color[1] + firstPixel, surface.color.y);
  store(strip.color[2] + firstPixel, surface.color.z);
  // Record 0, the background, keeps its color: light 1, no lamps.
  const auto drawn = load<Int8>(ids) != splatInt(0);
  Float8 light = splat(1);
  if (bits(drawn) != 0) {
    // Avoids dividing by 0 where nothing was drawn.
    const Float8 depth = splat(1) / (drawn ? surface.inverseDepth : splat(1));
    const Vector8 point = {depth, column * depth, row * depth};
    const Float8 squaredNormal = dot(surface.normal, surface.normal);
    Float8 sum = splat(strip.ambient);
    for (int i = 0; i < strip.lampCount; ++i) {
      sum = sum + lampLight(strip, strip.lamps[i], surface, point, squaredNormal, drawn, firstPixel,
                            y - strip.firstRow);
    }
    light = drawn ? sum : light;
  }
  store(strip.light + firstPixel, light);
}

/// Lights a strip.
void shade(const Strip& strip, const VisibilityBuffer& buffer) {
  // Column by column, so that consecutive shadow rays take similar paths.
  for (int x = 0; x < buffer.width; x += 8) {
    for (int i = 0; i < strip.rows; ++i) {
      shadeEight(strip, buffer, x, strip.firstRow + i, i * buffer.stride + x);
    }
  }
}

/// The common result of the traced neighbors of eight pixels, 0 if they disagree. Traced first are the pixels
/// with even coordinates.
SIMCORE_INLINE Int8 neighborsSay(const std::int32_t* seen, int stride, bool oddRow) {
  const Int8 zero = splatInt(0);
  if (!oddRow) {
    // Even rows: the pixels to the left and right were traced.
    const auto left = load<Int8>(seen - 1);
    return left == load<Int8>(seen + 1) ? left : zero;
  }
  const std::int32_t* const above = seen - stride;
  const std::int32_t* const below = seen + stride;
  const auto up = load<Int8>(above), corner = load<Int8>(above - 1);
  const Int8 vertical = up == load<Int8>(below) ? up : zero;
  const Int8 cornersAgree = (corner == load<Int8>(above + 1)) & (corner == load<Int8>(below - 1)) &
                            (corner == load<Int8>(below + 1));
  // In odd rows, even columns have traced pixels above and below, odd columns at their four corners.
  const Int8 evenColumn = {-1, 0, -1, 0, -1, 0, -1, 0};
  return evenColumn ? vertical : cornersAgree ? corner : zero;
}

/// Resolves the pixels that were not traced and whose neighbors agree, and removes them from the groups'
/// lanes.
void settle(UnsurePixels& pixels, int stride, float* light) {
  for (int i = 0; i < pixels.count; ++i) {
    UnsureGroup& group = pixels.groups[i];
    const bool oddRow = (group.row & 1) != 0;
    // Pixels with even coordinates were traced before.
    group.lanes &= oddRow ? 0xFFU : 0xAAU;
    if (group.lanes == 0) continue;
    const Int8 says = neighborsSay(pixels.seen + group.pixel, stride, oddRow);
    const Int8 settled = says != splatInt(0);
    const unsigned lanes = bits(settled) & group.lanes;
    if (lanes == 0) continue;
    const Int8 lane = {1, 2, 4, 8, 16, 32, 64, 128};
    const Int8 lit =
        // Bit 0 of `seen` tells lit (3) from shadow (2).
        ((splatInt(static_cast<std::int32_t>(lanes)) & lane) != splatInt(0)) & ((says & 1) != splatInt(0));
    const Float8 added = lit ? load<Float8>(pixels.light + group.pixel) : splat(0);
    store(light + group.pixel, load<Float8>(light + group.pixel) + added);
    // The remaining lanes are traced one by one.
    group.lanes &= ~lanes;
  }
}

}  // namespace
}  // namespace simcore::rendering
