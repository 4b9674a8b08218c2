// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/core/platform/Pace.h"

namespace app {

/// The state of playing logs: whether and how fast they are played, how gaps are treated, and what follows at
/// the end. It decides what is to be done next from the place where the logs are, which is passed to it, as
/// is the real time. A plain value.
class Playback {
 public:
  using RealTime = Pace::RealTime;
  /// A longer time without any message is a gap.
  static constexpr robotlink::Duration kGap = std::chrono::seconds(1);
  /// The least real time from one loop to the next, however short the range is.
  static constexpr std::chrono::milliseconds kShortestLoop{100};

  /// The position in the logs, in times of their common timeline.
  struct Place {
    robotlink::Instant now, begin, end;
    /// The time of the next step; unset at the end.
    std::optional<robotlink::Instant> next;
  };
  /// A selected part of the timeline, both ends included.
  struct Range {
    robotlink::Instant from, to;
  };
  /// The next action of the playback, and its time.
  struct Next {
    /// A step to the next instant, a jump back to the start of a loop, or a pause at the end.
    enum class What { kStep, kJump, kPause };
    What what = What::kPause;
    /// The earliest time of the next step.
    RealTime due;
    /// The aim of a jump.
    robotlink::Instant to{};
  };

  bool playing() const { return playing_; }
  double speed() const { return pace_.speed(); }
  bool loop() const { return loop_; }
  bool skipsGaps() const { return skipsGaps_; }
  const std::optional<Range>& range() const { return range_; }

  /// Starts to play from a place.
  void play(RealTime real, const Place& place);
  /// Pauses; the place stays.
  void pause() { playing_ = false; }
  /// Changes the speed from now on; what has passed since the last step has passed at the old speed.
  void setSpeed(double speed, RealTime real, const Place& place);
  /// Whether the range, or everything, is repeated instead of pausing at the end.
  void setLoop(bool on) { loop_ = on; }
  /// Whether gaps are skipped instead of waiting as long.
  void setSkipsGaps(bool on) { skipsGaps_ = on; }
  /// Selects the range that is played in a loop; nothing: everything.
  void setRange(std::optional<Range> range) { range_ = range; }

  /// Returns the next action; nothing while the playback is paused.
  std::optional<Next> next(const Place& place) const;
  /// Call this before a step is made.
  void stepping(RealTime real, const Place& place);
  /// Call this after each jump, also those that the user requests.
  void jumped(RealTime real, const Place& place);
  /// The instant that is reached between two steps; during a pause or a skipped gap, that of the last step.
  robotlink::Instant reached(RealTime real, const Place& place) const;

 private:
  /// The jump to the start of the loop; nothing if its end is not reached.
  std::optional<Next> loopBack(const Place& place) const;
  /// Whether the next step skips a gap.
  bool skips(const Place& place) const { return skipsGaps_ && place.next && *place.next - place.now > kGap; }

  bool playing_ = false;
  bool loop_ = false;
  bool skipsGaps_ = false;
  std::optional<Range> range_;
  /// Relates the timeline to real time while it plays.
  Pace pace_;
  /// For kShortestLoop.
  RealTime lastJump_;
};

}  // namespace app
