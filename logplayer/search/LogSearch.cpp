// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/search/LogSearch.h"

#include <algorithm>
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

  Result<SearchReport> run(std::string_view expression, const ExportOptions& options) {
    if (const auto done = bind(expression); !done) return tl::unexpected(done.error());
    if (const auto done = beginWithEarlierValues(options); !done) return tl::unexpected(done.error());
    const auto unread = forEachMessage(log_, {streams_.begin(), streams_.end()}, options, {},
                                       [this](const StreamMessage& message) { return take(message); });
    if (!unread && unread.error().id != kEnough) return tl::unexpected(unread.error());
    if (unread) finish();
    ExportReport losses;
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
  Result<void> bind(std::string_view expression) {
    std::vector<std::string> paths;
    for (const LogFile::Stream& stream : log_->streams()) paths.push_back(stream.path);
    auto bound = BoundExpression::bind(expression, paths, log_->robots());
    if (!bound) return tl::unexpected(bound.error());
    for (BoundExpression& one : *bound) {
      streams_.insert(one.streams().begin(), one.streams().end());
      searches_.push_back({std::move(one)});
    }
    if (streams_.empty())
      return robotlink::failure("expression.constant", "the expression names no stream of the log");
    return {};
  }

  /// Values from before the range are in effect at its start; earlier texts are not.
  Result<void> beginWithEarlierValues(const ExportOptions& options) {
    if (!options.from) return {};
    for (const std::string& stream : streams_) {
      const auto earlier = log_->latest(stream, *options.from - robotlink::Duration(1));
      if (!earlier || isText(*earlier) || isUndecoded(*log_, *earlier)) continue;
      for (Search& search : searches_) {
        const auto taken = search.expression.take(stream, *earlier->value);
        if (!taken) return tl::unexpected(taken.error());
        search.isChanged |= *taken;
      }
    }
    time_ = *options.from;
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
  /// The time of the messages that were taken last.
  Instant time_;
  std::map<std::string, std::uint64_t> undecoded_;
  SearchReport report_;
};

}  // namespace

Result<SearchReport> searchLog(const std::shared_ptr<LogFile>& log, std::string_view expression,
                               const ExportOptions& options,
                               const std::function<bool(const SearchHit&)>& found) {
  return LogSearch(log, found).run(expression, options);
}

}  // namespace logplayer
