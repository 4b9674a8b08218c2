// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/QueueMessages.h"

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/SharedDebugQueue.h"

namespace robotlink {
namespace {

constexpr std::size_t kMaxPath = 512;

bool isUsable(const SharedDebugMessage& message) {
  return message.content && !message.path.empty() && message.path.size() <= kMaxPath;
}

}  // namespace

QueueMessages messagesOf(const std::string& robot, const SharedDebugQueue& queue, Instant lastTime,
                         QueueReader reader) {
  QueueMessages result;
  result.messages.reserve(queue.messages.size());
  std::size_t frameBegin = 0;
  for (const SharedDebugMessage& message : queue.messages) {
    lastTime = message.time.value_or(lastTime);
    if (message.onlyRecorded && reader == QueueReader::kViews) continue;
    if (message.as<robotcontrol::RequestResult>() != nullptr) {
      result.results.push_back(std::static_pointer_cast<const robotcontrol::RequestResult>(message.content));
      continue;
    }
    if (!isUsable(message)) {
      ++result.senseless;
      continue;
    }
    StreamMessage& added = result.messages.emplace_back(
        StreamMessage{robot + "/" + message.path, lastTime, message.content, queue.process});
    added.bytes = sizeOf(added);
    const auto* frame = message.as<robotcontrol::FrameInfo>();
    if (frame == nullptr) continue;
    // The end of a frame: all messages since the previous one belong to it.
    for (; frameBegin < result.messages.size(); ++frameBegin) {
      result.messages[frameBegin].frame = frame->number();
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
