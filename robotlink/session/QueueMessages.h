// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robotlink/session/StreamMessage.h"

namespace robotcontrol {
class RequestResult;
}

namespace robotlink {

struct SharedDebugQueue;

/// The contents of a debug queue: messages of streams and results of requests. Each shares its content with
/// the queue; nothing is copied, and none keeps another one alive. StreamMessage::bytes is the memory that a
/// message holds.
///
/// A queue may come over a link from anywhere: messages without a path or contents are dropped and counted,
/// the length of paths is limited, and missing times are replaced by those of their neighbors.
struct QueueMessages {
  std::vector<StreamMessage> messages;
  std::vector<std::shared_ptr<const robotcontrol::RequestResult>> results;
  /// The number of messages that were dropped because they had no usable path or contents.
  std::uint64_t senseless = 0;
};

/// The reader of a queue: a recorder also gets messages that no view has subscribed to.
enum class QueueReader : bool { kViews, kRecorder };

/// `lastTime` is the timestamp of messages before the first valid one in the queue.
QueueMessages messagesOf(const std::string& robot, const SharedDebugQueue& queue, Instant lastTime,
                         QueueReader reader = QueueReader::kViews);

/// Splits a queue's messages into frames; each ends with its FrameInfo, except for the last if that is
/// incomplete.
std::vector<std::vector<StreamMessage>> framesOf(std::vector<StreamMessage> messages);

}  // namespace robotlink
