// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/LogSearch.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "foxglove/Robot.pb.h"
#include "logplayer/base/Plural.h"
#include "logplayer/export/ExportPass.h"
#include "robotlink/expressions/BoundExpression.h"

namespace logplayer {
namespace {

using robotlink::BoundExpression;
using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamMessage;

/// Ends a pass over the log because nothing more is wanted.
constexpr char kEnough[] = "search.enough";
/// Ends a computation because the range ends there.
constexpr char kRangeEnd[] = "search.range-end";
/// How much later than its time what programs compute may be published, in time of the log.
constexpr robotlink::Duration kMaxDelay = std::chrono::seconds(1);

/// The expression for one robot, and since when it is true.
struct Search {
  BoundExpression expression;
  std::optional<Instant> trueSince = {};
  /// Whether it has values that were not looked at.
  bool isChanged = false;
};

class LogSearch {
 public:
  LogSearch(std::shared_ptr<LogFile> log, const std::function<bool(const SearchHit&)>& found)
      : log_(std::move(log)), found_(found) {}

  Result<SearchReport> run(std::string_view expression, const ExportOptions& options,
                           const ComputedStreams& computed) {
    if (const auto done = bind(expression, computed.make); !done) return tl::unexpected(done.error());
    const auto unread = computation_ ? searchComputed(options, computed) : searchLogged(options);
    if (!unread && unread.error().id != kEnough) return tl::unexpected(unread.error());
    if (unread) finish();
    ExportReport losses;
    losses.losses = std::move(troubles_);
    if (unread) noteUnread(*unread, losses);
    noteDamage(*log_, losses);
    if (unread) noteNeverFound(losses);
    for (const auto& [stream, count] : undecoded_) {
      losses.losses.push_back(plural(count, "message") + " of " + stream +
                              " are in an encoding that is not read; left out");
    }
    report_.losses = std::move(losses.losses);
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
        error.text += "; it cannot be computed, either: " + made.error().text;
        return tl::unexpected(std::move(error));
      }
      computation_ = std::move(*made);
      computable = computation_->streams();
      paths.insert(paths.end(), computable.begin(), computable.end());
      bound = BoundExpression::bind(expression, paths, log_->robots());
    }
    if (!bound) return tl::unexpected(bound.error());
    for (BoundExpression& one : *bound) {
      streams_.insert(one.streams().begin(), one.streams().end());
      searches_.push_back({std::move(one)});
    }
    for (const std::string& path : computable) {
      if (streams_.contains(path)) report_.computed.insert(path);
    }
    if (streams_.empty())
      return robotlink::failure("expression.constant", "the expression names no stream of the log");
    return {};
  }

  Result<Unread> searchLogged(const ExportOptions& options) {
    if (const auto done = beginWithEarlierValues(options); !done) return tl::unexpected(done.error());
    return forEachMessage(log_, {streams_.begin(), streams_.end()}, options, {},
                          [this](const StreamMessage& message) { return take(message); });
  }

  /// Has the other streams computed, and takes those of the log beside them.
  Result<Unread> searchComputed(const ExportOptions& options, const ComputedStreams& computed) {
    std::vector<std::string> logged;
    std::ranges::set_difference(streams_, report_.computed, std::back_inserter(logged));
    // A cursor without streams would go through all.
    if (!logged.empty()) cursor_.emplace(log_, logged);
    if (options.from) time_ = *options.from;
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

  /// Adds what was computed up to an instant, and what the log has up to there; takes what nothing earlier
  /// can follow any more.
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
    for (const std::string& stream : streams_) {
      const auto earlier = log_->latest(stream, *options.from - robotlink::Duration(1));
      if (!earlier) continue;
      if (const auto done = takeEarlier(*earlier); !done) return done;
    }
    time_ = *options.from;
    return {};
  }

  /// Takes a value from before the range, but no text.
  Result<void> takeEarlier(const StreamMessage& message) {
    if (isText(message) || isUndecoded(*log_, message)) return {};
    for (Search& search : searches_) {
      const auto taken = search.expression.take(message.path, *message.value);
      if (!taken) return tl::unexpected(taken.error());
      search.isChanged |= *taken;
    }
    return {};
  }

  static bool isText(const StreamMessage& message) {
    return message.value->GetDescriptor()->full_name() == foxglove::Log::descriptor()->full_name();
  }

  Result<void> take(const StreamMessage& message) {
    if (message.time != time_) {
      if (const auto done = lookAtChanged(); !done) return done;
      time_ = message.time;
    }
    if (isUndecoded(*log_, message)) {
      ++undecoded_[message.path];
      return {};
    }
    for (Search& search : searches_) {
      const auto taken = search.expression.take(message.path, *message.value);
      if (!taken) return tl::unexpected(taken.error());
      if (!*taken) continue;
      if (!isText(message)) {
        search.isChanged = true;
        continue;
      }
      const bool isHit = isTrue(search);
      search.expression.forget(message.path);
      if (!isHit) continue;
      if (const auto done = report({search.expression.robot(), message.time, message.time, message}); !done)
        return done;
    }
    return {};
  }

  static bool isTrue(Search& search) { return search.expression.value().value_or(0) != 0; }

  Result<void> lookAtChanged() {
    for (Search& search : searches_) {
      if (!std::exchange(search.isChanged, false) || isTrue(search) == search.trueSince.has_value()) continue;
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

  void finish() {
    if (!lookAtChanged()) return;
    for (const Search& search : searches_) {
      if (!search.trueSince) continue;
      if (!report({search.expression.robot(), *search.trueSince, std::nullopt, std::nullopt})) return;
    }
  }

  /// An expression without a value is never true, which may surprise who misspelled an element's name.
  void noteNeverFound(ExportReport& losses) const {
    std::set<std::string> missing;
    for (const Search& search : searches_) {
      const auto names = search.expression.neverFound();
      missing.insert(names.begin(), names.end());
    }
    for (const std::string& name : missing)
      losses.losses.push_back("no message has " + name + ", so that the expression has no value");
  }

  Result<void> report(const SearchHit& hit) {
    ++report_.hits;
    if (found_(hit)) return {};
    return robotlink::failure(kEnough, "");
  }

  std::shared_ptr<LogFile> log_;
  const std::function<bool(const SearchHit&)>& found_;
  std::vector<Search> searches_;
  std::set<std::string> streams_;
  /// Null if the log has all streams.
  std::unique_ptr<Computation> computation_;
  /// What went wrong with it, one sentence each.
  std::vector<std::string> troubles_;
  /// Reads the streams that the log has while the others are computed; unset if there are none.
  std::optional<LogFile::Cursor> cursor_;
  /// What was read and computed, by time, and may still be followed by something earlier.
  std::multimap<Instant, StreamMessage> waiting_;
  /// The time of the messages that were taken last.
  Instant time_;
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

}  // namespace logplayer
