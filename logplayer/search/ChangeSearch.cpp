// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/ChangeSearch.h"

#include <algorithm>
#include <set>

#include "logplayer/export/ExportPass.h"
#include "robotlink/expressions/BoundExpression.h"

namespace logplayer {
namespace {

using robotlink::BoundExpression;
using robotlink::Duration;
using robotlink::FieldValue;
using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamMessage;

using Found = std::optional<Instant>;

/// A backward search reads the log forward in parts: the first is this long, and each other one is twice as
/// long as the one behind it.
constexpr Duration kFirstPart = std::chrono::seconds(1);
constexpr std::size_t kAskEvery = 1000;  // messages

class ChangeSearch {
 public:
  ChangeSearch(const std::shared_ptr<LogFile>& log, BoundExpression expression, std::optional<double> limit,
               const Progress& progress)
      : log_(log),
        expression_(std::move(expression)),
        limit_(limit),
        progress_(progress),
        streams_(expression_.streams().begin(), expression_.streams().end()) {}

  Result<Found> forward(Instant from) { return changeIn(from + Duration(1), Instant::max(), true); }

  Result<Found> backward(Instant from) {
    Instant earliest = Instant::max();
    for (const LogFile::Stream& stream : log_->streams()) {
      if (streams_.contains(stream.path) && stream.count > 0) earliest = std::min(earliest, stream.first);
    }
    Instant end = from;
    for (Duration length = kFirstPart; end > earliest; length *= 2) {
      const Instant begin = end - std::min(length, end - earliest);
      auto found = changeIn(begin, end, false);
      if (!found || *found) return found;
      end = begin;
    }
    return Found();
  }

 private:
  /// The first or the last change in [begin, end).
  Result<Found> changeIn(Instant begin, Instant end, bool isFirst) {
    if (auto known = beginAt(begin); !known) return tl::unexpected(known.error());
    LogFile::Cursor cursor(log_, {streams_.begin(), streams_.end()});
    cursor.seek(begin);
    Found found;
    auto state = expression_.state(limit_);
    for (auto next = cursor.nextTime(); next && *next < end;) {
      const Instant time = *next;
      for (; next && *next == time; next = cursor.nextTime()) {
        if (++count_ % kAskEvery == 0 && progress_ && !progress_(0))
          return robotlink::failure("log.given-up", "the search was canceled");
        const auto message = cursor.next();
        if (!message) break;
        if (auto taken = take(*message); !taken) return tl::unexpected(taken.error());
      }
      auto now = expression_.state(limit_);
      if (now == state) continue;
      state = std::move(now);
      found = time;
      if (isFirst) break;
    }
    return found;
  }

  /// Takes the values of all streams just before an instant.
  Result<void> beginAt(Instant begin) {
    for (const std::string& stream : streams_) {
      const auto before = log_->latest(stream, begin - Duration(1));
      if (!before) {
        expression_.forget(stream);
      } else if (auto taken = take(*before); !taken) {
        return taken;
      }
    }
    return {};
  }

  Result<void> take(const StreamMessage& message) {
    if (isUndecoded(*log_, message)) return {};
    auto taken = expression_.take(message.path, *message.value);
    return taken ? Result<void>() : tl::unexpected(taken.error());
  }

  const std::shared_ptr<LogFile>& log_;
  BoundExpression expression_;
  const std::optional<double> limit_;
  const Progress& progress_;
  const std::set<std::string> streams_;
  std::size_t count_ = 0;
};

}  // namespace

Result<Found> findChange(const std::shared_ptr<LogFile>& log, const ChangeQuery& query,
                         const Progress& progress) {
  std::vector<std::string> paths;
  for (const LogFile::Stream& stream : log->streams()) paths.push_back(stream.path);
  auto bound = BoundExpression::bind(query.expression, paths, {query.robot});
  if (!bound) return tl::unexpected(bound.error());
  if (bound->front().streams().empty())
    return robotlink::failure("expression.constant", "the expression names no stream of the log");
  ChangeSearch search(log, std::move(bound->front()), query.limit, progress);
  return query.isForward ? search.forward(query.from) : search.backward(query.from);
}

}  // namespace logplayer
