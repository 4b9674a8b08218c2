// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bhuman/FrameConverter.h"

#include <algorithm>
#include <utility>

#include "logplayer/bhuman/FrameMessages.h"
#include "logplayer/bhuman/MessageKinds.h"

namespace logplayer::bhuman {

using robotlink::Instant;
using robotlink::Result;

namespace {

/// Maximum number of frames that are held back until the first known time.
constexpr std::size_t kMaxUntimed = 100;

/// Whether the times of two consecutive frames are plausible. Robots log several frames per second; a longer
/// gap is accepted if the next frame confirms it.
bool near(Instant one, Instant other) {
  constexpr robotlink::Duration kMaxGap = std::chrono::seconds(60);
  return (one > other ? one - other : other - one) <= kMaxGap;
}

std::string processName(std::uint8_t letter) {
  switch (letter) {
    case 'c':
      return "cognition";
    case 'm':
      return "motion";
    case 'd':
      return "debug";
    default:
      return "process-" + std::to_string(letter);
  }
}

}  // namespace

FrameConverter::FrameConverter(std::string robot, FrameSink sink, Trouble trouble)
    : robot_(std::move(robot)), sink_(std::move(sink)), trouble_(std::move(trouble)) {}

bool FrameConverter::Contents::empty() const {
  return process.empty() && !image && !place && !optics && !joints && !sensors && !keys && !odometry &&
         texts.empty();
}

std::optional<Instant> FrameConverter::Contents::time() const {
  if (image) return image->time;
  if (joints) return joints->time;
  if (sensors) return sensors->time;
  return std::nullopt;
}

Result<void> FrameConverter::add(const QueueMessage& message) {
  if (contents_.empty()) contents_.offset = message.offset;
  const auto understood = take(message);
  if (!understood) return tl::unexpected(understood.error());
  ++(*understood ? imported_ : notUnderstood_)[kindName(message.id)];
  return {};
}

Result<bool> FrameConverter::take(const QueueMessage& message) {
  switch (static_cast<Kind>(message.id)) {
    case Kind::kProcessBegin:
      return begin(message);
    case Kind::kProcessFinished: {
      if (contents_.process.empty()) trouble_(message.offset, "a process ended without having begun");
      auto closed = close();
      if (!closed) return tl::unexpected(std::move(closed.error()));
      return true;
    }
    case Kind::kImage:
      return takeImage(message, readImage(message.payload));
    case Kind::kJpegImage:
      return takeImage(message, readJpegImage(message.payload));
    case Kind::kJointData:
      return put(&Contents::joints, readJointData(message.payload));
    case Kind::kSensorData:
      return put(&Contents::sensors, readSensorData(message.payload));
    case Kind::kKeyStates:
      return put(&Contents::keys, readKeyStates(message.payload));
    case Kind::kOdometryData:
      return put(&Contents::odometry, readOdometryData(message.payload));
    case Kind::kCameraMatrix:
      return put(&Contents::place, readCameraMatrix(message.payload));
    case Kind::kImageCoordinateSystem:
      return put(&Contents::optics, readImageCoordinateSystem(message.payload));
    case Kind::kText:
      contents_.texts.emplace_back(message.payload.begin(), message.payload.end());
      return true;
  }
  return false;
}

Result<bool> FrameConverter::begin(const QueueMessage& message) {
  if (!contents_.process.empty())
    trouble_(message.offset, "a process began before the one before it had ended");
  if (auto closed = close(); !closed) return tl::unexpected(std::move(closed.error()));
  contents_.process = processName(message.payload.empty() ? std::uint8_t{0} : message.payload[0]);
  return true;
}

Result<bool> FrameConverter::takeImage(const QueueMessage& message, Result<CameraImage> image) {
  if (!image) {
    trouble_(message.offset, "an image was left out: " + image.error().text);
    return false;
  }
  if (!image->damage.empty()) trouble_(message.offset, "the image is damaged: " + image->damage);
  return put(&Contents::image, std::optional(*std::move(image)));
}

/// A second value of its kind in a frame belongs to a frame whose ProcessBegin is lost.
template <typename Value>
Result<bool> FrameConverter::put(std::optional<Value> Contents::*slot, std::optional<Value> value) {
  if (!value) return false;
  if (contents_.*slot) {
    const std::string process = contents_.process;
    if (auto closed = close(); !closed) return tl::unexpected(std::move(closed.error()));
    contents_.process = process;
  }
  contents_.*slot = std::move(value);
  return true;
}

Result<void> FrameConverter::close() {
  Contents contents = std::exchange(contents_, Contents());
  if (contents.empty()) return {};
  const auto stated = contents.time();
  if (!lastTime_ && !stated && untimed_.size() < kMaxUntimed) {
    untimed_.push_back(std::move(contents));
    return {};
  }
  if (!lastTime_) lastTime_ = stated.value_or(Instant{});
  if (auto converted = convertUntimed(); !converted) return converted;
  // A frame without a time cannot contradict the one before it.
  const auto next = stated || !doubtful_ ? stated : doubtful_->time();
  if (auto converted = convertDoubtful(next); !converted) return converted;
  if (stated && !near(*stated, *lastTime_)) {
    doubtful_ = std::move(contents);
    return {};
  }
  return convert(contents, stated);
}

Result<void> FrameConverter::finish() {
  if (auto closed = close(); !closed) return closed;
  if (auto converted = convertDoubtful(std::nullopt); !converted) return converted;
  if (!lastTime_) lastTime_ = Instant{};
  return convertUntimed();
}

Result<void> FrameConverter::convertUntimed() {
  for (const Contents& earlier : std::exchange(untimed_, {}))
    if (auto converted = convert(earlier, std::nullopt); !converted) return converted;
  return {};
}

Result<void> FrameConverter::convertDoubtful(std::optional<Instant> next) {
  if (!doubtful_) return {};
  const Contents contents = *std::exchange(doubtful_, std::nullopt);
  const auto stated = contents.time();
  const bool confirmed = next && near(*stated, *next);
  if (!confirmed)
    trouble_(contents.offset, "the time of a frame, " + std::to_string(robotlink::seconds(*stated)) +
                                  " s, is far from those around it; that of the frame before was used");
  return convert(contents, confirmed ? stated : std::nullopt);
}

Result<void> FrameConverter::convert(const Contents& contents, std::optional<Instant> stated) {
  const auto before = timeOfProcess_.find(contents.process);
  const Instant usual = before != timeOfProcess_.end() ? before->second : *lastTime_;
  const Instant time = stated.value_or(usual);
  lastTime_ = time;
  timeOfProcess_[contents.process] = time;
  Frame frame = messagesOf(contents, time);
  // A frame may be empty, for example if it contains fields of view only.
  return frame.empty() ? Result<void>() : sink_(std::move(frame));
}

FrameConverter::Frame FrameConverter::messagesOf(const Contents& contents, Instant time) {
  Frame frame;
  convertCamera(contents, time, frame);
  convertBody(contents, time, frame);
  convertTexts(contents, time, frame);
  if (!contents.process.empty()) {
    const std::uint64_t number = ++frames_[contents.process];
    frame.push_back(frameInfo(contents.process, number, time));
    for (robotlink::StreamMessage& message : frame) message.frame = number;
  }
  for (robotlink::StreamMessage& message : frame) {
    message.path = robot_ + "/" + message.path;
    message.time = time;
    message.process = contents.process;
  }
  return frame;
}

void FrameConverter::convertCamera(const Contents& contents, Instant time, Frame& frame) {
  if (contents.image) frame.push_back(cameraImage(contents.image->image, robot_ + "/camera", time));
  if (contents.optics) optics_ = *contents.optics;
  if (!contents.place) return;
  frame.push_back(cameraPose(*contents.place, optics_, time));
  if (contents.place->valid == placeValid_) return;
  placeValid_ = contents.place->valid;
  frame.push_back(text(placeValid_ ? "the camera's pose is reliable again"
                                   : "the robot moved too unsteadily: its camera's pose is not reliable",
                       placeValid_ ? Level::kInfo : Level::kWarning, contents.process + "/camera-pose",
                       time));
}

void FrameConverter::convertBody(const Contents& contents, Instant time, Frame& frame) {
  if (contents.joints) frame.push_back(jointStates(*contents.joints, time));
  if (contents.sensors) frame.push_back(bodySensors(*contents.sensors, time));
  if (contents.sensors || contents.keys) {
    std::vector<Reading> readings;
    if (contents.sensors) readings = contents.sensors->readings;
    if (contents.keys) readings.insert(readings.end(), contents.keys->begin(), contents.keys->end());
    frame.push_back(bodyReadings(readings, time));
  }
  if (contents.odometry) frame.push_back(motionStatus(*contents.odometry, time));
}

void FrameConverter::convertTexts(const Contents& contents, Instant time, Frame& frame) {
  const std::string name = contents.process.empty() ? "log" : contents.process;
  for (const std::string& each : contents.texts) frame.push_back(text(each, Level::kInfo, name, time));
}

}  // namespace logplayer::bhuman
