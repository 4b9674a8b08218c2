// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace colortool {

/// A box of cells of a color table, from `first` to `last` inclusive, by Y, Cb, Cr. A plain value.
struct CellBox {
  int first[3], last[3];
  CellBox() { clear(); }
  /// Makes it reach over these cells of an axis, too; what lies outside of the table is left out.
  void include(int axis, int from, int to);
  void clear();
  bool empty() const { return last[0] < 0; }
};

/// What a sample votes with in the cells around its own: a Gaussian that is longer along Y than along Cb and
/// Cr. With a shade it leans: at each brightness it is centered where the sample's color would be if more or
/// less light fell on the same thing, so that Cb and Cr come nearer to gray as it gets darker. Whole numbers,
/// so that votes can be added and taken away exactly. Constant once it is made; any thread.
class VoteKernel {
 public:
  struct Shape {
    double chroma = 2, brightness = 10;  ///< standard deviations, cells
    double reach = 3;                    ///< past so many of them a vote is none
    bool shaded = false;
    double height = 1;  ///< of its peak, against that of other kernels
  };
  VoteKernel() = default;
  explicit VoteKernel(const Shape& shape);

  /// An upper bound of the sum of what one cell gets if each cell of the table votes with a strength of 1 and
  /// a peak of 1.
  double largestSum() const;
  /// Sets the whole number that the vote for the sample's own cell is; before add().
  void setPeak(double peak);

  /// Adds the votes of a sample at this cell to all cells' votes, times `strength`, and the touched cells to
  /// `changed`.
  void add(std::span<std::int32_t> votes, std::size_t cell, std::int16_t strength, CellBox& changed) const;

 private:
  void addSlice(std::int32_t* votes, const std::int16_t* slice, int cb, int cr, std::int16_t strength) const;

  Shape shape_;
  int chromaReach_ = 0, brightnessReach_ = 0;  // cells
  int width_ = 0;                              // of the rows along Cr, with zeros behind them
  std::vector<std::int16_t> values_;           // [y][cb][cr]
};

}  // namespace colortool
