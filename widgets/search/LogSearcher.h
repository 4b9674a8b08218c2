// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "logplayer/search/LogSearch.h"
#include "robotlink/base/Worker.h"
#include "robotlink/session/HistoryArchive.h"

namespace robotlink {
class Session;
}

namespace widgets {

/// Searches whole logs, or the history of live robots, in a thread of its own, without playing them. One
/// search at a time; a newer one replaces it. The public functions are called by one thread and do not block;
/// the destructor waits for at most one read, or one instant of a program that computes what a log lacks.
class LogSearcher {
 public:
  struct Log {
    std::filesystem::path path;
    /// The offset that is added to the times of hits.
    robotlink::Duration offset{0};
    /// The names of its robots in the session, in the log's order.
    std::vector<std::string> robots;
  };
  /// The history of live robots for the streams that are searched. A plain value.
  struct History {
    /// The pieces, in order of time within each stream.
    std::vector<robotlink::HistoryArchive::Piece> pieces;
    std::vector<std::string> robots;
    /// The streams of texts, by the names that expressions use.
    std::set<std::string> textStreams;
  };
  struct Plan {
    std::vector<Log> logs;
    /// An expression (robotlink/expressions/EXPRESSIONS.md) with streams as in the session, or what text
    /// messages contain: a regular expression (RE2), in any case of letters.
    std::string wanted;
    bool isTexts = false;
    /// The history that is searched in place of logs if it is set.
    std::optional<History> history = {};
    /// Computes the streams of conditions that a log lacks, in the thread of the search; may be empty.
    logplayer::MakeComputation computation = {};
  };
  struct Hit {
    /// The index of the log; 0 for a history.
    std::size_t log = 0;
    std::string robot;
    /// The start of the hit, on the timeline. Equal for texts; unset `until`: to the end of the log.
    robotlink::Instant from;
    std::optional<robotlink::Instant> until;
    /// The text, if it is one, and its level, as in foxglove.Log.
    std::string text;
    int level = 0;
  };
  /// The results since the last call.
  struct News {
    std::vector<Hit> hits = {};
    /// The share of all logs that was searched, 0 to 1.
    double progress = 0;
    /// The streams that are computed since a log lacks them, with the names of its robots in the session.
    std::set<std::string> computed = {};
    /// The parts that could not be searched, and the reason if nothing could; with isDone only.
    std::vector<std::string> losses = {};
    std::optional<robotlink::Error> failure = {};
    /// Whether it ended, by itself or since there were too many hits.
    bool isDone = false;
    bool isCut = false;
  };
  static constexpr std::size_t kMaxHits = 10'000;

  LogSearcher();
  /// Returns a session's data for a search: all of its archive, and what is in memory of the streams that are
  /// wanted. Fails as the search would. In the session's thread.
  static robotlink::Result<History> historyOf(robotlink::Session& session, const std::string& wanted,
                                              bool isTexts);
  void begin(Plan plan);
  void cancel();
  News take();

 private:
  class Run;
  void work(const Plan& plan, const std::stop_token& stop);
  /// Adds to the news of a search that has not been replaced.
  template <typename Change>
  void report(const std::stop_token& stop, Change change);

  /// Protects the news.
  std::mutex mutex_;
  News news_;
  robotlink::Worker<Plan> worker_;
};

}  // namespace widgets
