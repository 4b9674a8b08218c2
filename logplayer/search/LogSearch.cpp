// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/LogSearch.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "logplayer/base/Plural.h"
#include "logplayer/export/ExportPass.h"
#include "robotlink/expressions/BoundExpression.h"

namespace logplayer {
namespace {

using robotlink::BoundExpression;
using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamMessage;

/// Ends a computation because the range ends there.
constexpr char kRangeEnd[] = "search.range-end";
/// The longest delay from the time of a computed message to its publication, in time of the log.
constexpr robotlink::Duration kMaxDelay = std::chrono::seconds(1);

class LogSearch {
 public:
  LogSearch(std::shared_ptr<LogFile> log, const std::function<bool(const SearchHit&)>& found)
      : log_(std::move(log)), matcher_(found) {}

  Result<SearchReport> run(std::string_view expression, const ExportOptions& options,
                           const ComputedStreams& computed) {
    if (const auto done = bind(expression, computed.make); !done) return tl::unexpected(done.error());
    const auto unread = computation_ ? searchComputed(options, computed) : searchLogged(options);
    if (!unread && unread.error().id != ConditionMatcher::kEnough) return tl::unexpected(unread.error());
    if (unread) matcher_.finish();
    ExportReport losses;
    losses.losses = std::move(troubles_);
    if (unread) noteUnread(*unread, losses);
    noteDamage(*log_, losses);
    if (unread) {
      for (std::string& missing : matcher_.neverFound()) losses.losses.push_back(std::move(missing));
    }
    for (const auto& [stream, count] : undecoded_) {
      losses.losses.push_back(plural(count, "message") + " of " + stream +
                              " are in an unsupported encoding; left out");
    }
    report_.losses = std::move(losses.losses);
    report_.hits = matcher_.hits();
    return report_;
  }

 private:
  /// Binds the expression to streams of the log or, if it lacks some, also to those that can be computed.
  Result<void> bind(std::string_view expression, const MakeComputation& make) {
    std::vector<std::string> paths;
    for (const LogFile::Stream& stream : log_->streams()) paths.push_back(stream.path);
    auto bound = BoundExpression::bind(expression, paths, log_->robots());
    const bool lacksStreams =
        !bound && (bound.error().id == "expression.stream" || bound.error().id == "expression.robot");
    std::vector<std::string> computable;
    if (lacksStreams && make) {
      auto made = make(log_);
      if (!made) {
        robotlink::Error error = bound.error();
        error.text += "; nor can it be computed: " + made.error().text;
        return tl::unexpected(std::move(error));
      }
      computation_ = std::move(*made);
      computable = computation_->streams();
      paths.insert(paths.end(), computable.begin(), computable.end());
      bound = BoundExpression::bind(expression, paths, log_->robots());
    }
    if (!bound) return tl::unexpected(bound.error());
    matcher_.add(*std::move(bound));
    for (const std::string& path : computable) {
      if (streams().contains(path)) report_.computed.insert(path);
    }
    if (streams().empty())
      return robotlink::failure("expression.constant", "the expression names no stream of the log");
    return {};
  }

  Result<Unread> searchLogged(const ExportOptions& options) {
    if (const auto done = beginWithEarlierValues(options); !done) return tl::unexpected(done.error());
    return forEachMessage(log_, {streams().begin(), streams().end()}, options, {},
                          [this](const StreamMessage& message) { return take(message); });
  }

  /// Has the other streams computed, together with those of the log.
  Result<Unread> searchComputed(const ExportOptions& options, const ComputedStreams& computed) {
    std::vector<std::string> logged;
    std::ranges::set_difference(streams(), report_.computed, std::back_inserter(logged));
    // A cursor without streams would go through all.
    if (!logged.empty()) cursor_.emplace(log_, logged);
    if (options.from) matcher_.beginAt(*options.from);
    if (computed.begins) computed.begins(report_.computed);
    const double length = robotlink::seconds(options.to.value_or(log_->end()) - log_->begin());
    auto troubles = computation_->run(
        report_.computed, [&](Instant reached, std::vector<StreamMessage> messages) -> Result<void> {
          if (const auto done = takeWaiting(reached, std::move(messages), options); !done) return done;
          const double share = length > 0 ? robotlink::seconds(reached - log_->begin()) / length : 1;
          if (!options.progress || options.progress(std::clamp(share, 0.0, 1.0))) return {};
          return robotlink::failure("log.given-up", "canceled");
        });
    if (troubles) troubles_ = std::move(*troubles);
    const auto done =
        troubles ? takeWaiting(Instant::max(), {}, options) : Result<void>(tl::unexpected(troubles.error()));
    if (!done && done.error().id != kRangeEnd) return tl::unexpected(done.error());
    return cursor_ ? cursor_->unread() : Unread();
  }

