// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

// What the kernels read and write: plain arrays, without a line of code that could be compiled for two
// processors.
//
// Frames: "camera" is the camera's own, x along the optical axis, y left, z up. A pixel's ray is d = (1,
// column, row) in it, with column = (centre - x) / focal length; a point at depth t on it is t * d. A
// function that is linear in camera space, evaluated on d, is linear in the image.
namespace simcore::rendering {

/// A mesh as streams of floats, padded to multiples of eight; the padding is never front-facing.
struct MeshStreams {
  int vertexGroups = 0;    ///< of eight
  int triangleGroups = 0;  ///< of eight
  const float* position[3] = {};
  const float* normal[3] = {};
  const float* plane[4] =
      {};  ///< outward normal and offset: a point sees the front where normal * point > offset
  const std::int32_t* index[3] = {};
  const std::uint8_t* flat = nullptr;  ///< 1 where the three vertices share one normal
};

/// One mesh to be drawn.
struct DrawJob {
  const MeshStreams* mesh = nullptr;
  float meshInCamera[3][4] = {};
  float cameraInMesh[3] = {};
  float color[3] = {};     ///< in the channels of the image
  std::int32_t self = -1;  ///< the instance, if it is convex and thus cannot shade itself; else -1
  bool inFront = false;    ///< entirely in front of the camera
};

/// A triangle that has pixels. With d the ray of a pixel: linear[k][0..2] * d[k] summed is the surface's
/// normal there (of any length, in camera space), linear[k][3] * d[k] summed is 1 / depth. Number 0 is the
/// background.
struct alignas(64) TriangleRecord {
  float linear[3][4] = {};
  float color[3] = {};
  std::int32_t self = -1;  ///< right behind the colour: they are loaded together
};

/// The visibility buffer: which triangle is seen at each pixel, and 1 / depth there (0: nothing).
struct VisibilityBuffer {
  int width = 0, height = 0;
  int stride = 0;  ///< at least 8 more than width: eight lanes may be touched from any pixel on
  float* inverseDepth = nullptr;
  std::int32_t* triangle = nullptr;
  const float* column = nullptr;  ///< d.y by x; `stride` of them
  const float* row = nullptr;     ///< d.z by y
  float focalX = 0, focalY = 0;   ///< pixels
  TriangleRecord* records = nullptr;
  std::int32_t recordCount = 1;
  float* positions = nullptr;          ///< scratch, four floats a vertex of the largest mesh
  float* normals = nullptr;            ///< the same
  std::int32_t* candidates = nullptr;  ///< scratch, one a triangle of the largest mesh, and eight more
};

/// A direction's cell as a lamp sees it: the nearest caster of shadows in it and the nearest of another
/// instance, with lower bounds of their squared distances.
struct LampCell {
  float nearest = 0;
  float second = 0;
  /// The instance of the nearest triangle, in the low half of the third word, and of the second nearest.
  /// Numbers too large for it are -1, which is never left out.
  std::int16_t nearestInstance = -1;
  std::int16_t secondInstance = -1;
};
static_assert(sizeof(LampCell) == 12);

/// Eight pixels of a strip's row, some of which see a lamp unless a ray says otherwise.
struct UnsureGroup {
  std::int32_t pixel = 0;  ///< the first; index into the strip
  std::int32_t row = 0;    ///< of the strip
  std::uint32_t lanes = 0;
};

/// The unsure pixels of a strip, column of groups by column. What belongs to a pixel is found by its index.
struct UnsurePixels {
  int count = 0;
  UnsureGroup* groups = nullptr;
  float* light = nullptr;    ///< what the lamp adds if it is seen
  float* direction[3] = {};  ///< from the lamp to the pixel's point, in the world
  /// 2 where the pixel is in shadow, 3 where it sees the lamp, 0 where that is unknown; a row and a bit more
  /// on either side may be read.
  std::int32_t* seen = nullptr;
};

struct ShadeLamp {
  float inCamera[3] = {};
  float intensity = 0, attenuation = 0;
  const LampCell* cells = nullptr;  ///< six faces of gridSize^2; null: no shadows
  UnsurePixels* unsure = nullptr;
};

/// Some rows of an image while they are lit; stride as in the buffer, pixel 0 at the first row's start.
struct Strip {
  int firstRow = 0, rows = 0;
  float* light = nullptr;
  float* color[3] = {};
  float ambient = 0;
  float cameraToWorld[3][3] = {};  ///< rotation
  int gridSize = 0;
  int lampCount = 0;
  const ShadeLamp* lamps = nullptr;
};

/// Two 32-bit keys select a sequence of noise; a byte's place in the image selects the number.
struct NoiseKey {
  std::uint32_t first = 0, second = 0;
};

struct Kernels {
  void (*draw)(const DrawJob&, VisibilityBuffer&);
  void (*shade)(const Strip&, const VisibilityBuffer&);
  /// Settles those pixels whose neighbours agree, and leaves the others in the groups' lanes.
  void (*settle)(UnsurePixels&, int stride, float* light);
  /// A row of pixels; the colours are Y, Cb - 128, Cr - 128 or R, G, B.
  void (*writeYuyv)(const float* light, const float* const color[3], int width, std::uint8_t* out);
  void (*writeRgb)(const float* light, const float* const color[3], int width, std::uint8_t* out);
  void (*addNoise)(std::uint8_t* bytes, int count, NoiseKey key, float scale);
};

extern const Kernels kPortableKernels;
extern const Kernels kAvx2Kernels;

}  // namespace simcore::rendering
