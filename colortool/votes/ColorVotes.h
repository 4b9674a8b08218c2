// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "colortool/table/CellSet.h"
#include "colortool/table/ColorTable.h"
#include "colortool/votes/CellBlocks.h"
#include "colortool/votes/GrayGuard.h"
#include "colortool/votes/LearnedTables.h"
#include "colortool/votes/NearKernels.h"
#include "colortool/votes/VoteKernel.h"

namespace colortool {

/// How far samples generalize in color space, and when a color belongs to no class. ColorVotes::setOptions()
/// clamps values that are out of range. A plain value.
struct VoteOptions {
  /// Standard deviation of a sample's vote in Cb and Cr, in values of a channel; kMinRadius to kMaxRadius.
  /// That of saturated colors is longer along their saturation, and shorter across it, see NearKernels.
  double radius = 8;
  /// A difference in Y counts this much against one in Cb or Cr; kMinBrightnessWeight to 1. Below 1, since
  /// light and shadow change a color's brightness first.
  double brightnessWeight = 0.3;
  /// Minimum votes that a class needs to win a cell, as a share of the vote of a single sample pixel for its
  /// own cell; 0 or more.
  double rejection = 0.05;
  /// Weight of a background sample relative to one of a class, 0 to kMaxBackgroundWeight. It is below 1
  /// because background has many colors, most of which no stroke ever touches.
  double backgroundWeight = 0.3;
  /// Strength of the second, wider vote along the shade of the color, as a share of the vote for the sample's
  /// own cell; 0 disables it, kMaxShading is the maximum. It decides where no sample is near: shadow and
  /// glare change Cb and Cr along with Y.
  double shading = 0.15;
  /// The additional votes that the color of a thing needs where colors are nearly gray, in votes of a sample
  /// pixel for each stroke's worth of samples of its class, see GrayGuard.
  double grayGuard = 16;

  static constexpr double kMinRadius = 2, kMaxRadius = 24;
  static constexpr double kMinBrightnessWeight = 0.1;
  static constexpr double kMaxBackgroundWeight = 1;
  static constexpr double kMaxShading = 0.5;
  bool operator==(const VoteOptions&) const = default;
};

/// Learns a color table from samples by voting. Each sample votes for its class in the cells around its own
/// with a Gaussian weight, and each cell goes to the class with the most votes (rUNSWift 2005, with the Y
/// axis stretched). A second, weak vote reaches farther, along the colors that the same thing has in more or
/// less light. n samples of one class in one cell count as n^0.7, so that a large area does not outweigh a
/// careful stroke.
///
/// All sums are integers: adding samples and removing them again restores exactly the state before.
/// Incremental: update() visits only the cells that a change can reach. About 1 MB per class. One thread.
class ColorVotes {
 public:
  /// `classes`: the number of classes, including class 0, the background.
  explicit ColorVotes(int classes, const VoteOptions& options = {});
  /// Sets which classes are colors of things, by class number, see objectClasses(). The gray guard applies to
  /// these only. Initially there are none.
  void setThings(std::vector<bool> things);

  /// Adds `pixels` samples of a color, in kUnit-ths of a pixel. A negative number removes samples, or, below
  /// zero in total, says that the color must not be of this class. Unknown classes and cells are ignored. The
  /// table changes at the next call of update().
  void add(std::size_t cell, std::uint8_t colorClass, std::int64_t pixels);
  /// Units per sample pixel, so that strokes can have fractional weights.
  static constexpr std::int64_t kUnit = 16;

  /// Changes the options for all samples, also for those added before: all votes are computed again.
  void setOptions(const VoteOptions& options);
  const VoteOptions& options() const { return options_; }

  /// Decides the cells that changed and returns the table. Valid until the next call.
  const ColorTable& update();
  /// The confidence of the table in a cell as of the last update(), 0 to 1: the lead of the winner over the
  /// second, as a share of the winner's votes. Background takes part with its own votes plus those that the
  /// rejection adds.
  double margin(std::size_t cell) const;
  /// All classes that come near the winner of a cell, as a bit mask (bit i for class i + 1): those with at
  /// least `share` of its votes. 0 if the cell is of no class; classes above 16 have no bit.
  std::uint16_t classesOf(std::size_t cell, double share) const;

  /// All samples that speak for their class, sorted by cell and class; those that exclude a class are left
  /// out.
  std::vector<CellSamples> samples() const;
  /// The cells of samples(), indexed by class. Valid until the next call.
  std::span<const CellSet> sampledCells() const { return sampled_; }

  /// Number of classes, including class 0.
  int classes() const { return static_cast<int>(votes_.size()); }

 private:
  /// The sum of all samples of one class in one cell.
  struct Sample {
    /// In kUnit-ths of a pixel.
    std::int64_t pixels = 0;
    /// The weight of the vote: the pixels, limited, raised to the power of 0.7, and scaled to an integer.
    std::int32_t strength = 0;
  };
  /// Computes kernels, prior and guard from the options.
  void makeKernels();
  std::int32_t strengthOf(std::int64_t pixels, std::uint8_t colorClass) const;
  /// Replaces the vote of a cell's samples by one of another strength.
  void vote(std::size_t cell, std::uint8_t colorClass, std::int32_t before, std::int32_t strength);
  /// Votes of a class in a cell, with prior (background) and gray guard (things) applied.
  std::int32_t votesOf(std::size_t colorClass, std::size_t cell) const;
  /// Determines the winners of one block of cells along Cr.
  void decide(int y, int cb, int block);

  VoteOptions options_;
  /// The vote around the sample's own color, and the weak one along its shade.
  NearKernels near_;
  VoteKernel shade_;
  /// Votes that background has everywhere: the rejection.
  std::int32_t priorVotes_ = 0;
  std::vector<bool> things_;  // by class
  /// Keyed by cell and class.
  std::unordered_map<std::uint32_t, Sample> samples_;
  std::vector<CellSet> sampled_;  // by class
  /// Indexed by class and cell.
  std::vector<std::vector<std::int32_t>> votes_;
  GrayGuard guard_;
  /// The blocks where a class may have votes, by class.
  std::vector<CellBlocks> touched_;
  /// The blocks that may have changed since the last update().
  CellBlocks changed_;
  ColorTable table_;
};

}  // namespace colortool
