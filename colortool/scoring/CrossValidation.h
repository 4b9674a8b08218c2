// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "colortool/samples/Samples.h"
#include "colortool/scoring/Evaluation.h"

namespace colortool {

/// The share of a stroke's pixels that a table classifies correctly although it was trained without this
/// stroke.
struct StrokeScore {
  std::uint64_t stroke = 0;  ///< Stroke::id
  /// Share of the pixels, 0 to 1.
  double right = 0;
  bool operator==(const StrokeScore&) const = default;
};

/// How well samples predict each other, which estimates how a table treats colors that no stroke has touched.
struct StrokeQuality {
  /// The weight of one stroke in `evaluation`, independent of its size: a large stroke says no more about
  /// other images than a small one.
  static constexpr std::uint64_t kStroke = 1'000'000;

  /// The confusion matrix of strokes, in kStroke-ths, by the class of the stroke and the class found. Stroke
  /// weights are ignored. A stroke that excludes a class counts as background: its pixels were found as that
  /// class, or as none if they have any other class.
  Evaluation evaluation;
  /// Number of scored strokes by class number; 0 is the background.
  std::vector<int> strokesOf;
  /// The scores, one per stroke, in the order of the samples.
  std::vector<StrokeScore> strokes;
  /// Classes with a single stroke, possibly the background. No other stroke can predict it, so that their
  /// recall is near 0 and only means that a second stroke is needed.
  std::vector<std::uint8_t> alone;
};

/// Scores each stroke with a table that is trained without it, using the samples' settings including
/// corrections and clean-up. TrainingMethod::kVotes leaves out one stroke at a time (about 0.5 ms each); the
/// other methods leave out a fifth of the strokes at a time (five tables). Any thread. `proceed` is called
/// between strokes; if it returns false, the result is empty.
std::optional<StrokeQuality> crossValidate(const Samples& samples, const std::function<bool()>& proceed = {});

/// Evaluates a table that was not trained on these strokes, such as one of another team, in the same way:
/// each stroke has the same weight. The class numbers of `table` must be those of the samples.
Evaluation scoreStrokes(const Samples& samples, const ColorTable& table);

}  // namespace colortool
