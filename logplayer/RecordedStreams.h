// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "logplayer/StreamChoice.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// Reads "red1/*,-*/transforms": patterns between commas, those with "-" before them are left out. Nothing:
/// the default selection.
robotlink::Result<robotcontrol::StreamSelection> readSelection(std::string_view text);
/// As readSelection() reads it.
std::string textOf(const robotcontrol::StreamSelection& selection);

/// Which streams are recorded. Without patterns to include that is everything that a replay needs and
/// whatever else a robot told because it was asked to, but for what is large and is recomputed: images that
/// solutions draw for looking at them, and what a replay that is recorded tells as "logged/...". What
/// recording and replaying say of themselves never is; set-ups of programs, requests and bookmarks always
/// are, unless they are left out by a pattern.
///
/// Answers are remembered, as there are few paths and many messages. One thread at a time.
class RecordedStreams {
 public:
  RecordedStreams() = default;
  explicit RecordedStreams(robotcontrol::StreamSelection selection);

  bool contains(const std::string& path) const;
  /// A pattern leaves it out, or it is never recorded.
  bool excludes(std::string_view path) const;
  const robotcontrol::StreamSelection& selection() const { return selection_; }

 private:
  bool decide(std::string_view path) const;

  robotcontrol::StreamSelection selection_;
  StreamChoice choice_;
  mutable std::unordered_map<std::string, bool> known_;
};

}  // namespace logplayer
