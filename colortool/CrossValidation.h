// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "colortool/Evaluation.h"
#include "colortool/Samples.h"

namespace colortool {

/// How many of a stroke's pixels a table finds right that was made without that stroke.
struct StrokeScore {
  std::uint64_t stroke = 0;  ///< Stroke::id
  double right = 0;          ///< share of its pixels
  bool operator==(const StrokeScore&) const = default;
};

/// How well samples predict each other: what is to be expected of colours that nobody has touched.
struct StrokeQuality {
  /// What a stroke counts in `evaluation`, however many pixels it has: a large stroke says no more of other
  /// images than a small one.
  static constexpr std::uint64_t kStroke = 1'000'000;

  /// Shares of strokes, in kStroke-ths, by what the stroke says and what was found. Weights do not count.
  /// What must not be of a class is background here: found as that class, or as none if it is anything else.
  Evaluation evaluation;
  /// How many strokes each class has, by its number, that it was scored by; 0: the background.
  std::vector<int> strokesOf;
  std::vector<StrokeScore> strokes;  ///< in the order of the samples
  /// Classes with a single stroke, also the background. There is nothing to predict it from, so that their
  /// recall is 0 or little more, and says nothing but that a second stroke is needed.
  std::vector<std::uint8_t> alone;
};

/// Scores each stroke with a table that is made without it, as the samples' settings say, corrections and
/// clean-up included: with TrainingMethod::kVotes without this stroke alone (about 0.5 ms each), with the
/// other methods without a fifth of the strokes at a time (five tables). Any thread; `goOn` is asked in
/// between, and if it says no there is no result.
std::optional<StrokeQuality> crossValidate(const Samples& samples, const std::function<bool()>& goOn = {});

/// The same of a table that was not made of these strokes, such as another team's: each stroke counts once.
/// `table` is of the samples' classes.
Evaluation scoreStrokes(const Samples& samples, const ColorTable& table);

}  // namespace colortool
