// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"

namespace robotlink {

/// A stretch of a session's time in which nothing was received from a robot, since its line was cut. A plain
/// value.
struct LineGap {
  Instant from;
  /// The end of the gap; unset while it lasts.
  std::optional<Instant> to = {};
  /// Why: a sentence.
  std::string reason = {};
  bool operator==(const LineGap&) const = default;
};

/// The messages of a stream that did not arrive, as the robot's end counts them. A plain value.
struct MissingMessages {
  /// Messages that were replaced by newer ones before they were sent, because the line was too narrow or a
  /// lower rate was chosen; and messages that were lost.
  std::uint64_t thinned = 0, lost = 0;
  bool operator==(const MissingMessages&) const = default;
};

/// The connection of a remote robot with a session. A plain value.
struct RemoteRobot {
  /// The robot's address: "ws://192.168.1.7:8765".
  std::string url;
  bool isConnected = false;
  /// For users: "connected, 12 ms, 1.3 MB/s", "silent for 3 s: ...".
  std::string state = {};
  /// In order of time.
  std::vector<LineGap> gaps = {};
  /// Keyed by the streams' paths in the session; those that arrived completely have no entry.
  std::map<std::string, MissingMessages> missing = {};
  /// Whether its server is of another program, so that it has no solutions, keys or processes as others have.
  bool isForeign = false;
  bool operator==(const RemoteRobot&) const = default;
};

/// Whether a line between two points of a curve would cross one of the gaps.
inline bool isCut(const std::vector<LineGap>& gaps, Instant from, Instant to) {
  for (const LineGap& gap : gaps) {
    // Points at the edges of a gap are the last one before and the first one after it.
    if (from <= gap.from && gap.from < to && gap.to.value_or(to) <= to) return true;
  }
  return false;
}

}  // namespace robotlink
