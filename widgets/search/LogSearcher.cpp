// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/search/LogSearcher.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "foxglove/Robot.pb.h"
#include "logplayer/base/RobotNames.h"
#include "robotlink/expressions/BoundExpression.h"
#include "robotlink/expressions/Expression.h"
#include "robotlink/session/Session.h"
#include "widgets/TypedStreams.h"

namespace widgets {
namespace {

using logplayer::LogFile;
using logplayer::renamedStream;
using robotlink::Instant;
using robotlink::Result;

constexpr char kTextType[] = "foxglove.Log";

/// A text in quotation marks, as expressions have it.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '\\';
    result += c;
  }
  return result + '"';
}

/// The robot of a stream; empty if it is of none.
std::string robotOf(const std::string& path, const std::vector<std::string>& robots) {
  const std::size_t slash = path.find('/');
  if (slash == std::string::npos) return {};
  std::string robot = path.substr(0, slash);
  return std::ranges::find(robots, robot) != robots.end() ? robot : std::string();
}

/// The names of some of all streams in expressions, each unambiguous: those of robots without the
/// robot, unless this is the name of another stream.
std::set<std::string> namesOf(const std::set<std::string>& some, const std::set<std::string>& all,
                              const std::vector<std::string>& robots) {
  std::set<std::string> names;
  for (const std::string& path : some) {
    const std::string robot = robotOf(path, robots);
    const std::string name = robot.empty() ? path : path.substr(robot.size() + 1);
    names.insert(all.contains(name) ? path : name);
  }
  return names;
}

std::set<std::string> textStreams(const LogFile& log) {
  std::set<std::string> texts, all;
  for (const auto& stream : log.streams()) {
    all.insert(stream.path);
    if (stream.holds(kTextType)) texts.insert(stream.path);
  }
  return namesOf(texts, all, log.robots());
}

std::string textCondition(const std::string& stream, const std::string& wanted) {
  // A backslash at the end would take the quotation mark behind it into the text.
  const std::string end = wanted.ends_with('\\') ? "(?:)" : "";
  return stream + ".message =~ " + quoted("(?i)" + wanted + end);
}

/// Adds the messages of a stream that are in memory and not on disk.
void addFromMemory(const robotlink::StreamStore::Stream& stream, LogSearcher::History& history) {
  Instant onDisk = Instant::min();
  for (const auto& piece : history.pieces) {
    const auto times = piece.times->find(stream.path);
    if (times != piece.times->end()) onDisk = std::max(onDisk, times->second.to);
  }
  const auto from = std::ranges::upper_bound(stream.messages, onDisk, {}, &robotlink::StreamMessage::time);
  if (from == stream.messages.end()) return;
  const robotlink::Stretch held{from->time, stream.messages.back().time};
  history.pieces.push_back(
      {held,
       std::make_shared<const std::map<std::string, robotlink::Stretch>>(
           std::map<std::string, robotlink::Stretch>{{stream.path, held}}),
       {},
       std::make_shared<const std::vector<robotlink::StreamMessage>>(from, stream.messages.end())});
}

/// The expressions to be searched for in a log.
Result<std::vector<std::string>> expressionsIn(const LogFile& log, const LogSearcher::Plan& plan,
                                               const std::vector<std::string>& robots) {
  std::vector<std::string> expressions;
  if (plan.isTexts) {
    for (const std::string& stream : textStreams(log))
      expressions.push_back(textCondition(stream, plan.wanted));
    if (!expressions.empty()) return expressions;
    return robotlink::failure("search.texts", "the log holds no texts");
  }
  std::vector<std::string> known;
  const auto own = log.robots();
  for (const auto& stream : log.streams()) known.push_back(renamedStream(stream.path, own, robots));
  const auto parsed = robotlink::Expression::parse(plan.wanted, known);
  if (!parsed) return tl::unexpected(parsed.error());
  return std::vector{
      parsed->withStreams([&](const std::string& stream) { return renamedStream(stream, robots, own); })};
}

}  // namespace

LogSearcher::LogSearcher()
    : worker_([this](const Plan& plan, const std::stop_token& stop) { work(plan, stop); }) {}

Result<LogSearcher::History> LogSearcher::historyOf(robotlink::Session& session, const std::string& wanted,
                                                    bool isTexts) {
  const auto& store = session.store();
  History history;
  history.robots = session.robots();
  if (const auto* archive = session.history().archive()) history.pieces = archive->pieces();
  // A misspelled name may mean any of them.
  std::set<std::string> all;
  for (const auto* stream : store.streams()) all.insert(stream->path);
  for (const auto& piece : history.pieces) {
    for (const auto& [path, times] : *piece.times) all.insert(path);
  }
  std::set<std::string> needed;
  if (isTexts) {
    for (const auto* stream : streamsOfType(store, {}, kTextType)) needed.insert(stream->path);
    if (needed.empty()) return robotlink::failure("search.texts", "there are no messages yet");
    history.textStreams = namesOf(needed, all, history.robots);
  } else {
    const auto bound = robotlink::BoundExpression::bind(wanted, {all.begin(), all.end()}, history.robots);
    if (!bound) return tl::unexpected(bound.error());
    for (const auto& one : *bound) needed.insert(one.streams().begin(), one.streams().end());
  }
  for (const auto* stream : store.streams()) {
    if (needed.contains(stream->path)) addFromMemory(*stream, history);
  }
  return history;
}

void LogSearcher::begin(Plan plan) {
  worker_.cancel();
  {
    const std::lock_guard lock(mutex_);
    news_ = {};
  }
  worker_.post(std::move(plan));
}

void LogSearcher::cancel() {
  worker_.cancel();
  const std::lock_guard lock(mutex_);
  news_.isDone = true;
}

