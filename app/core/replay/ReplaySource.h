// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "logplayer/file/LogFile.h"

namespace app {

/// A log as a replay reads it: instant by instant, images decoded. Times are those of the log. One thread.
class ReplaySource {
 public:
  explicit ReplaySource(std::shared_ptr<logplayer::LogFile> file);

  logplayer::LogFile& file() const { return *file_; }
  const std::shared_ptr<logplayer::LogFile>& filePointer() const { return file_; }
  /// Told of each image that cannot be decoded, when it is read; it is then handed out as it is.
  void onBrokenImage(std::function<void(const robotlink::StreamMessage&, const std::string& why)> listener) {
    onBrokenImage_ = std::move(listener);
  }

  /// The first instant that is read is the first not before `time`, of these streams (empty: all).
  void seek(robotlink::Instant time, const std::vector<std::string>& streams = {});
  /// Nothing at the end.
  std::optional<robotlink::Instant> nextTime();
  /// All that was told at nextTime().
  std::vector<robotlink::StreamMessage> next();
  /// The newest message of each stream not later than `to`, and of streams with a history all since `from`.
  std::vector<robotlink::StreamMessage> past(robotlink::Instant from, robotlink::Instant to);
  std::optional<robotlink::StreamMessage> latest(const std::string& stream, robotlink::Instant time);

  /// Of all messages of a stream, sorted; kept.
  const std::vector<robotlink::Instant>& times(const std::string& stream);

 private:
  using ImageKey = std::pair<std::string, robotlink::Instant>;
  robotlink::StreamMessage decoded(robotlink::StreamMessage message);
  void keep(const ImageKey& key, const robotlink::PackagePtr& image, std::size_t bytes);

  std::shared_ptr<logplayer::LogFile> file_;
  std::function<void(const robotlink::StreamMessage&, const std::string&)> onBrokenImage_;
  logplayer::LogFile::Cursor cursor_;
  std::vector<std::string> cursorStreams_;
  std::optional<robotlink::StreamMessage> ahead_;
  std::map<std::string, std::vector<robotlink::Instant>> times_;
  // One steps to and fro over the same images: the last ones that were decoded.
  std::map<ImageKey, std::pair<robotlink::PackagePtr, std::size_t>> images_;
  std::deque<ImageKey> imagesInOrder_;
  std::size_t imageBytes_ = 0;
};

/// Whether one looks back at what a stream told: at numbers and texts, but not at images, drawings, and what
/// holds until it is told anew. `type` is the full name of its messages' type.
bool hasHistory(const std::string& path, const std::string& type);

}  // namespace app
