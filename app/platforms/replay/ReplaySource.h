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

/// Reads a log for a replay: instant by instant, with images decoded. Times are those of the log. One thread.
class ReplaySource {
 public:
  explicit ReplaySource(std::shared_ptr<logplayer::LogFile> file);

  logplayer::LogFile& file() const { return *file_; }
  const std::shared_ptr<logplayer::LogFile>& filePointer() const { return file_; }
  /// The listener is called with each image that cannot be decoded when it is read; such a message is passed
  /// on unchanged.
  void onBrokenImage(std::function<void(const robotlink::StreamMessage&, const std::string& why)> listener) {
    onBrokenImage_ = std::move(listener);
  }

  /// Continues reading at the first instant not before `time`, with these streams only (empty: all).
  void seek(robotlink::Instant time, const std::vector<std::string>& streams = {});
  /// The time of the next instant; nothing at the end.
  std::optional<robotlink::Instant> nextTime();
  /// Reads all messages of nextTime(); none at the end.
  std::vector<robotlink::StreamMessage> next();
  /// The newest message of each stream not later than `to`, and all messages since `from` of streams with a
  /// history. Of streams that say where things were, also one for each tenth of a second since trailsFrom().
  /// Does not affect next().
  std::vector<robotlink::StreamMessage> past(robotlink::Instant from, robotlink::Instant to);
  /// The newest message of a stream not later than `time`.
  std::optional<robotlink::StreamMessage> latest(const std::string& stream, robotlink::Instant time);

  /// The times of all messages of a stream, sorted; empty if there is no such stream. Cached.
  const std::vector<robotlink::Instant>& times(const std::string& stream);

 private:
  /// How far back views can show the trails of moving objects at `to`: a minute, or less where the log
  /// could not be read quickly enough.
  robotlink::Instant trailsFrom(robotlink::Instant to) const;
  /// Appends the places of what moves from there up to `from`.
  void addTrails(std::vector<robotlink::StreamMessage>& messages, robotlink::Instant from,
                 robotlink::Instant to);
  using ImageKey = std::pair<std::string, robotlink::Instant>;
  /// Replaces a compressed image by a raw one.
  robotlink::StreamMessage decoded(robotlink::StreamMessage message);
  /// Adds a decoded image to the cache, which drops the oldest ones.
  void keep(const ImageKey& key, const robotlink::PackagePtr& image, std::size_t bytes);

  std::shared_ptr<logplayer::LogFile> file_;
  std::function<void(const robotlink::StreamMessage&, const std::string&)> onBrokenImage_;
  /// Reads the streams that seek() has chosen.
  logplayer::LogFile::Cursor cursor_;
  std::vector<std::string> cursorStreams_;
  /// The first message of the next instant, if it was read already.
  std::optional<robotlink::StreamMessage> ahead_;
  /// For times(), by stream.
  std::map<std::string, std::vector<robotlink::Instant>> times_;
  // A cache of decoded images with their sizes, since users step back and forth over the same ones.
  std::map<ImageKey, std::pair<robotlink::PackagePtr, std::size_t>> images_;
  std::deque<ImageKey> imagesInOrder_;
  std::size_t imageBytes_ = 0;
};

/// Whether earlier messages of a stream matter to views after a jump: numbers and texts do; images, drawings
/// and latched messages do not. `type` is the full name of the message type.
bool hasHistory(const std::string& path, const std::string& type);
/// Whether the messages of a type say where robots or the ball are. `type` is its full name.
bool hasPlaces(const std::string& type);

}  // namespace app
