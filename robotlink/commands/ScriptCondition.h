// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "robotlink/base/Error.h"
#include "robotlink/expressions/BoundExpression.h"
#include "robotlink/session/Session.h"

namespace robotlink {

/// Evaluates an expression over the streams of a session, from its construction on. It sees every message,
/// so that a value that is true only between two ticks is not missed. Streams without a robot are those of
/// the selected one; `simulation.time` is the session's time in seconds, also on logs. Only in the thread
/// that calls Session::tick(); the session must outlive it.
class ScriptCondition {
 public:
  /// Gets each value that a message gives the expression, and the time of that message.
  using Observer = std::function<void(double value, Instant time)>;
  /// `observe` may be empty.
  ScriptCondition(Session& session, std::string expression, Observer observe = {});
  ~ScriptCondition();
  ScriptCondition(const ScriptCondition&) = delete;
  ScriptCondition& operator=(const ScriptCondition&) = delete;

  /// Whether it was true at some message since the last look, or is now. Streams may still appear; an
  /// expression that will never be understood fails, with the column.
  Result<bool> look();
  /// Whether it is true now; fails if a stream is missing.
  Result<bool> now();
  /// Returns the value for people: a number, a text, the name of a choice; "not there" if no message had it.
  /// Fails if a stream is missing.
  Result<std::string> valueNow();
  /// Returns the present values for people: "models/ball.position.x is 0.31", or why there are none.
  std::string values() const;

 private:
  /// Binds the expression to the streams that there are, if they have changed.
  void bind();
  /// Returns a remedy for a stream that is missing; empty if none is known.
  std::string hintFor(const Error& error) const;
  /// Takes the newest messages of the history.
  void takeNewest();
  void take(const StreamMessage& message);
  void takeTime(Instant time);
  void takeValue(const std::string& stream, const google::protobuf::Message& value);
  bool isTrue();

  Session& session_;
  std::string text_;
  Observer observe_;
  std::uint64_t listener_ = 0;
  std::optional<BoundExpression> bound_;
  bool usesTime_ = false;
  bool wasTrue_ = false;
  /// Why it is not bound: a stream is missing.
  std::optional<Error> missing_;
  /// Why it cannot be understood.
  std::optional<Error> wrong_;
  // The store's versions when the expression was bound; unset: never bound.
  std::optional<std::uint64_t> listVersion_, generation_;
  std::string robot_;
};

}  // namespace robotlink
