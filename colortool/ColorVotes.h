// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "colortool/CellSet.h"
#include "colortool/ColorTable.h"
#include "colortool/LearnedTables.h"

namespace colortool {

/// How far samples are generalised, and when a colour is of no class.
struct VoteOptions {
  /// Standard deviation of a sample's vote in Cb and Cr, in values of a channel; kLeastRadius to kMostRadius.
  double radius = 8;
  /// A difference in Y counts this much against one in Cb or Cr; kLeastBrightnessWeight to 1. Below 1, since
  /// light and shadow change a colour's brightness first.
  double brightnessWeight = 0.3;
  /// What a class needs at least, as a share of a single sample pixel's vote for its own cell; 0 or more.
  double rejection = 0.1;
  /// What a sample of the background counts against one of a class; background is of many colours, and most
  /// of it is never touched by a stroke.
  double backgroundWeight = 0.3;

  static constexpr double kLeastRadius = 2, kMostRadius = 24;
  static constexpr double kLeastBrightnessWeight = 0.1;
  bool operator==(const VoteOptions&) const = default;
};

/// Makes a colour table of samples by voting: each sample votes for its class in the cells around its own,
/// the less the farther, as a Gaussian; each cell goes to the class with most votes (rUNSWift 2005, with the
/// Y axis stretched). Samples of one class in one cell count as (their number)^0.7, so that a large area does
/// not drown a careful stroke.
///
/// All sums are integers: to add samples and to take them away again leaves exactly what was there before.
/// Incremental: only the cells that a change can reach are looked at. About 1 MB a class. One thread.
class ColorVotes {
 public:
  /// `classes`: how many there are with class 0, which is the background.
  explicit ColorVotes(int classes, const VoteOptions& options = {});

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
  /// Cells, from `first` to `last` inclusive, that may have changed.
  struct Box {
    int first[3] = {ColorTable::kCells, ColorTable::kCells, ColorTable::kCells};
    int last[3] = {-1, -1, -1};
    void include(int axis, int from, int to);
    void clear() { *this = {}; }
    bool empty() const { return last[0] < 0; }
  };
  struct Sample {
    std::int64_t pixels = 0;    ///< in kUnit-ths
    std::int32_t strength = 0;  ///< what it votes with
  };
  void makeKernel();
  std::int32_t strengthOf(std::int64_t pixels, std::uint8_t colorClass) const;
  void vote(std::size_t cell, std::uint8_t colorClass, std::int32_t strength);
  void decide(int y, int cb, int block);

  VoteOptions options_;
  int chromaReach_ = 0, brightnessReach_ = 0;  // of the kernel, cells
  int kernelWidth_ = 0;                        // of its rows along cr, with zeros behind them
  std::vector<std::int16_t> kernel_;           // [y][cb][cr]
  std::int32_t priorVotes_ = 0;
  std::unordered_map<std::uint32_t, Sample> samples_;  // by cell and class
  std::vector<CellSet> sampled_;                       // by class
  std::vector<std::vector<std::int32_t>> votes_;       // by class and cell
  Box changed_;
  ColorTable table_;
};

}  // namespace colortool
