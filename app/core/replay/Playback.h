// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/core/program/Pace.h"

namespace app {

/// How a log is played: whether, how fast, what becomes of gaps and what follows at the end. It knows no log:
/// it is told where one stands and says what is to be done next. A plain value; real time is passed in.
class Playback {
 public:
  using RealTime = Pace::RealTime;
  static constexpr double kSlowest = 0.05, kFastest = 50;  ///< times real time
  /// Longer than this without any message is a gap.
  static constexpr robotlink::Duration kGap = std::chrono::seconds(1);
  /// A loop takes at least so long, in real time, however short its range is.
  static constexpr std::chrono::milliseconds kShortestLoop{100};

  /// Where a log stands.
  struct Place {
    robotlink::Instant now, begin, end;
    std::optional<robotlink::Instant> next;  ///< of the next step; nothing at the end
  };
  struct Range {
    robotlink::Instant from, to;
  };
  struct Next {
    enum class What { kStep, kJump, kPause };
    What what = What::kPause;
    RealTime due;             ///< not before this
    robotlink::Instant to{};  ///< of a jump
  };

  bool playing() const { return playing_; }
  double speed() const { return pace_.speed(); }
  bool loop() const { return loop_; }
  bool skipsGaps() const { return skipsGaps_; }
  const std::optional<Range>& range() const { return range_; }

  void play(RealTime real, const Place& place);
  void pause() { playing_ = false; }
  void setSpeed(double speed, RealTime real, const Place& place);
  void setLoop(bool on) { loop_ = on; }
  void setSkipsGaps(bool on) { skipsGaps_ = on; }
  /// It is played only in a loop.
  void setRange(std::optional<Range> range) { range_ = range; }

  /// Nothing while it is paused.
  std::optional<Next> next(const Place& place) const;
  /// Before a step is made.
  void stepping(RealTime real, const Place& place);
  /// After a jump, wherever it came from.
  void jumped(RealTime real, const Place& place);
  /// The instant that is reached between two steps; where the log stands while it is paused.
  robotlink::Instant reached(RealTime real, const Place& place) const;

 private:
  std::optional<Next> loopBack(const Place& place) const;
  bool skips(const Place& place) const { return skipsGaps_ && place.next && *place.next - place.now > kGap; }

  bool playing_ = false;
  bool loop_ = false;
  bool skipsGaps_ = false;
  std::optional<Range> range_;
  Pace pace_;
  RealTime lastJump_;
};

}  // namespace app
