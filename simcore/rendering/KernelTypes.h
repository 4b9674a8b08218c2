// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

// The data that kernels read and write: plain arrays without any code, which could be compiled for two
// processors.
//
// Frames: "camera" is the camera's own, x along the optical axis, y to the left, z up. The ray of a pixel is
// d = (1, column, row) in it, with column = (center - x) / focal length; the point at depth t on it is t * d.
// A function that is linear in camera space is linear in the image when it is evaluated on d.
namespace simcore::rendering {

/// A mesh as streams of floats, padded to multiples of eight; padding is never front-facing.
struct MeshStreams {
  /// Groups of eight vertices.
  int vertexGroups = 0;
  /// Groups of eight triangles.
  int triangleGroups = 0;
  /// The positions of the vertices: components x, y, z.
  const float* position[3] = {};
  /// Four floats for each vertex, the last of them 0.
  const float* normal = nullptr;
  /// Outward normal and offset of each triangle: a point is on the outer side where normal * point > offset.
  const float* plane[4] = {};
  /// The three vertices of each triangle.
  const std::int32_t* index[3] = {};
  /// 1 for each triangle whose vertices share a normal.
  const std::uint8_t* flat = nullptr;
};

/// A mesh to be drawn.
struct DrawJob {
  const MeshStreams* mesh = nullptr;
  /// Rotation and translation.
  float meshInCamera[3][4] = {};
  float cameraInMesh[3] = {};
  /// In the channels of the image: R G B, or Y and chroma without offset.
  float color[3] = {};
  /// The instance if it is convex, so that it cannot shade itself; otherwise -1.
  std::int32_t self = -1;
  /// Entirely in front of the camera's plane.
  bool inFront = false;
};

/// A triangle that has visible pixels. With d the ray of a pixel, the sum of linear[k][0..2] * d[k] is the
/// surface's normal there (of any length, in camera space), and the sum of linear[k][3] * d[k] is 1 / depth.
/// Number 0 is the background.
struct alignas(64) TriangleRecord {
  float linear[3][4] = {};
  float color[3] = {};
  /// Directly after the color, because they are loaded together.
  std::int32_t self = -1;
};

/// The visibility buffer: for each pixel the number of the visible triangle, and 1 / depth (0: nothing).
struct VisibilityBuffer {
  int width = 0, height = 0;
  /// At least 8 more than width, because eight lanes may be accessed from any pixel on.
  int stride = 0;
  /// The values of the pixels; rows are `stride` apart.
  float* inverseDepth = nullptr;
  std::int32_t* triangle = nullptr;
  /// d.y by x; `stride` values.
  const float* column = nullptr;
  /// d.z by y.
  const float* row = nullptr;
  /// Focal lengths in pixels.
  float focalX = 0, focalY = 0;
  /// Indexed by the triangle's number.
  TriangleRecord* records = nullptr;
  std::int32_t recordCount = 1;
  /// Buffer with four floats per vertex of the largest mesh.
  float* positions = nullptr;
  /// Buffer with four numbers of 16 bits per vertex of the largest mesh: SelectKernel.h describes them.
  std::int64_t* ranges = nullptr;
  /// Buffer with one number per triangle of the largest mesh, and eight more.
  std::int32_t* candidates = nullptr;
  /// Buffer with the box of pixels of each candidate: first column, first row, and the negated last ones, 16
  /// bits each.
  std::int64_t* boxes = nullptr;
};

/// A cell of directions around a lamp: the nearest caster of shadows in it, and the nearest one of another
/// instance, with lower bounds of their squared distances.
struct LampCell {
  /// Square meters.
  float nearest = 0;
  float second = 0;
  /// The instances of the two; they share the third word, nearestInstance in its low half. Instances whose
  /// number does not fit are -1, and are then never excluded.
  std::int16_t nearestInstance = -1;
  std::int16_t secondInstance = -1;
};
static_assert(sizeof(LampCell) == 12);

/// Eight pixels of a row of a strip; those in `lanes` see a lamp unless a ray finds an obstacle.
struct UnsureGroup {
  /// The first one, an index of the strip.
  std::int32_t pixel = 0;
  /// A row of the strip.
  std::int32_t row = 0;
  // A bit per pixel.
  std::uint32_t lanes = 0;
};

/// The unsure pixels of a strip for one lamp, one column of groups after the other. The arrays are indexed by
/// pixel.
struct UnsurePixels {
  int count = 0;
  UnsureGroup* groups = nullptr;
  /// The light that the lamp adds if it is visible.
  float* light = nullptr;
  /// From the lamp to the surface point, in the world.
  float* direction[3] = {};
  /// 2 if the pixel is in shadow, 3 if it sees the lamp, 0 if unknown. Up to a row and eight pixels beyond
  /// either end may be read.
  std::int32_t* seen = nullptr;
};

/// A lamp as the kernels need it.
struct ShadeLamp {
  float inCamera[3] = {};
  float intensity = 0, attenuation = 0;
  /// Only for spots: where the light goes, in camera space, and a line that gives the share of light from the
  /// cosine of the angle to that, before it is clamped to [0, 1]. The factor is 0 for other lamps.
  float spotDirection[3] = {};
  float spotFactor = 0, spotOffset = 0;
  /// Six faces of gridSize^2 cells, and the `nearest` of each; null if there are no shadows.
  const LampCell* cells = nullptr;
  const float* nearest = nullptr;
  /// Collects unsure pixels.
  UnsurePixels* unsure = nullptr;
};

/// Some rows of an image while they are being lit; the stride is that of the buffer, and pixel 0 the start of
/// the first row.
struct Strip {
  int firstRow = 0, rows = 0;
  // For each pixel its light, a factor of the color.
  float* light = nullptr;
  // For each pixel its color in the channels of the image.
  float* color[3] = {};
  float ambient = 0;
  /// A rotation.
  float cameraToWorld[3][3] = {};
  int gridSize = 0;
  int lampCount = 0;
  const ShadeLamp* lamps = nullptr;
};

/// Two 32-bit keys select a sequence of noise, the position of a byte in the image a number in it.
struct NoiseKey {
  std::uint32_t first = 0, second = 0;
};

/// The kernels, compiled for one kind of processor.
struct Kernels {
  /// Draws a mesh into the buffer.
  void (*draw)(const DrawJob&, VisibilityBuffer&);
  /// Computes light and color of a strip, and collects unsure pixels.
  void (*shade)(const Strip&, const VisibilityBuffer&);
  /// Resolves pixels whose neighbors agree; leaves the others in the lanes of the groups.
  void (*settle)(UnsurePixels&, int stride, float* light);
  /// Writes a row of pixels; the colors are Y, Cb - 128, Cr - 128 or R, G, B.
  void (*writeYuyv)(const float* light, const float* const color[3], int width, std::uint8_t* out);
  void (*writeRgb)(const float* light, const float* const color[3], int width, std::uint8_t* out);
  /// Adds noise to every byte.
  void (*addNoise)(std::uint8_t* bytes, int count, NoiseKey key, float scale);
};

// The two sets; kAvx2Kernels must be used only if the processor supports AVX2.
extern const Kernels kPortableKernels;
extern const Kernels kAvx2Kernels;

}  // namespace simcore::rendering
