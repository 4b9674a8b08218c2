// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "colortool/CellSet.h"
#include "colortool/ColorTable.h"
#include "colortool/LearnedTables.h"
#include "colortool/VoteKernel.h"

namespace colortool {

/// How far samples are generalised, and when a colour is of no class.
struct VoteOptions {
  /// Standard deviation of a sample's vote in Cb and Cr, in values of a channel; kMinRadius to kMaxRadius.
  double radius = 8;
  /// A difference in Y counts this much against one in Cb or Cr; kMinBrightnessWeight to 1. Below 1, since
  /// light and shadow change a colour's brightness first.
  double brightnessWeight = 0.3;
  /// What a class needs at least, as a share of a single sample pixel's vote for its own cell; 0 or more.
  double rejection = 0.05;
  /// What a sample of the background counts against one of a class; background is of many colours, and most
  /// of it is never touched by a stroke.
  double backgroundWeight = 0.3;
  /// What a sample votes with along its shade, as a share of its vote for its own cell; 0: not at all. It
  /// decides where no sample is near: shadow and glare change Cb and Cr along with Y.
  double shading = 0.1;
  /// What the color of a thing needs more where colors are nearly gray, in votes of a sample pixel: walls,
  /// clothes and shadows that no stroke has touched are gray, or nearly so.
  double grayGuard = 8;

  static constexpr double kMinRadius = 2, kMaxRadius = 24;
  static constexpr double kMinBrightnessWeight = 0.1;
  static constexpr double kMaxShading = 0.5;
  bool operator==(const VoteOptions&) const = default;
};

/// Makes a colour table of samples by voting: each sample votes for its class in the cells around its own,
/// the less the farther, as a Gaussian; each cell goes to the class with most votes (rUNSWift 2005, with the
/// Y axis stretched). A second, weak vote reaches farther, along what more or less light makes of the color.
/// Samples of one class in one cell count as (their number)^0.7, so that a large area does not drown a
/// careful stroke.
///
/// All sums are integers: to add samples and to take them away again leaves exactly what was there before.
/// Incremental: only the cells that a change can reach are looked at. About 1 MB a class. One thread.
class ColorVotes {
 public:
  /// `classes`: how many there are with class 0, which is the background.
  explicit ColorVotes(int classes, const VoteOptions& options = {});
  /// Which classes are colors of things, by number; see thingClasses(). Of these the gray guard asks for
  /// more. At first none is.
  void setThings(std::vector<bool> things);

  /// Adds `pixels` samples of a colour (negative: takes them away, or says that it must not be of that
  /// class). Weighs in kUnit-ths of a pixel. The table follows with the next call of update().
  void add(std::size_t cell, std::uint8_t colorClass, std::int64_t pixels);
  static constexpr std::int64_t kUnit = 16;

  /// The options of all that was added so far, too: everything is voted anew.
  void setOptions(const VoteOptions& options);
  const VoteOptions& options() const { return options_; }

  /// The table of all that was added. Valid until the next call.
  const ColorTable& update();
  /// How sure the table is of a cell: what the best one has more than the second, as a share of what it has,
  /// 0 to 1. Background takes part: it has its votes and what the rejection asks for. As of the last
  /// update().
  double margin(std::size_t cell) const;
  /// Each class that comes near the best one, as bit i for class i + 1: those with at least `share` of its
  /// votes.
  std::uint16_t classesOf(std::size_t cell, double share) const;

  /// All that was added and not taken away, where it speaks for its class; by cell and class.
  std::vector<CellSamples> samples() const;
  /// The cells of samples(), by class. Valid until the next call.
  std::span<const CellSet> sampledCells() const { return sampled_; }

  int classes() const { return static_cast<int>(votes_.size()); }

 private:
  struct Sample {
    std::int64_t pixels = 0;    ///< in kUnit-ths
    std::int32_t strength = 0;  ///< what it votes with
  };
  void makeKernels();
  void makeGuard(double peak);
  std::int32_t strengthOf(std::int64_t pixels, std::uint8_t colorClass) const;
  void vote(std::size_t cell, std::uint8_t colorClass, std::int32_t before, std::int32_t strength);
  /// What a class has in a cell, prior and guard included.
  std::int32_t votesOf(std::size_t colorClass, std::size_t cell) const;
  void decide(int y, int cb, int block);

  VoteOptions options_;
  VoteKernel near_, shade_;
  std::int32_t priorVotes_ = 0;
  std::vector<std::int32_t> guard_;  // what a thing's votes must exceed the others' by, by Cb and Cr
  std::vector<bool> things_;         // by class
  std::unordered_map<std::uint32_t, Sample> samples_;  // by cell and class
  std::vector<CellSet> sampled_;                       // by class
  std::vector<std::vector<std::int32_t>> votes_;       // by class and cell
  CellBox changed_;
  ColorTable table_;
};

}  // namespace colortool
