// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ode/ode.h>

#include <array>
#include <cstdint>
#include <vector>

#include "simcore/physics/Footprint.h"

namespace simcore {

/// The static geoms of a world in square cells over the ground, to find those near a place without looking at
/// all of them: maps of buildings have thousands, which ODE's own spaces would compare with each robot one by
/// one. Built once; geoms without an end (planes) are kept aside. Cheap where little stands: some 50 ns a
/// query.
///
/// Memory and the time to build it are bounded, whatever is added: where long walls would be in too many
/// cells, there are fewer and larger ones.
class StaticGrid {
 public:
  static constexpr std::size_t kMaximumEntries = std::size_t{1} << 23U;  ///< geoms in cells, or one a geom

  using Bounds = std::array<dReal, 6>;  ///< least and greatest x, y, z in turn, as ODE has them

  static bool overlap(const Bounds& a, const Bounds& b) {
    return a[0] <= b[1] && b[0] <= a[1] && a[2] <= b[3] && b[2] <= a[3] && a[4] <= b[5] && b[4] <= a[5];
  }

  void add(dGeomID geom);
  void build();

  /// Sets `found` to the geoms whose bounds meet `bounds`, in an order that depends on both only.
  void near(const Bounds& bounds, std::vector<dGeomID>& found) const;
  /// Whether one of them may be within a rectangle, seen from above.
  bool meetsAny(const Footprint& footprint) const;
  /// How far it is at least from a point to the nearest geom, seen from above, if that is less than `most`;
  /// else `most`.
  double clearance(double x, double y, double most) const;
  const std::vector<dGeomID>& unbounded() const { return unbounded_; }
  std::size_t size() const { return geoms_.size(); }
  /// How many geoms are in all cells together.
  std::size_t entries() const { return inCells_.size(); }

 private:
  struct Cells {
    int x0, x1, y0, y1;  ///< inclusive
  };
  Cells cellsOf(double x0, double x1, double y0, double y1) const;
  void setCellSize(double cell, double width, double height);
  /// Calls `visit(cell, geom)` for each geom and each cell that it meets, until `visit` returns false.
  template <typename Visit>
  bool forEachEntry(Visit visit) const;
  template <typename Visit>
  void forEachIn(const Cells& cells, Visit visit) const;

  std::vector<dGeomID> geoms_, unbounded_;
  std::vector<Bounds> bounds_;
  std::vector<Footprint> footprints_;
  double left_ = 0, bottom_ = 0, cell_ = 0.5;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> firstInCell_,
      inCells_;                                ///< cell i holds inCells_[firstInCell_[i]] to before [i + 1]
  mutable std::vector<std::uint32_t> seenIn_;  ///< by geom: the last query that met it
  mutable std::uint32_t query_ = 0;
};

}  // namespace simcore
