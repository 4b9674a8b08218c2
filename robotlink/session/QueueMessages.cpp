// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/QueueMessages.h"

#include <google/protobuf/message.h>

#include <limits>
#include <optional>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink {
namespace {

using google::protobuf::Message;
using robotcontrol::DebugMessage;
using robotcontrol::DebugQueue;
using QueuePtr = std::shared_ptr<const DebugQueue>;

constexpr std::size_t kMaxPath = 512;

// The time of a message; empty unless it fits into an instant, with room for the sum of two.
std::optional<Instant> timeOf(const DebugMessage& message) {
  constexpr std::int64_t kMaxSeconds = std::numeric_limits<std::int64_t>::max() / 2 / 1'000'000'000 - 10;
  if (!message.has_timestamp()) return std::nullopt;
  const auto& stamp = message.timestamp();
  if (stamp.seconds() > kMaxSeconds || stamp.seconds() < -kMaxSeconds) return std::nullopt;
  if (stamp.nanos() < 0 || stamp.nanos() >= 1'000'000'000) return std::nullopt;
  return instant(stamp);
}

// Parses a package into its type; returns the copy itself if the type is unknown or the bytes do not fit.
template <typename Part>
PackagePtr unpacked(const robotcontrol::PackageCopy& copy, const Part& part) {
  const auto* descriptor =
      google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(copy.type());
  const Message* prototype =
      descriptor ? google::protobuf::MessageFactory::generated_factory()->GetPrototype(descriptor) : nullptr;
  if (prototype) {
    const std::shared_ptr<Message> package(prototype->New());
    if (package->ParseFromString(copy.data())) return package;
  }
  return part(copy);
}

// With `shares` nothing is copied, and the queue lives as long as the result.
PackagePtr contents(const QueuePtr& queue, const DebugMessage& message, bool shares) {
  const auto part = [&](const Message& value) {
    if (shares) return PackagePtr(queue, &value);
    const std::shared_ptr<Message> copy(value.New());
    copy->CopyFrom(value);
    return PackagePtr(copy);
  };
  switch (message.content_case()) {
    case DebugMessage::kText:
      return part(message.text());
    case DebugMessage::kImageDrawing:
      return part(message.image_drawing());
    case DebugMessage::kSceneDrawing:
      return part(message.scene_drawing());
    case DebugMessage::kImage:
      return part(message.image());
    case DebugMessage::kPlot:
      return part(message.plot());
    case DebugMessage::kStopwatches:
      return part(message.stopwatches());
    case DebugMessage::kPackage:
      return unpacked(message.package(), part);
    case DebugMessage::kFrame:
      return part(message.frame());
    case DebugMessage::kKeys:
      return part(message.keys());
    case DebugMessage::kSolutions:
      return part(message.solutions());
    case DebugMessage::kParameters:
      return part(message.parameters());
    case DebugMessage::kProcesses:
      return part(message.processes());
    case DebugMessage::kResult:
    case DebugMessage::CONTENT_NOT_SET:
      break;
  }
  return nullptr;
}

// Whether a reader keeps so much of a queue that it may keep the queue as a whole.
bool isWorthKeeping(const DebugQueue& queue, QueueReader reader) {
  constexpr std::size_t kLittle = 2048;
  std::size_t bytes = 0, useless = 0;
  for (const DebugMessage& message : queue.messages()) {
    const std::size_t size = message.ByteSizeLong();
    bytes += size;
    const bool unread = message.only_recorded() && reader == QueueReader::kViews;
    if (unread || message.has_package() || message.has_result()) useless += size;
  }
  return useless <= kLittle || useless * 8 <= bytes;
}

}  // namespace

QueueMessages messagesOf(const std::string& robot, const QueuePtr& queue, Instant lastTime,
                         QueueReader reader) {
  // The overhead of a message in the queue: its object, path and timestamp.
  constexpr std::size_t kPlace = 192;
  const bool shares = isWorthKeeping(*queue, reader);
  QueueMessages result;
  result.messages.reserve(static_cast<std::size_t>(queue->messages_size()));
  std::size_t frameBegin = 0;
  for (const DebugMessage& message : queue->messages()) {
    lastTime = timeOf(message).value_or(lastTime);
    if (message.only_recorded() && reader == QueueReader::kViews) continue;
    if (message.has_result()) {
      result.results.emplace_back(queue, &message.result());
      continue;
    }
    PackagePtr value = message.path().empty() || message.path().size() > kMaxPath
                           ? nullptr
                           : contents(queue, message, shares);
    if (!value) {
      ++result.senseless;
      continue;
    }
    StreamMessage& added = result.messages.emplace_back(
        StreamMessage{robot + "/" + message.path(), lastTime, std::move(value), queue->process()});
    added.bytes = sizeOf(added) + (shares ? kPlace : 0);
    if (!message.has_frame()) continue;
    // The end of a frame: all messages since the previous one belong to it.
    for (; frameBegin < result.messages.size(); ++frameBegin) {
      result.messages[frameBegin].frame = message.frame().number();
    }
  }
  return result;
}

std::vector<std::vector<StreamMessage>> framesOf(std::vector<StreamMessage> messages) {
  std::vector<std::vector<StreamMessage>> frames;
  bool ended = true;
  for (StreamMessage& message : messages) {
    if (ended) frames.emplace_back();
    ended = dynamic_cast<const robotcontrol::FrameInfo*>(message.value.get()) != nullptr;
    frames.back().push_back(std::move(message));
  }
  return frames;
}

}  // namespace robotlink
