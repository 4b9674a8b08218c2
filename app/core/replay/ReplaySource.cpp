// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/replay/ReplaySource.h"

#include <algorithm>
#include <array>
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

}  // namespace

bool hasHistory(const std::string& path, const std::string& type) {
  constexpr std::array<std::string_view, 4> kPictures{"foxglove.RawImage", "foxglove.CompressedImage",
                                                      "foxglove.ImageAnnotations", "foxglove.SceneUpdate"};
  return std::ranges::find(kPictures, type) == kPictures.end() && !robotlink::isLatched(path, type);
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
  logplayer::LogFile::Cursor cursor(file_, withHistory);
  cursor.seek(from);
  while (cursor.nextTime() && *cursor.nextTime() <= to) {
    if (auto message = cursor.next(); message && message->time <= to) messages.push_back(std::move(*message));
  }
  return messages;
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
