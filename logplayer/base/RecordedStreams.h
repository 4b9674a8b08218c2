// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "logplayer/base/StreamFilter.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// Parses a selection such as "red1/*,-*/transforms": patterns separated by commas; those that begin with "-"
/// are excluded. An empty text is the default selection.
robotlink::Result<robotcontrol::StreamSelection> readSelection(std::string_view text);
/// The inverse of readSelection().
std::string textOf(const robotcontrol::StreamSelection& selection);

/// Decides which streams are recorded. Without include patterns these are all streams that a replay needs,
/// plus anything else that the robots publish on request, except for data that is large and can be
/// recomputed: debug images of solutions, and the streams "logged/..." of a replay that is being recorded.
/// The status of recording and replay is never recorded; setups of programs, requests and bookmarks always
/// are, unless a pattern excludes them.
///
/// Decisions are cached, since there are few paths and many messages. One thread at a time.
class RecordedStreams {
 public:
  RecordedStreams() = default;
  explicit RecordedStreams(robotcontrol::StreamSelection selection);

  /// Whether a stream is recorded.
  bool contains(const std::string& path) const;
  /// Whether a pattern excludes a stream, or it is never recorded.
  bool excludes(std::string_view path) const;
  const robotcontrol::StreamSelection& selection() const { return selection_; }

 private:
  /// contains() without the cache.
  bool decide(std::string_view path) const;

  robotcontrol::StreamSelection selection_;
  StreamFilter choice_;
  /// The cache of contains().
  mutable std::unordered_map<std::string, bool> known_;
};

}  // namespace logplayer
