// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robotlink/expressions/BoundExpression.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// A span of time in which an expression was true, or a text for which it was.
struct SearchHit {
  /// Empty if the expression names all its streams in full.
  std::string robot;
  /// When it became true, in the time of the messages.
  robotlink::Instant from;
  /// When it was no longer true; empty: it was still true at the end of the range. Equals `from` for texts.
  std::optional<robotlink::Instant> until;
  /// The text, if the hit is one.
  std::optional<robotlink::StreamMessage> text;
};

/// Finds where expressions become true among messages that are taken in order of time. Messages of the same
/// time count together, but texts (foxglove.Log) are hits one by one. One thread.
class ConditionMatcher {
 public:
  /// Gets each hit when it is complete; returns false to end.
  using Found = std::function<bool(const SearchHit&)>;
  /// The error with which a function ends since nothing more is wanted.
  static constexpr char kEnough[] = "search.enough";

  explicit ConditionMatcher(Found found) : found_(std::move(found)) {}
  void add(std::vector<robotlink::BoundExpression> expressions);
  /// The full paths of the streams that are needed.
  const std::set<std::string>& streams() const { return streams_; }

  /// Sets the time at which values count that were taken before.
  void beginAt(robotlink::Instant time) { time_ = time; }
  /// Takes a value from before the range, but no text. Fails if its type has no such field.
  robotlink::Result<void> takeEarlier(const robotlink::StreamMessage& message);
  robotlink::Result<void> take(const robotlink::StreamMessage& message);
  /// Reports what is true at the end.
  void finish();

  std::uint64_t hits() const { return hits_; }
  /// Returns a sentence per value that no message had. An expression without a value is never true, which may
  /// surprise a user who misspelled an element's name.
  std::vector<std::string> neverFound() const;

 private:
  /// The expression for one robot, and since when it is true.
  struct Search {
    robotlink::BoundExpression expression;
    std::optional<robotlink::Instant> trueSince = {};
    /// Whether it has values that were not looked at.
    bool isChanged = false;
  };
  robotlink::Result<void> lookAtChanged();
  robotlink::Result<void> report(const SearchHit& hit);

  const Found found_;
  std::vector<Search> searches_;
  std::set<std::string> streams_;
  /// The time of the messages that were taken last.
  robotlink::Instant time_{};
  std::uint64_t hits_ = 0;
};

}  // namespace logplayer
