// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace robotlink {
class Session;
}

namespace widgets {

/// A stretch of time whose values a series of a live robot lacks. Seconds on the session's timeline.
struct MissingValues {
  enum class Why : std::uint8_t {
    kUnread,   ///< The values are being read from disk.
    kTooMany,  ///< The values are on disk and were not read, or do not fit into memory.
    kLost      ///< The disk was too slow for them.
  };
  double from = 0, to = 0;
  Why why = Why::kUnread;
  bool operator==(const MissingValues&) const = default;
};

/// The parts of the history missing in a series with points from `times.first` to `times.second`, computed of
/// all these streams, in order of reasons. `unread` is the part still to be read, if any. GUI thread.
std::vector<MissingValues> missingValues(robotlink::Session& session, const std::vector<std::string>& streams,
                                         std::pair<double, double> times,
                                         const std::optional<std::pair<double, double>>& unread);

/// Joins those that overlap and have the same reason.
std::vector<MissingValues> joined(std::vector<MissingValues> missing);

}  // namespace widgets
