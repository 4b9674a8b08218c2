// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ode/ode.h>

#include <array>
#include <cstdint>
#include <vector>

#include "simcore/physics/shapes/Footprint.h"

namespace simcore {

/// A grid over the ground with the static geoms of a world, to find those near a place: maps of buildings
/// have thousands, which ODE's own spaces would compare with each robot one by one. Built once; unbounded
/// geoms (planes) are kept separately. A query costs some 50 ns where few geoms are near.
///
/// Memory and the time to build it are bounded: if long walls would occupy too many cells, the cells are made
/// larger. Queries are const but not thread-safe.
class StaticGrid {
 public:
  /// The limit of geoms in all cells together, unless there are more geoms than that.
  static constexpr std::size_t kMaxEntries = std::size_t{1} << 23U;

  /// Minimum and maximum of x, y, z in turn, as in ODE.
  using Bounds = std::array<dReal, 6>;

  static bool overlap(const Bounds& a, const Bounds& b) {
    return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3] && a[4] <= b[5] && b[4] <= a[5];
  }

  /// Adds a geom that will not move; only before build().
  void add(dGeomID geom);
  /// Sorts the geoms into cells.
  void build();

  /// Sets `found` to the geoms whose bounds meet `bounds`, in an order that depends only on the geoms and the
  /// bounds.
  void near(const Bounds& bounds, std::vector<dGeomID>& found) const;
  /// Whether any geom may overlap a rectangle, seen from above.
  bool meetsAny(const Footprint& footprint) const;
  /// A lower bound of the distance from a point to the nearest geom, seen from above; at most `most`.
  double clearance(double x, double y, double most) const;
  /// The geoms without finite bounds, in the order of add().
  const std::vector<dGeomID>& unbounded() const { return unbounded_; }
  /// The number of bounded geoms.
  std::size_t size() const { return geoms_.size(); }
  /// The number of entries in all cells together.
  std::size_t entries() const { return inCells_.size(); }

 private:
  /// A range of cells.
  struct Cells {
    int x0, x1, y0, y1;  ///< inclusive
  };
  /// The cells that a rectangle covers; an empty range if it is outside the grid.
  Cells cellsOf(double x0, double x1, double y0, double y1) const;
  void setCellSize(double cell, double width, double height);
  /// Calls `visit(cell, geom)` for each geom and each cell that it meets, until `visit` returns false;
  /// returns whether all were visited.
  template <typename Visit>
  bool forEachEntry(Visit visit) const;
  /// Calls `visit(geom)` for each entry of a range of cells; a geom may occur repeatedly.
  template <typename Visit>
  void forEachIn(const Cells& cells, Visit visit) const;

  std::vector<dGeomID> geoms_, unbounded_;
  // The bounds and footprints of the geoms, one of each per geom.
  std::vector<Bounds> bounds_;
  std::vector<Footprint> footprints_;
  // Origin and size of the cells, m.
  double left_ = 0, bottom_ = 0, cell_ = 0.5;
  int columns_ = 0, rows_ = 0;
  /// Cell i contains inCells_[firstInCell_[i]] up to inCells_[firstInCell_[i + 1]], exclusive.
  std::vector<std::uint32_t> firstInCell_, inCells_;
  /// For each geom, the number of the last query that found it.
  mutable std::vector<std::uint32_t> seenIn_;
  mutable std::uint32_t query_ = 0;
};

}  // namespace simcore