  /// Adds what was computed up to an instant, and the log's messages up to there; takes the messages that no
  /// earlier one can follow any longer.
  Result<void> takeWaiting(Instant reached, std::vector<StreamMessage> messages,
                           const ExportOptions& options) {
    const auto wait = [this](StreamMessage message) {
      const Instant time = message.time;
      waiting_.emplace(time, std::move(message));
    };
    while (cursor_) {
      const auto next = cursor_->nextTime();
      if (!next || *next > reached) break;
      if (auto message = cursor_->next()) wait(std::move(*message));
    }
    for (StreamMessage& message : messages) wait(std::move(message));
    while (!waiting_.empty() &&
           (reached == Instant::max() || waiting_.begin()->first < reached - kMaxDelay)) {
      const StreamMessage message = std::move(waiting_.extract(waiting_.begin()).mapped());
      if (options.to && *options.to < message.time) return robotlink::failure(kRangeEnd, "");
      const bool isEarlier = options.from && message.time < *options.from;
      if (const auto done = isEarlier ? takeEarlier(message) : take(message); !done) return done;
    }
    return {};
  }

  /// Values from before the range are in effect at its start.
  Result<void> beginWithEarlierValues(const ExportOptions& options) {
    if (!options.from) return {};
    for (const std::string& stream : streams()) {
      const auto earlier = log_->latest(stream, *options.from - robotlink::Duration(1));
      if (!earlier) continue;
      if (const auto done = takeEarlier(*earlier); !done) return done;
    }
    matcher_.beginAt(*options.from);
    return {};
  }

  Result<void> takeEarlier(const StreamMessage& message) {
    return isUndecoded(*log_, message) ? Result<void>() : matcher_.takeEarlier(message);
  }

  Result<void> take(const StreamMessage& message) {
    if (!isUndecoded(*log_, message)) return matcher_.take(message);
    ++undecoded_[message.path];
    return {};
  }

  const std::set<std::string>& streams() const { return matcher_.streams(); }

  std::shared_ptr<LogFile> log_;
  ConditionMatcher matcher_;
  /// Null if the log has all streams.
  std::unique_ptr<Computation> computation_;
  /// The problems of the computation, one sentence each.
  std::vector<std::string> troubles_;
  /// Reads the streams that the log has while the others are computed; unset if there are none.
  std::optional<LogFile::Cursor> cursor_;
  /// Messages that were read or computed, by time; earlier ones may still follow.
  std::multimap<Instant, StreamMessage> waiting_;
  std::map<std::string, std::uint64_t> undecoded_;
  SearchReport report_;
};

}  // namespace

Result<SearchReport> searchLog(const std::shared_ptr<LogFile>& log, std::string_view expression,
                               const ExportOptions& options,
                               const std::function<bool(const SearchHit&)>& found,
                               const ComputedStreams& computed) {
  return LogSearch(log, found).run(expression, options, computed);
}

Result<SearchReport> searchMessages(MessageSource& source, std::string_view expression,
                                    const std::vector<std::string>& robots, const Progress& progress,
                                    const std::function<bool(const SearchHit&)>& found) {
  constexpr std::uint64_t kBetweenReports = 1000;  // messages
  if (const auto opened = source.open(progress); !opened) return tl::unexpected(opened.error());
  auto bound = BoundExpression::bind(expression, source.streams(), robots);
  if (!bound) return tl::unexpected(bound.error());
  ConditionMatcher matcher(found);
  matcher.add(*std::move(bound));
  if (matcher.streams().empty())
    return robotlink::failure("expression.constant", "the expression names no stream");
  const auto [from, to] = source.stretch();
  const double length = robotlink::seconds(to - from + robotlink::Duration(1));
  const auto cursor = source.read({matcher.streams().begin(), matcher.streams().end()}, Instant::min());
  std::uint64_t count = 0;
  while (const auto message = cursor->next()) {
    const double share = std::clamp(robotlink::seconds(message->time - from) / length, 0.0, 1.0);
    if (++count % kBetweenReports == 0 && progress && !progress(share))
      return robotlink::failure("log.given-up", "canceled");
    if (const auto done = matcher.take(*message); !done) {
      if (done.error().id == ConditionMatcher::kEnough) return SearchReport{matcher.hits(), {}, {}};
      return tl::unexpected(done.error());
    }
  }
  matcher.finish();
  return SearchReport{matcher.hits(), {}, matcher.neverFound()};
}

}  // namespace logplayer
