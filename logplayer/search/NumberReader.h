// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "logplayer/search/MessageSource.h"
#include "robotlink/base/Worker.h"
#include "robotlink/expressions/BoundExpression.h"
#include "robotlink/expressions/FieldPath.h"
#include "robotlink/series/Series.h"

namespace logplayer {

/// A number in the messages of a log's stream, or what an expression makes of several.
struct LogNumber {
  /// The path in the log; empty: the field is an expression, with streams as in the log.
  std::string stream;
  /// A path as robotlink::FieldPath parses it.
  std::string field;
  auto operator<=>(const LogNumber&) const = default;
};

/// Reads numbers of a whole log in a thread, without playing it, or of what the history of live robots has on
/// disk. All of them share one pass over it;
/// one that is wanted later is read up to where the pass is, and with the others from there. An expression
/// has a point at each instant at which one of its streams has a message; of the others their last values
/// before count. Texts become numbers, see robotlink::FieldValue::asNumber(). Points wait until they are
/// taken; if too many wait, the thread does. The public functions are called by one thread and do not block;
/// the destructor waits for at most one read.
class NumberReader {
 public:
  using Points = std::vector<robotlink::Series::Point>;
  using Texts = std::map<double, std::string>;
  static constexpr std::size_t kMaxTexts = 1000;
  /// The points that were read since the last call.
  struct News {
    /// In order of time; times are the log's own, in s.
    std::map<LogNumber, Points> points = {};
    /// The texts of values that have some, by their numbers, each once and kMaxTexts at most.
    std::map<LogNumber, Texts> texts = {};
    /// The numbers all of whose points have been taken now.
    std::vector<LogNumber> complete = {};
    /// Why some have no points.
    std::map<LogNumber, robotlink::Error> problems = {};
    /// The share of the log, 0 to 1, that was read of all.
    double progress = 1;
    /// Why the log cannot be read.
    std::optional<robotlink::Error> failure = {};
  };
  static constexpr std::size_t kMaxWaiting = 500'000;
  /// The number of instants whose points are made available at a time.
  static constexpr std::size_t kInstants = 2000;

  /// The thread reads on as long as not more than `maxWaiting` points wait.
  explicit NumberReader(std::filesystem::path file, std::size_t maxWaiting = kMaxWaiting);
  explicit NumberReader(std::unique_ptr<MessageSource> source, std::size_t maxWaiting = kMaxWaiting);
  ~NumberReader();
  NumberReader(const NumberReader&) = delete;
  NumberReader& operator=(const NumberReader&) = delete;

  /// Sets the numbers to read. Those set before continue where they are; new ones begin at the log's begin.
  void read(const std::set<LogNumber>& numbers);
  News take();

 private:
  struct Reading {
    /// Distinguishes this reading from an earlier one with the same index.
    std::uint64_t id = 0;
    /// Empty if the field is no path.
    std::optional<robotlink::FieldPath> path = {};
    /// The time before which everything was read.
    robotlink::Instant reached = robotlink::Instant::min();
    bool isComplete = false;
    Points waiting = {};
    /// The texts that are new since the last report.
    Texts texts = {};
    std::optional<robotlink::Error> problem = {};
  };
  /// The state of a reading that the thread keeps from one pass to the next.
  struct Memory {
    /// Null: the number is no expression, or cannot be bound to the log.
    std::unique_ptr<robotlink::BoundExpression> expression;
    Texts texts = {};
  };
  class PassRun;
  /// The readings that continue together, up to where another one is.
  struct Pass {
    std::map<LogNumber, Reading> readings = {};
    robotlink::Instant from, until = robotlink::Instant::max();
  };

  void work(const std::stop_token& stop);
  bool open(const std::stop_token& stop);
  /// The readings that are behind all others; empty: all are complete.
  Pass nextPass();
  void run(Pass& pass, const std::stop_token& stop);
  /// The state of a reading, whose expression is bound at its first pass.
  Memory& memoryOf(const LogNumber& number, Reading& reading);
  /// Makes points available, blocking as long as too many wait, and notes how far the readings are. False: to
  /// be ended.
  bool publish(Pass& pass, robotlink::Instant reached, const std::stop_token& stop);

  /// Only the thread uses it.
  const std::unique_ptr<MessageSource> source_;
  const std::size_t maxWaiting_;
  /// Only the thread uses it.
  bool isOpen_ = false;
  /// Only the thread uses it. The keys are the ids of the readings.
  std::map<std::uint64_t, Memory> memories_;
  /// Protects all following members but the worker.
  mutable std::mutex mutex_;
  /// Signaled when points were taken.
  std::condition_variable_any taken_;
  std::map<LogNumber, Reading> readings_;
  std::size_t waiting_ = 0;
  std::uint64_t lastId_ = 0;
  robotlink::Instant begin_, end_;
  std::optional<robotlink::Error> failure_;
  robotlink::Worker<std::monostate> worker_;
};

}  // namespace logplayer
