// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/expressions/Expression.h"

namespace robotlink {

/// An expression whose values come from the streams of a log or session. Streams that it names without a
/// robot ("models/ball") are those of one robot. One thread.
class BoundExpression {
 public:
  /// Parses an expression and binds it once for each robot that has all streams that are named without one,
  /// or once, with an empty robot, if there are none of these. Fails if it cannot be parsed, or with the
  /// nearest name if no robot has a stream.
  static Result<std::vector<BoundExpression>> bind(std::string_view text,
                                                   const std::vector<std::string>& streams,
                                                   const std::vector<std::string>& robots);

  /// The robot whose streams are meant; empty if all are named in full.
  const std::string& robot() const { return robot_; }
  /// The full paths of the streams that it needs, for each of its inputs.
  const std::vector<std::string>& streams() const { return streams_; }
  /// Stores the values of a newer message. True if it has some. Fails if its type has no such field.
  Result<bool> take(const std::string& stream, const google::protobuf::Message& message);
  /// Forgets the values of a stream, as of an event that is over, or before its first message.
  void forget(const std::string& stream);
  /// The values of the expression that no message has had so far, such as a misspelled field.
  std::vector<std::string> neverFound() const;
  /// Returns the newest values for people: "models/ball.position.x is 0.31, hosting.state is RUNNING".
  std::string valuesInWords() const;
  /// The result for the newest values; see Expression::value().
  std::optional<double> value() { return expression_.value(values_); }
  /// The same for people: a number, a text, the name of a choice; "not there" while there are no values.
  std::string resultInWords();
  /// See Expression::valueOrText().
  std::optional<FieldValue> valueOrText() { return expression_.valueOrText(values_); }
  /// Returns the state that change steps compare: the value or, with a limit, whether it has reached that.
  std::optional<FieldValue> state(std::optional<double> limit);

 private:
  BoundExpression(Expression expression, std::string robot, std::vector<std::string> streams);

  Expression expression_;
  std::string robot_;
  std::vector<std::string> streams_;
  std::vector<std::optional<FieldValue>> values_;
  /// For each input whether a message had its value.
  std::vector<bool> found_;
  /// For each input the type of message that its path was checked with.
  std::vector<const google::protobuf::Descriptor*> checked_;
};

}  // namespace robotlink
