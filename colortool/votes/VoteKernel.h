// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace colortool {

/// A box of cells of a color table, from `first` to `last`, both inclusive, indexed by Y, Cb, Cr. A plain
/// value.
struct CellBox {
  int first[3], last[3];
  CellBox() { clear(); }
  /// Extends the box by the cells `from` to `to` (inclusive) of an axis, clipped to the table.
  void include(int axis, int from, int to);
  /// Makes the box empty.
  void clear();
  bool empty() const { return last[0] < 0; }
};

/// The votes of a sample for the cells around its own: a Gaussian that is longer along Y than along Cb and
/// Cr. A shaded kernel is slanted: at each brightness it is centered where the sample's color would be if
/// more or less light fell on the same thing, so that Cb and Cr approach gray as it gets darker. The votes
/// are integers, so that they can be added and removed exactly. After setPeak() only const functions are
/// used, from any thread.
class VoteKernel {
 public:
  /// The parameters of the Gaussian.
  struct Shape {
    /// Standard deviations in Cb and Cr and in Y, in cells.
    double chroma = 2, brightness = 10;
    /// Number of standard deviations beyond which a vote is 0.
    double reach = 3;
    /// Whether the kernel follows the shade of the sample's color.
    bool shaded = false;
    /// Height of its peak relative to that of other kernels.
    double height = 1;
  };
  VoteKernel() = default;
  explicit VoteKernel(const Shape& shape);

  /// An upper bound of the votes that one cell can get if every cell of the table votes with a strength of 1
  /// and a peak of 1.
  double largestSum() const;
  /// Sets the vote, an integer, for the sample's own cell; must be called before add().
  void setPeak(double peak);

  /// Adds the votes of a sample at this cell, times `strength`, to `votes` (all cells of the table), and
  /// extends `changed` by the cells touched.
  void add(std::span<std::int32_t> votes, std::size_t cell, std::int16_t strength, CellBox& changed) const;

 private:
  /// Adds the votes for one brightness, centered at (cb, cr).
  void addSlice(std::int32_t* votes, const std::int16_t* slice, int cb, int cr, std::int16_t strength) const;

  Shape shape_;
  /// In cells, on either side of the center.
  int chromaReach_ = 0, brightnessReach_ = 0;
  /// Length of the rows along Cr, padded with zeros for vector instructions.
  int width_ = 0;
  /// The votes, indexed [y][cb][cr].
  std::vector<std::int16_t> values_;
};

}  // namespace colortool
