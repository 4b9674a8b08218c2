// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <tuple>

#include "logplayer/edit/LogSource.h"

namespace logplayer {

/// A log that may be a part of the same recording as another one, with its offset to the common timeline.
struct LogPart {
  LogSource& source;
  /// Added to the times of the log.
  robotlink::Duration offset{0};

  /// Times of the first and the last message, on the common timeline.
  robotlink::Instant begin() const { return source.reader().statistics().messageStart + offset; }
  robotlink::Instant end() const { return source.reader().statistics().messageEnd + offset; }
};

/// Returns why the later log does not continue the earlier one: their times overlap, or a robot runs another
/// program in them. Empty if it does. Since a cut may split overlapping frames of several processes, a small
/// overlap is tolerated.
std::string whyNotJoined(const LogPart& earlier, const LogPart& later);

/// Finds messages that two parts of one log both contain: those at the instant of the cut, and latched
/// messages that a cut repeats at the start of the later part. The constructor reads the end and the latched
/// messages of the earlier log, which is not used afterward. One thread.
class LogSeam {
 public:
  LogSeam(const LogPart& earlier, const LogPart& later);
  /// Whether the earlier part already contains a message of the later one. `type` is the name of the
  /// channel's schema.
  bool isRepeated(const mcap::Channel& channel, const std::string& type, const mcap::Message& message) const;

 private:
  /// Identifies a message: topic, number, size and hash of the data.
  using Key = std::tuple<std::string, std::int64_t, std::size_t, std::size_t>;
  static Key keyOf(const std::string& topic, std::int64_t number, mcap::Bytes data);

  /// Begin of the later part, in its own time.
  robotlink::Instant begin_;
  /// End of what both parts may contain, in the time of the later one.
  robotlink::Instant until_;
  /// Messages of the earlier part at the seam; their number is the sequence.
  std::set<Key> both_;
  /// All latched messages of the earlier part; their number is the publish time.
  std::set<Key> held_;
};

}  // namespace logplayer
