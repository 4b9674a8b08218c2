// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/expressions/Expression.h"

#include <muParser.h>
#include <re2/re2.h>

#include <algorithm>
#include <cmath>

#include "robotlink/expressions/ExpressionReader.h"

namespace robotlink {
namespace {

/// Returns the library's error about a formula as a sentence about the expression.
std::string problem(const mu::ParserError& error) {
  switch (error.GetCode()) {
    case mu::ecUNEXPECTED_EOF:
      return "the expression ends too early";
    case mu::ecMISSING_PARENS:
      return "a ) is missing";
    case mu::ecUNEXPECTED_PARENS:
      return "this ) has no matching (";
    case mu::ecTOO_FEW_PARAMS:
      return "the function needs more arguments";
    case mu::ecTOO_MANY_PARAMS:
      return "the function takes fewer arguments";
    default:
      return "this is not understood here";
  }
}

double logicalNot(double value) {
  return value == 0 ? 1 : 0;
}
double modulo(double value, double divisor) {
  return std::fmod(value, divisor);
}

}  // namespace

struct Expression::Implementation {
  std::string text;
  ReadExpression read;
  /// The values of the inputs, then those of the conditions. The parser keeps pointers to them.
  std::vector<double> variables;
  mu::Parser parser;

  void define() {
    variables.resize(read.inputs.size() + read.conditions.size());
    parser.DefineInfixOprt("!", logicalNot);
    parser.DefineFun("mod", modulo);
    constexpr double kPi = 3.14159265358979323846;
    parser.DefineConst("pi", kPi);
    parser.DefineConst("true", 1);
    parser.DefineConst("false", 0);
    for (std::size_t i = 0; i < read.inputs.size(); ++i)
      parser.DefineVar("v" + std::to_string(i), &variables[i]);
    for (std::size_t i = 0; i < read.conditions.size(); ++i)
      parser.DefineVar("c" + std::to_string(i), &variables[read.inputs.size() + i]);
    parser.SetExpr(read.formula);
  }
};

Expression::Expression(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

Result<Expression> Expression::parse(std::string_view text, const std::vector<std::string>& streams) {
  const auto wrong = [](std::string what, int column) {
    return failure("expression.syntax", std::move(what), {"", 0, column});
  };
  if (text.size() > kMaxLength)
    return wrong("the expression is longer than " + std::to_string(kMaxLength) + " characters", 0);
  auto read = readExpression(text, streams);
  if (!read) return tl::unexpected(read.error());
  auto implementation = std::make_unique<Implementation>();
  implementation->text = text;
  implementation->read = std::move(*read);
  try {
    implementation->define();
    int results = 0;
    implementation->parser.Eval(results);
    if (results != 1) return wrong("an expression has one result; use commas only between arguments", 1);
  } catch (const mu::ParserError& error) {
    const auto& places = implementation->read.places;
    const std::size_t last = places.size() - 1;
    const std::size_t place =
        error.GetPos() < 0 ? last : std::min(static_cast<std::size_t>(error.GetPos()), last);
    return wrong(problem(error), places[place] + 1);
  }
  return Expression(std::move(implementation));
}

const std::vector<ExpressionInput>& Expression::inputs() const {
  return implementation_->read.inputs;
}

const std::string& Expression::text() const {
  return implementation_->text;
}

std::string Expression::withStreams(const std::function<std::string(const std::string&)>& nameOf) const {
  std::string text;
  std::size_t done = 0;
  for (const auto& [begin, length] : implementation_->read.streams) {
    text += implementation_->text.substr(done, begin - done);
    text += nameOf(implementation_->text.substr(begin, length));
    done = begin + length;
  }
  return text + implementation_->text.substr(done);
}

std::optional<FieldValue> Expression::valueOrText(std::span<const std::optional<FieldValue>> values) {
  const auto& read = implementation_->read;
  const bool isOneValue = read.inputs.size() == 1 && read.conditions.empty() && read.formula == "v0";
  if (isOneValue) return values[0];
  const auto number = value(values);
  return number ? std::optional(FieldValue{number, std::nullopt}) : std::nullopt;
}

std::optional<double> Expression::value(std::span<const std::optional<FieldValue>> values) {
  const auto& read = implementation_->read;
  auto& variables = implementation_->variables;
  // Inputs that are compared with texts only need no number.
  std::vector<bool> isText(read.inputs.size());
  for (std::size_t i = 0; i < read.conditions.size(); ++i) {
    const TextCondition& condition = read.conditions[i];
    const auto& value = values[condition.input];
    if (!value || !value->text) return std::nullopt;
    const bool fits = condition.pattern ? re2::RE2::PartialMatch(*value->text, *condition.pattern)
                                        : *value->text == condition.text;
    variables[read.inputs.size() + i] = fits != condition.isNegated ? 1 : 0;
    isText[condition.input] = true;
  }
  for (std::size_t i = 0; i < read.inputs.size(); ++i) {
    const auto& value = values[i];
    if (!value || (!value->number && !isText[i])) return std::nullopt;
    variables[i] = value->number.value_or(0);
  }
  try {
    const double result = implementation_->parser.Eval();
    return std::isnan(result) ? std::nullopt : std::optional(result);
  } catch (const mu::ParserError&) {
    return std::nullopt;
  }
}

}  // namespace robotlink
