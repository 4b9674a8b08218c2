// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <tuple>

#include "logplayer/LogSource.h"

namespace logplayer {

/// Whether two logs are parts of one recording, the later one behind the earlier.
struct LogPart {
  LogSource& source;
  robotlink::Duration offset{0};

  robotlink::Instant begin() const { return source.reader().statistics().messageStart + offset; }
  robotlink::Instant end() const { return source.reader().statistics().messageEnd + offset; }
};

/// Why the later log cannot go on where the earlier one ends: their times overlap, or a robot runs another
/// program in them. Empty if it can. Frames of several processes may overlap a little where a log was cut.
std::string whyNotJoined(const LogPart& earlier, const LogPart& later);

/// What two parts of one log both hold where they meet: messages at the instant at which it was cut, and what
/// a cut says anew at its start because it holds there. One thread; the earlier log is read at the start
/// only.
class LogSeam {
 public:
  LogSeam(const LogPart& earlier, const LogPart& later);
  /// Whether the earlier part has a message of the later one already.
  bool isRepeated(const mcap::Channel& channel, const std::string& type, const mcap::Message& message) const;

 private:
  using Key = std::tuple<std::string, std::int64_t, std::size_t,
                         std::size_t>;  // topic, number, size and hash of the data
  static Key keyOf(const std::string& topic, std::int64_t number, mcap::Bytes data);

  robotlink::Instant begin_;  // of the later one, in its own time
  robotlink::Instant until_;  // of what may be in both, in the later one's time
  std::set<Key> both_;        // at the seam in the earlier one, by their sequence
  std::set<Key> held_;  // of what holds until it is told anew, all of the earlier one, by when it was told
};

}  // namespace logplayer
