// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colortool/votes/CellBlocks.h"

namespace colortool {

/// The votes of a sample for the cells around its own: a Gaussian that is longer along Y than along Cb and
/// Cr, where it can be longer in one direction than across it. A shaded kernel is slanted: at each brightness
/// it is centered where the sample's color would be if more or less light fell on the same thing, so that Cb
/// and Cr approach gray as it gets darker. The votes are integers, so that they can be added and removed
/// exactly. After setPeak() only const functions are used, from any thread.
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
    /// Factors of `chroma` in a direction of the plane of Cb and Cr, and across it; their product is at
    /// most 1.
    double along = 1, across = 1;
    /// The direction of `along`, in radians from Cb toward Cr.
    double direction = 0;
  };
  VoteKernel() = default;
  explicit VoteKernel(const Shape& shape);

  /// An upper bound of the votes that one cell can get if every cell of the table votes with a strength of 1
  /// and a peak of 1.
  double largestSum() const;
  /// Sets the vote, an integer, for the sample's own cell; must be called before add().
  void setPeak(double peak);

  /// Adds the votes of a sample at this cell, times `strength`, to `votes` (all cells of the table), and the
  /// blocks touched to `touched`.
  void add(std::span<std::int32_t> votes, std::size_t cell, std::int16_t strength, CellBlocks& touched) const;

 private:
  /// The votes for one brightness: the rows along Cr that are not all zero, each from its first vote on, and
  /// equally long.
  struct Slice {
    /// The first row, counted along Cb from the reach below the center, and the number of rows.
    int first = 0, rows = 0;
    /// Values per row, with zeros at the end, a multiple of the length that vector instructions add at once.
    int width = 0;
    /// The smallest and the largest begin of a row, counted along Cr from the reach below the center.
    int left = 0, right = 0;
    /// The indices of the slice's first row in begins_, and of its first value in values_.
    std::size_t row = 0, value = 0;
  };
  /// The weights of the cells around the center in Cb and Cr, (2 * chromaReach_ + 1) squared.
  std::vector<double> chromaWeights() const;
  /// Adds a slice of votes in the proportions of `weights` to slices_.
  void makeSlice(const std::vector<double>& weights, double height);
  /// Adds the votes of a slice for the brightness `y`, centered at (cb, cr).
  void addSlice(std::span<std::int32_t> votes, const Slice& slice, int y, int cb, int cr,
                std::int16_t strength, CellBlocks& touched) const;

  Shape shape_;
  /// In cells, on either side of the center.
  int chromaReach_ = 0, brightnessReach_ = 0;
  /// The slices of the kernel, indexed by brightness.
  std::vector<Slice> slices_;
  /// The begins of the rows of all slices along Cr, and their values.
  std::vector<std::int16_t> begins_, values_;
};

}  // namespace colortool
