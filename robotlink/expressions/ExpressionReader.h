// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/expressions/ExpressionInput.h"

namespace re2 {
class RE2;
}  // namespace re2

namespace robotlink {

/// A comparison of an input with a text.
struct TextCondition {
  std::size_t input = 0;
  std::string text;
  /// Whether it is true if they differ.
  bool isNegated = false;
  /// Set: the value contains a match, rather than equals the text.
  std::shared_ptr<const re2::RE2> pattern;
};

/// An expression in which each value and each comparison with a text is replaced by a variable, as the
/// library for formulas reads it.
struct ReadExpression {
  /// With the variables v0, v1, ... for `inputs`, and c0, c1, ... for `conditions`.
  std::string formula;
  /// For each character of the formula, where it comes from in the expression, from 0; one more for the end.
  std::vector<int> places;
  std::vector<ExpressionInput> inputs;
  /// The names of streams in the expression, in order: the position from 0, and the length.
  std::vector<std::pair<std::size_t, std::size_t>> streams = {};
  std::vector<TextCondition> conditions;
};

/// Finds the values in an expression; see Expression::parse().
Result<ReadExpression> readExpression(std::string_view text, const std::vector<std::string>& streams);

}  // namespace robotlink
