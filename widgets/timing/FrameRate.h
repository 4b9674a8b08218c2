// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>

#include "robotlink/base/Clock.h"

namespace widgets {

/// The rate of a process: its frames per second on the platform's clock, over the last two seconds of
/// those that were added. By the frames' numbers, so that frames that were not published do not matter.
class FrameRate {
 public:
  /// Adds a frame; 0 as its number: unknown, then it is counted. If the clock or the number went back (a
  /// reset, a jump, another program), starts over.
  void add(robotlink::Instant time, std::uint64_t number);
  /// Hz; 0 if it is not known yet.
  double hertz() const;
  /// The time within which a frame has to be done: the period of a process that has one, else the mean time
  /// from one frame to the next. s; 0 if it is not known yet.
  double period(double ofProcess) const;
  /// The number of the newest frame; 0: there is none.
  std::uint64_t newest() const { return recent_.empty() ? 0 : recent_.back().number; }
  /// Whether the newest frame was at this time.
  bool isNewest(robotlink::Instant time) const { return !recent_.empty() && recent_.back().time == time; }

 private:
  struct Frame {
    robotlink::Instant time;
    std::uint64_t number;
  };
  std::deque<Frame> recent_;
};

}  // namespace widgets
