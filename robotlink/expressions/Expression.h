// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/expressions/ExpressionInput.h"

namespace robotlink {

/// A formula over values of streams, such as `models/ball.position.x > 1 && hosting.state == "RUNNING"`.
/// EXPRESSIONS.md says what can be written. Movable; one thread.
class Expression {
 public:
  static constexpr std::size_t kMaxLength = 10'000;

  /// Parses an expression; FilePosition::column of errors counts from 1. `streams` are the paths of known
  /// streams, whose names may have characters that would otherwise end a name, such as a dot.
  static Result<Expression> parse(std::string_view text, const std::vector<std::string>& streams = {});
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  /// The values that it uses, each once.
  const std::vector<ExpressionInput>& inputs() const;
  /// The result for the values of the inputs, in their order. Empty as long as one of them is not known, is a
  /// text where a number is needed, or if the result is not a number. Conditions are 0 or 1.
  std::optional<double> value(std::span<const std::optional<FieldValue>> values);
  /// The same; but of an expression that is nothing but one value that value, which may be a text.
  std::optional<FieldValue> valueOrText(std::span<const std::optional<FieldValue>> values);
  /// Returns the text of the expression.
  const std::string& text() const;
  /// Returns the text of the expression with other names of its streams.
  std::string withStreams(const std::function<std::string(const std::string& stream)>& nameOf) const;

 private:
  struct Implementation;
  explicit Expression(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink
