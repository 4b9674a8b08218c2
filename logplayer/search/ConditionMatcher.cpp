// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/ConditionMatcher.h"

#include <utility>

#include "foxglove/Robot.pb.h"

namespace logplayer {

using robotlink::BoundExpression;
using robotlink::Result;
using robotlink::StreamMessage;

namespace {

bool isText(const StreamMessage& message) {
  return message.value->GetDescriptor()->full_name() == foxglove::Log::descriptor()->full_name();
}

bool isTrueNow(BoundExpression& expression) {
  return expression.value().value_or(0) != 0;
}

}  // namespace

void ConditionMatcher::add(std::vector<BoundExpression> expressions) {
  for (BoundExpression& one : expressions) {
    streams_.insert(one.streams().begin(), one.streams().end());
    searches_.push_back({std::move(one)});
  }
}

Result<void> ConditionMatcher::takeEarlier(const StreamMessage& message) {
  if (isText(message)) return {};
  for (Search& search : searches_) {
    const auto taken = search.expression.take(message.path, *message.value);
    if (!taken) return tl::unexpected(taken.error());
    search.isChanged |= *taken;
  }
  return {};
}

Result<void> ConditionMatcher::take(const StreamMessage& message) {
  if (message.time != time_) {
    if (const auto done = lookAtChanged(); !done) return done;
    time_ = message.time;
  }
  for (Search& search : searches_) {
    const auto taken = search.expression.take(message.path, *message.value);
    if (!taken) return tl::unexpected(taken.error());
    if (!*taken) continue;
    if (!isText(message)) {
      search.isChanged = true;
      continue;
    }
    const bool isHit = isTrueNow(search.expression);
    search.expression.forget(message.path);
    if (!isHit) continue;
    if (const auto done = report({search.expression.robot(), message.time, message.time, message}); !done)
      return done;
  }
  return {};
}

Result<void> ConditionMatcher::lookAtChanged() {
  for (Search& search : searches_) {
    if (!std::exchange(search.isChanged, false) ||
        isTrueNow(search.expression) == search.trueSince.has_value())
      continue;
    if (!search.trueSince) {
      search.trueSince = time_;
      continue;
    }
    const SearchHit hit{search.expression.robot(), *search.trueSince, time_, std::nullopt};
    search.trueSince.reset();
    if (const auto done = report(hit); !done) return done;
  }
  return {};
}

void ConditionMatcher::finish() {
  if (!lookAtChanged()) return;
  for (const Search& search : searches_) {
    if (!search.trueSince) continue;
    if (!report({search.expression.robot(), *search.trueSince, std::nullopt, std::nullopt})) return;
  }
}

std::vector<std::string> ConditionMatcher::neverFound() const {
  std::set<std::string> missing;
  for (const Search& search : searches_) {
    const auto names = search.expression.neverFound();
    missing.insert(names.begin(), names.end());
  }
  std::vector<std::string> sentences;
  for (const std::string& name : missing)
    sentences.push_back("no message has " + name + ", so that the expression has no value");
  return sentences;
}

Result<void> ConditionMatcher::report(const SearchHit& hit) {
  ++hits_;
  if (found_(hit)) return {};
  return robotlink::failure(kEnough, "");
}

}  // namespace logplayer
