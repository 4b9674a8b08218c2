// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "colortool/table/CellSet.h"
#include "colortool/votes/CellBlocks.h"

namespace colortool {

/// The additional votes that colors of things need where colors are nearly gray: walls, clothes and shadows
/// that no stroke has touched are gray, or nearly so. The votes of many samples add up, also far away from
/// all of them; so the guard grows with the samples of the class, or else each further stroke would take more
/// of the wall. Close to cells that some pixels of the class claim it does not grow beyond that of one
/// stroke: a user who paints a gray thing wants it to be one. One thread.
class GrayGuard {
 public:
  /// The sum of the strengths of the samples of one stroke of usual size, 29 pixels, in pixels.
  static constexpr double kStroke = 25;

  /// `classes`: their number. Without a height there is no guard.
  explicit GrayGuard(std::size_t classes) : byClass_(classes) {}
  /// The votes that are needed at gray by a class with a strength of `stroke` in total, the sum for one
  /// stroke.
  void setHeight(double votes, double stroke);

  /// Adds to the total strength of a class's samples, or subtracts from it.
  void addStrength(std::uint8_t colorClass, std::int64_t strength);
  /// Sets the total strengths to 0.
  void clearStrengths();
  /// Sets how many pixels of a class are in a cell, and adds the blocks where this changes the guard to
  /// `changed`.
  void setPixels(std::uint8_t colorClass, std::size_t cell, double pixels, CellBlocks& changed);
  /// Brings the guard of a class up to date with its strength. Returns whether it changed.
  bool update(std::uint8_t colorClass);
  /// Adds all blocks of `of` where colors are nearly gray to `changed`.
  static void includeGray(const CellBlocks& of, CellBlocks& changed);

  /// Whether any of the colors with this Cb is nearly gray.
  bool covers(int cb) const { return cb >= kFirst && cb <= kLast; }
  /// The votes needed in a cell, as of the last update().
  std::int32_t votes(std::uint8_t colorClass, std::size_t cell) const;
  /// The votes needed in the cells of a row of a Cb that is covered; the result is valid until the next call.
  const std::int32_t* votesOfRow(std::uint8_t colorClass, int y, int cb);

 private:
  /// The guard is 0 outside of these cells of Cb and Cr.
  static constexpr int kFirst = 25, kLast = 38;
  struct OfClass {
    std::int64_t strength = 0;
    /// The cells that its pixels claim, and those close to them.
    CellSet claims, close;
    bool changed = true;
    /// Indexed by Cb and Cr.
    std::vector<std::int32_t> votes;
    /// The cells of a row that are close to claims.
    CellSet::Row closeToClaims(int y, int cb) const;
  };

  /// For one stroke, by Cb and Cr.
  std::array<std::int32_t, CellBlocks::kRows> ofStroke_{};
  double stroke_ = 1;
  std::vector<OfClass> byClass_;
  std::array<std::int32_t, ColorTable::kCells> row_{};
};

}  // namespace colortool
