// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robotlink/session/StreamMessage.h"

namespace robotcontrol {
class DebugQueue;
class RequestResult;
}  // namespace robotcontrol

namespace robotlink {

/// What a debug queue says, taken apart: messages of streams, and answers to requests. They share the queue's
/// memory, unless much of it is of no more use (packages that were read into their types, what only recorders
/// want): whoever keeps a text must not keep the image with it. StreamMessage::bytes says what each takes,
/// what it shares included once.
///
/// A queue may come over a link from anywhere: messages without a path or contents are counted and left out,
/// paths are bounded, times that cannot be are replaced by those of their neighbours.
struct QueueMessages {
  std::vector<StreamMessage> messages;
  std::vector<std::shared_ptr<const robotcontrol::RequestResult>> results;
  std::uint64_t senseless = 0;
};

/// Who reads a queue: a recorder is told more than anybody asked to see.
enum class QueueReader : bool { kViews, kRecorder };

/// `lastTime`: what messages before the first valid time in the queue have.
QueueMessages messagesOf(const std::string& robot,
                         const std::shared_ptr<const robotcontrol::DebugQueue>& queue, Instant lastTime,
                         QueueReader reader = QueueReader::kViews);

/// The messages of a queue frame by frame: each ends with its FrameInfo, but for the last if that lacks one.
std::vector<std::vector<StreamMessage>> framesOf(std::vector<StreamMessage> messages);

}  // namespace robotlink
