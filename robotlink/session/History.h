// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/session/HistoryArchive.h"
#include "robotlink/session/StreamStore.h"
#include "robotlink/session/Timeline.h"

namespace robotlink {

/// Looking back in a session while its robots continue: decides which instant the timeline shows, and ensures
/// that its messages are in the store: they stay there, or are read from the archive first. Until they
/// are read, the timeline shows what it showed before, so that all views show one instant, completely.
///
/// In the thread that ticks the session.
class History {
 public:
  /// How much before and behind the shown instant is in the store, too, for trails and for small steps.
  static constexpr Duration kBefore = std::chrono::seconds(5);
  static constexpr Duration kBehind = std::chrono::seconds(2);

  /// Both must outlive it.
  History(StreamStore& store, Timeline& timeline) : store_(store), timeline_(timeline) {}
  ~History() { setArchive(nullptr); }
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  /// Keeps what is dropped from memory from now on; null: nowhere. What was archived before is forgotten.
  void setArchive(std::unique_ptr<HistoryArchive> archive);
  /// Null if there is none.
  HistoryArchive* archive() { return archive_.get(); }

  /// Shows the newest instant from now on, however the robots continue.
  void pause();
  /// Follows the newest instant again.
  void goLive();
  /// Pauses at an instant; the nearest one that can be shown if it was dropped or is yet to come.
  void show(Instant time);
  /// Pauses at the message of a stream that is `count` messages behind the shown instant; negative: before.
  /// At the ends of the history it stays there. Fails if there is no such stream.
  Result<void> step(const std::string& stream, int count);
  /// Pauses at the next message of these streams behind the shown instant, or before it, at whose time
  /// `isThere` is true; it is asked when the messages around that time are in the store. If there is none,
  /// the timeline shows what it showed before. Takes several ticks if many messages have to be looked at.
  void stepUntil(std::vector<std::string> streams, bool forward, std::function<bool(Instant)> isThere);
  /// Whether such a step is under way, and whether the last one found nothing.
  bool isStepping() const { return steps_.count != 0; }
  bool isMissed() const { return isMissed_; }
  /// Steps by the frames of the robot's process that has the fewest a second, which is the one that looks
  /// at images if there is one.
  Result<void> stepFrames(const std::string& robot, int count);

  /// The instant that was chosen last: the one that is shown, or the one that is being read.
  Instant chosen() const { return reading_.value_or(timeline_.shown()); }
  /// Whether the chosen instant is being read, and is not shown yet.
  bool isReading() const { return reading_.has_value(); }
  /// How far the chosen instant is behind the newest one; zero while live.
  Duration behind() const;
  /// Returns the stretches that can be shown, in order of time; between them messages were dropped.
  std::vector<Stretch> kept() const;

  /// Called by the session in each tick.
  void tick();

 private:
  struct Steps {
    std::vector<std::string> streams;
    int count = 0;
    /// The instant from which they continue.
    Instant from = {};
    /// Whether a message at an instant counts; empty: all do.
    std::function<bool(Instant)> isThere = {};
    /// The instant that was shown before.
    Instant begin = {};
    /// The instant that was read for them, which may be far from where they continue.
    std::optional<Instant> read = {};
  };
  /// Takes what was read.
  void take();
  /// Steps as far as the messages are in the store.
  void doSteps();
  struct Step {
    Instant at;
    /// Whether it is only the next place about which nothing is known yet, rather than a message.
    bool isUnknown = false;
  };
  /// Returns the target of the next step; unset: there is no further message.
  std::optional<Step> stepped(const std::string& stream, Instant from, bool forward) const;
  /// The same for the stream among some whose message is next.
  std::optional<Step> stepped(const std::vector<std::string>& streams, Instant from, bool forward) const;
  /// The latest instant not later than `time` that can be shown; `time` if there is none.
  Instant lastKept(Instant time) const;
  /// Returns the readable stretch of the archive around an instant; unset: none.
  std::optional<Stretch> archivedAt(Instant time) const;
  /// Looks at what is around the shown instant, and requests what is missing there.
  void keepAround();

  StreamStore& store_;
  Timeline& timeline_;
  std::unique_ptr<HistoryArchive> archive_;
  /// The chosen instant while it is read.
  std::optional<Instant> reading_;
  /// The instant around which more was requested.
  std::optional<Instant> requested_;
  /// The newest instant at the last tick.
  Instant newest_;
  /// The steps that remained when the chosen instant was read.
  Steps steps_;
  bool isMissed_ = false;
};

}  // namespace robotlink
