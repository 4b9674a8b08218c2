// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSurface.h"

#include <Eigen/Geometry>

namespace widgets {
namespace {

using colortool::ColorTable;
using Eigen::Vector3f;

constexpr int kCells = ColorTable::kCells;

/// A side of a cell: axis and step to the neighbor, and the corners as offsets (y, cb, cr).
struct Side {
  int axis;
  int step;
  std::array<std::array<int, 3>, 4> corners;
};
constexpr Side kSides[] = {
    {0, -1, {{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}}},
    {0, 1, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}},
    {1, -1, {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}}},
    {1, 1, {{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}}},
    {2, -1, {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}}},
    {2, 1, {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}},
};
constexpr std::array<int, 3> kStrides = {kCells * kCells, kCells, 1};

/// The face with its corners counterclockwise as seen from outside of its cell. Some spaces mirror cells.
SurfaceFace makeFace(const ColorLattice& lattice, std::size_t cell, const std::array<int, 3>& at,
                     const Side& side, std::uint8_t colorClass) {
  SurfaceFace face;
  face.cell = static_cast<std::uint32_t>(cell);
  face.colorClass = colorClass;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& corner = side.corners[i];
    face.corners[i] = ColorLattice::cornerOf(at[0] + corner[0], at[1] + corner[1], at[2] + corner[2]);
  }
  const auto place = [&](std::size_t i) -> const Vector3f& { return lattice.corner(face.corners[i]); };
  // The product of the diagonals: a face that is folded to a triangle has a normal, too.
  face.normal = (place(2) - place(0)).cross(place(3) - place(1));
  const Vector3f middle = (place(0) + place(1) + place(2) + place(3)) / 4;
  if (face.normal.dot(middle - lattice.center(cell)) < 0) {
    std::swap(face.corners[1], face.corners[3]);
    face.normal = -face.normal;
  }
  return face;
}

/// Averages the normals of faces of one class at their common corners, so that surfaces are shaded smoothly.
/// `sums` is all zero before and after.
void evenOut(std::span<SurfaceFace*> faces, std::vector<Vector3f>& sums) {
  for (const SurfaceFace* face : faces) {
    for (const std::uint32_t corner : face->corners) sums[corner] += face->normal;
  }
  std::vector<Vector3f> even;
  even.reserve(faces.size());
  for (const SurfaceFace* face : faces) {
    Vector3f normal = face->normal;
    for (const std::uint32_t corner : face->corners) normal += sums[corner];
    even.push_back(normal);
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const std::uint32_t corner : faces[i]->corners) sums[corner].setZero();
    faces[i]->normal = even[i].norm() > 0 ? Vector3f(even[i].normalized()) : Vector3f::UnitZ();
  }
}

}  // namespace

std::vector<SurfaceFace> surfacesOf(std::span<const std::uint8_t, ColorTable::kCellCount> classes,
                                    const colortool::CellSet& visible, const ColorLattice& lattice) {
  const auto classOf = [&](std::size_t cell) {
    return visible.contains(cell) ? classes[cell] : colortool::ColorClasses::kNone;
  };
  std::vector<SurfaceFace> faces;
  for (std::size_t cell = 0; cell < classes.size(); ++cell) {
    const std::uint8_t colorClass = classOf(cell);
    if (colorClass == colortool::ColorClasses::kNone) continue;
    const std::array<int, 3> at = {static_cast<int>(cell >> 12U), static_cast<int>(cell >> 6U & 63U),
                                   static_cast<int>(cell & 63U)};
    for (const Side& side : kSides) {
      const auto axis = static_cast<std::size_t>(side.axis);
      const int next = at[axis] + side.step;
      const bool inside = next >= 0 && next < kCells;
      const auto neighbor = static_cast<std::size_t>(static_cast<int>(cell) + side.step * kStrides[axis]);
      if (inside && classOf(neighbor) == colorClass) continue;
      faces.push_back(makeFace(lattice, cell, at, side, colorClass));
    }
  }
  std::array<std::vector<SurfaceFace*>, 256> byClass;
  for (SurfaceFace& face : faces) byClass[face.colorClass].push_back(&face);
  std::vector<Vector3f> sums(
      std::size_t{ColorLattice::kCorners} * ColorLattice::kCorners * ColorLattice::kCorners,
      Vector3f::Zero());
  for (auto& ofClass : byClass) evenOut(ofClass, sums);
  return faces;
}

}  // namespace widgets
