// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/RecordedStreams.h"

#include <algorithm>

#include "robotlink/base/TextParts.h"
#include "robotlink/debugging/Streams.h"

namespace logplayer {

namespace streams = robotlink::streams;

namespace {

constexpr std::size_t kMaxKnown = 10'000;

/// Whether a path is "<robot>/<name>", whatever the robot.
bool isOfARobot(std::string_view path, std::string_view name) {
  const auto slash = path.find('/');
  return slash != std::string_view::npos && path.substr(slash + 1) == name;
}

}  // namespace

robotlink::Result<robotcontrol::StreamSelection> readSelection(std::string_view text) {
  robotcontrol::StreamSelection selection;
  if (robotlink::trimmed(text).empty()) return selection;
  while (true) {
    const auto comma = text.find(',');
    const std::string_view part = robotlink::trimmed(text.substr(0, comma));
    const bool excluded = part.starts_with('-');
    const std::string pattern(excluded ? robotlink::trimmed(part.substr(1)) : part);
    if (pattern.empty() || pattern.find_first_of(" \t") != std::string::npos) {
      return robotlink::failure(
          "selection.pattern",
          "'" + std::string(part) + "' is not a stream path; write it like red1/*,-*/transforms", {},
          {std::string(part)});
    }
    *(excluded ? selection.add_exclude() : selection.add_include()) = pattern;
    if (comma == std::string_view::npos) return selection;
    text.remove_prefix(comma + 1);
  }
}

std::string textOf(const robotcontrol::StreamSelection& selection) {
  std::string text;
  for (const std::string& pattern : selection.include()) text += (text.empty() ? "" : ",") + pattern;
  for (const std::string& pattern : selection.exclude()) text += (text.empty() ? "-" : ",-") + pattern;
  return text;
}

RecordedStreams::RecordedStreams(robotcontrol::StreamSelection selection)
    : selection_(std::move(selection)),
      choice_{{selection_.include().begin(), selection_.include().end()},
              {selection_.exclude().begin(), selection_.exclude().end()}} {}

bool RecordedStreams::contains(const std::string& path) const {
  if (const auto found = known_.find(path); found != known_.end()) return found->second;
  if (known_.size() >= kMaxKnown) known_.clear();
  return known_[path] = decide(path);
}

bool RecordedStreams::excludes(std::string_view path) const {
  if (path == streams::kRecording || path == streams::kReplay) return true;
  return std::any_of(choice_.exclude.begin(), choice_.exclude.end(),
                     [&](const std::string& pattern) { return fits(path, pattern); });
}

bool RecordedStreams::decide(std::string_view path) const {
  if (excludes(path)) return false;
  if (path == streams::kBookmarks || isOfARobot(path, streams::kProgram) ||
      isOfARobot(path, streams::kRequests))
    return true;
  if (!choice_.include.empty()) return choice_.has(path);
  return !fits(path, "*/images/*") && !fits(path, "*/logged/*");
}

}  // namespace logplayer
