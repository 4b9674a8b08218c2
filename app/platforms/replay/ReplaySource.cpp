// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplaySource.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "foxglove/Image.pb.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/session/LatchedMessages.h"

namespace app {

using robotlink::Instant;
using robotlink::StreamMessage;

namespace {

/// The size of the cache of decoded images.
constexpr std::size_t kMaxImageBytes = 64U << 20U;
/// The trails after a jump: how far they reach back, how much of the file may be read for them, and the time
/// between two places.
constexpr robotlink::Duration kMaxTrail = std::chrono::seconds(60);
constexpr double kMaxTrailBytes = 24e6;
constexpr robotlink::Duration kTrailStep = std::chrono::milliseconds(100);

}  // namespace

bool hasHistory(const std::string& path, const std::string& type) {
  constexpr std::array<std::string_view, 4> kPictures{"foxglove.RawImage", "foxglove.CompressedImage",
                                                      "foxglove.ImageAnnotations", "foxglove.SceneUpdate"};
  return std::ranges::find(kPictures, type) == kPictures.end() && !robotlink::isLatched(path, type);
}

bool hasPlaces(const std::string& type) {
  constexpr std::array<std::string_view, 3> kPlaces{"foxglove.FrameTransforms", "robotcontrol.RobotPose",
                                                    "robotcontrol.BallModel"};
  return std::ranges::find(kPlaces, type) != kPlaces.end();
}

ReplaySource::ReplaySource(std::shared_ptr<logplayer::LogFile> file)
    : file_(std::move(file)), cursor_(file_, {}) {}

void ReplaySource::seek(Instant time, const std::vector<std::string>& streams) {
  if (streams != cursorStreams_) {
    cursor_ = logplayer::LogFile::Cursor(file_, streams);
    cursorStreams_ = streams;
  }
  cursor_.seek(time);
  ahead_.reset();
}

std::optional<Instant> ReplaySource::nextTime() {
  if (!ahead_) ahead_ = cursor_.next();
  return ahead_ ? std::optional(ahead_->time) : std::nullopt;
}

std::vector<StreamMessage> ReplaySource::next() {
  std::vector<StreamMessage> messages;
  const auto time = nextTime();
  while (time && nextTime() == time) {
    messages.push_back(decoded(std::move(*ahead_)));
    ahead_.reset();
  }
  return messages;
}

std::vector<StreamMessage> ReplaySource::past(Instant from, Instant to) {
  std::vector<StreamMessage> messages;
  std::vector<std::string> withHistory;
  for (const auto& stream : file_->streams()) {
    if (stream.first > to) continue;
    if (hasHistory(stream.path, stream.type)) {
      if (stream.last >= from) withHistory.push_back(stream.path);
      if (file_->timeAfter(stream.path, from - robotlink::Duration(1)).value_or(Instant::max()) <= to)
        continue;
    }
    if (auto message = latest(stream.path, to)) messages.push_back(std::move(*message));
  }
  if (withHistory.empty()) return messages;
  addTrails(messages, from, to);
  logplayer::LogFile::Cursor cursor(file_, withHistory);
  cursor.seek(from);
  while (cursor.nextTime() && *cursor.nextTime() <= to) {
    if (auto message = cursor.next(); message && message->time <= to) messages.push_back(std::move(*message));
  }
  return messages;
}

Instant ReplaySource::trailsFrom(Instant to) const {
  std::error_code error;
  const auto bytes = static_cast<double>(std::filesystem::file_size(file_->path(), error));
  const double perSecond = bytes / std::max(1.0, robotlink::seconds(file_->end() - file_->begin()));
  if (error) return to;
  const auto reach =
      std::min(kMaxTrail, robotlink::fromSeconds(std::min(1e6, kMaxTrailBytes / std::max(1.0, perSecond))));
  return std::max(file_->begin(), to - reach);
}

void ReplaySource::addTrails(std::vector<StreamMessage>& messages, Instant from, Instant to) {
  const Instant begin = trailsFrom(to);
  std::vector<std::string> streams;
  for (const auto& stream : file_->streams()) {
    if (hasPlaces(stream.type) && stream.first < from && stream.last >= begin) streams.push_back(stream.path);
  }
  if (streams.empty() || begin >= from) return;
  std::map<std::string, Instant> due;
  logplayer::LogFile::Cursor cursor(file_, streams);
  cursor.seek(begin);
  while (cursor.nextTime() && *cursor.nextTime() < from) {
    auto message = cursor.next();
    if (!message || message->time >= from || message->time < due[message->path]) continue;
    due[message->path] = message->time + kTrailStep;
    messages.push_back(std::move(*message));
  }
}

std::optional<StreamMessage> ReplaySource::latest(const std::string& stream, Instant time) {
  auto message = file_->latest(stream, time);
  return message ? std::optional(decoded(std::move(*message))) : std::nullopt;
}

const std::vector<Instant>& ReplaySource::times(const std::string& stream) {
  const auto [known, isNew] = times_.try_emplace(stream);
  if (isNew) known->second = file_->times(stream);
  return known->second;
}

StreamMessage ReplaySource::decoded(StreamMessage message) {
  const auto* compressed = dynamic_cast<const foxglove::CompressedImage*>(message.value.get());
  if (compressed == nullptr) return message;
  const ImageKey key{message.path, message.time};
  if (const auto known = images_.find(key); known != images_.end()) {
    message.value = known->second.first;
    message.bytes = known->second.second;
    return message;
  }
  const auto image = logplayer::rawImage(*compressed);
  if (!image) {
    if (onBrokenImage_) onBrokenImage_(message, image.error().text);
    return message;
  }
  message.value = *image;
  message.bytes = 0;
  message.bytes = sizeOf(message);
  keep(key, message.value, message.bytes);
  return message;
}

void ReplaySource::keep(const ImageKey& key, const robotlink::PackagePtr& image, std::size_t bytes) {
  images_.emplace(key, std::pair(image, bytes));
  imagesInOrder_.push_back(key);
  imageBytes_ += bytes;
  while (imageBytes_ > kMaxImageBytes) {
    const auto oldest = images_.find(imagesInOrder_.front());
    imageBytes_ -= oldest->second.second;
    images_.erase(oldest);
    imagesInOrder_.pop_front();
  }
}

}  // namespace app
