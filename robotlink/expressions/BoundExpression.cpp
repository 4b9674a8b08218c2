// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/expressions/BoundExpression.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <set>
#include <sstream>

#include "robotlink/base/Spelling.h"
#include "robotlink/base/TextParts.h"

namespace robotlink {
namespace {

/// The names that a stream may be called by: in full, and without its robot.
std::vector<std::string> names(const std::vector<std::string>& streams,
                               const std::vector<std::string>& robots) {
  std::set<std::string> all(streams.begin(), streams.end());
  for (const std::string& stream : streams) {
    for (const std::string& robot : robots) {
      if (stream.starts_with(robot + "/")) all.insert(stream.substr(robot.size() + 1));
    }
  }
  return {all.begin(), all.end()};
}

std::string inWords(const std::optional<FieldValue>& value, int digits = 6) {
  if (!value) return "not there";
  if (value->text) return *value->text;
  if (!value->number) return "not a number";
  std::ostringstream number;
  number << std::setprecision(digits) << *value->number;
  return number.str();
}

}  // namespace

BoundExpression::BoundExpression(Expression expression, std::string robot, std::vector<std::string> streams)
    : expression_(std::move(expression)),
      robot_(std::move(robot)),
      streams_(std::move(streams)),
      values_(streams_.size()),
      found_(streams_.size()),
      checked_(streams_.size()) {}

Result<std::vector<BoundExpression>> BoundExpression::bind(std::string_view text,
                                                           const std::vector<std::string>& streams,
                                                           const std::vector<std::string>& robots) {
  const std::vector<std::string> known = names(streams, robots);
  std::vector<BoundExpression> bound;
  std::set<std::string> candidates(robots.begin(), robots.end());
  candidates.insert("");
  for (const std::string& robot : candidates) {
    auto expression = Expression::parse(text, known);
    if (!expression) return tl::unexpected(expression.error());
    std::vector<std::string> sources;
    bool isOfRobot = false;
    for (const ExpressionInput& input : expression->inputs()) {
      if (!contains(known, input.stream)) {
        const int column = input.column - 1 - static_cast<int>(input.stream.size());
        return failure("expression.stream",
                       "there is no stream " + input.stream + suggestion(input.stream, known),
                       {"", 0, column}, {input.stream});
      }
      const bool isFull = contains(streams, input.stream);
      isOfRobot |= !isFull;
      sources.push_back(isFull ? input.stream : robot + "/" + input.stream);
    }
    const bool hasAll = std::all_of(sources.begin(), sources.end(),
                                    [&](const std::string& source) { return contains(streams, source); });
    if (hasAll && isOfRobot != robot.empty())
      bound.push_back(BoundExpression(std::move(*expression), robot, std::move(sources)));
  }
  if (bound.empty()) {
    return failure("expression.robot", "no robot has all streams of this expression: " + std::string(text),
                   {}, {std::string(text)});
  }
  return bound;
}

Result<bool> BoundExpression::take(const std::string& stream, const google::protobuf::Message& message) {
  bool isNeeded = false;
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    if (streams_[i] != stream) continue;
    const ExpressionInput& input = expression_.inputs()[i];
    const google::protobuf::Descriptor* type = message.GetDescriptor();
    if (checked_[i] != type) {
      if (auto fits = input.path.fits(*type); !fits) {
        Error error = std::move(fits.error());
        error.text = stream + ": " + error.text;
        error.where.column += input.column - 1;
        return tl::unexpected(std::move(error));
      }
      checked_[i] = type;
    }
    values_[i] = input.path.valueIn(message);
    if (values_[i]) found_[i] = true;
    isNeeded = true;
  }
  return isNeeded;
}

std::vector<std::string> BoundExpression::neverFound() const {
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    if (!found_[i]) missing.push_back(streams_[i] + "." + expression_.inputs()[i].path.text());
  }
  return missing;
}

std::string BoundExpression::valuesInWords() const {
  std::string words;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const ExpressionInput& input = expression_.inputs()[i];
    words += (i > 0 ? ", " : "") + input.stream + "." + input.path.text() + " is " + inWords(values_[i]);
  }
  return words;
}

std::string BoundExpression::resultInWords() {
  return inWords(valueOrText(), std::numeric_limits<double>::digits10);
}

std::optional<FieldValue> BoundExpression::state(std::optional<double> limit) {
  const auto value = valueOrText();
  if (!limit || !value) return value;
  if (!value->number) return std::nullopt;
  return FieldValue{*value->number >= *limit ? 1.0 : 0.0, std::nullopt};
}

void BoundExpression::forget(const std::string& stream) {
  for (std::size_t i = 0; i < streams_.size(); ++i) {
    if (streams_[i] == stream) values_[i].reset();
  }
}

}  // namespace robotlink
