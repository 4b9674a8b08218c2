// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/base/Clock.h"

namespace robotlink {

struct ErrorQuantity;

/// Compares whether something happens, such as a fall, with whether it is reported, frame by frame. What
/// happens again within kPause is one event, and what is reported again after a break is another alarm. An
/// event is missed if it is not reported until kPause after its end, or for kLongest; shorter ones than
/// kShortest need not be reported. An alarm is false if nothing happens within kPause of its begin. One
/// thread at a time.
class EventErrors {
 public:
  static constexpr Duration kPause = std::chrono::seconds(1), kLongest = std::chrono::seconds(3),
                            kShortest = std::chrono::milliseconds(300);

  /// Adds a frame. Frames come in order of time; a gap of more than kPause forgets current events. Adds to
  /// `errors` whether the report is wrong and what is decided, and returns the delay of an event's first
  /// report.
  std::optional<Duration> add(Instant time, bool happens, bool isReported, ErrorQuantity& errors);

 private:
  struct Episode {
    Instant begin, last;
    /// Whether the episode has been counted.
    bool isDecided = false;
  };
  void follow(Instant time, bool happens, ErrorQuantity& errors);

  std::optional<Instant> newest_;
  std::optional<Episode> event_, alarm_;
};

}  // namespace robotlink