LogSearcher::News LogSearcher::take() {
  const std::lock_guard lock(mutex_);
  News news = news_;
  news_.hits.clear();
  return news;
}

template <typename Change>
void LogSearcher::report(const std::stop_token& stop, Change change) {
  const std::lock_guard lock(mutex_);
  if (!stop.stop_requested()) change(news_);
}

/// A search through one log.
class LogSearcher::Run {
 public:
  Run(LogSearcher& searcher, const Plan& plan, const std::stop_token& stop)
      : searcher_(searcher), plan_(plan), stop_(stop) {}

  Result<void> search(std::size_t number) {
    const Log& entry = plan_.logs[number];
    LogFile::Options opening;
    opening.progress = [this](double) { return !stop_.stop_requested(); };
    const auto log = LogFile::open(entry.path, opening);
    if (!log) return tl::unexpected(log.error());
    const auto expressions = expressionsIn(**log, plan_, entry.robots);
    if (!expressions) return tl::unexpected(expressions.error());
    const auto own = (*log)->robots();
    for (std::size_t i = 0; i < expressions->size() && !isFull(); ++i) {
      const double passes = static_cast<double>(expressions->size());
      const double before = static_cast<double>(number) + static_cast<double>(i) / passes;
      const auto report = logplayer::searchLog(
          *log, (*expressions)[i],
          {.progress = [&](double share) { return progress(before + share / passes); }},
          [&](const logplayer::SearchHit& hit) {
            const std::string robot = robotOfHit(hit, own);
            addHit(number, logplayer::renamedRobot(robot, own, entry.robots), entry.offset, hit);
            return !stop_.stop_requested() && !isFull();
          },
          computedFor(entry, own));
      if (!report) return tl::unexpected(report.error());
      searcher_.report(stop_, [&](News& news) {
        news.losses.insert(news.losses.end(), report->losses.begin(), report->losses.end());
      });
    }
    return {};
  }
  Result<void> searchHistory() {
    const History& history = *plan_.history;
    std::vector<std::string> conditions;
    for (const std::string& stream : history.textStreams)
      conditions.push_back(textCondition(stream, plan_.wanted));
    if (!plan_.isTexts) conditions.push_back(plan_.wanted);
    for (std::size_t i = 0; i < conditions.size() && !isFull(); ++i) {
      const double passes = static_cast<double>(conditions.size());
      const auto report = logplayer::searchMessages(
          *logplayer::historySource(history.pieces), conditions[i], history.robots,
          [&](double share) { return progress((static_cast<double>(i) + share) / passes); },
          [&](const logplayer::SearchHit& hit) {
            addHit(0, robotOfHit(hit, history.robots), {}, hit);
            return !stop_.stop_requested() && !isFull();
          });
      if (!report) return tl::unexpected(report.error());
      searcher_.report(stop_, [&](News& news) {
        news.losses.insert(news.losses.end(), report->losses.begin(), report->losses.end());
      });
    }
    return {};
  }
  bool isFull() const { return count_ >= kMaxHits; }
  /// Reports how many logs are searched. False: the search is to end.
  bool progress(double logs) {
    const double all = plan_.history ? 1 : static_cast<double>(plan_.logs.size());
    searcher_.report(stop_, [&](News& news) { news.progress = logs / all; });
    return !stop_.stop_requested();
  }

 private:
  /// Texts have a robot also where their stream had to be named in full.
  std::string robotOfHit(const logplayer::SearchHit& hit, const std::vector<std::string>& robots) const {
    return plan_.isTexts && hit.text ? robotOf(hit.text->path, robots) : hit.robot;
  }
  /// Adds to the news what is computed for a log with these robots.
  logplayer::ComputedStreams computedFor(const Log& entry, const std::vector<std::string>& own) {
    return {plan_.computation, [this, &entry, &own](const std::set<std::string>& streams) {
              searcher_.report(stop_, [&](News& news) {
                for (const std::string& stream : streams)
                  news.computed.insert(renamedStream(stream, own, entry.robots));
              });
            }};
  }
  void addHit(std::size_t number, const std::string& robot, robotlink::Duration offset,
              const logplayer::SearchHit& found) {
    ++count_;
    Hit hit{number, robot, found.from + offset, std::nullopt, {}, 0};
    if (found.until) hit.until = *found.until + offset;
    const auto* text = found.text ? dynamic_cast<const foxglove::Log*>(found.text->value.get()) : nullptr;
    if (text != nullptr) {
      hit.text = text->message();
      hit.level = static_cast<int>(text->level());
    }
    searcher_.report(stop_, [&](News& news) { news.hits.push_back(std::move(hit)); });
  }

  LogSearcher& searcher_;
  const Plan& plan_;
  const std::stop_token& stop_;
  std::size_t count_ = 0;
};

void LogSearcher::work(const Plan& plan, const std::stop_token& stop) {
  Run run(*this, plan, stop);
  std::optional<robotlink::Error> failure;
  bool some = false;
  if (plan.history) {
    const auto done = run.searchHistory();
    some = done.has_value();
    if (!done) failure = done.error();
    // A search of few messages reports no progress on its way.
    if (!run.isFull()) run.progress(1);
  }
  for (std::size_t i = 0; i < plan.logs.size() && !stop.stop_requested() && !run.isFull(); ++i) {
    const auto done = run.search(i);
    // A log that does not have what is searched for is none of several to fail for.
    some = some || done;
    if (!done && !failure) failure = done.error();
    if (!run.isFull()) run.progress(static_cast<double>(i + 1));
  }
  report(stop, [&](News& news) {
    news.isDone = true;
    news.isCut = run.isFull();
    if (some && failure) news.losses.push_back(failure->text);
    if (!some) news.failure = failure;
  });
}

}  // namespace widgets
