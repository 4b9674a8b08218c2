// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// Messages that a log contains completely or not at all: those of one frame of one process, with its
/// FrameInfo last. Immutable and shared by queue, ring and files.
struct RecordedFrame {
  std::vector<robotlink::StreamMessage> messages;
  /// Approximate memory of all messages.
  std::size_t bytes = 0;
  /// Approximate memory of the largest message.
  std::size_t largest = 0;
  /// Whether at least one message is latched.
  bool holds = false;
};
using RecordedFramePtr = std::shared_ptr<const RecordedFrame>;

/// The messages that the recording queue had to drop.
struct DroppedMessages {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
  DroppedMessages operator-(const DroppedMessages& other) const {
    return {messages - other.messages, bytes - other.bytes};
  }
};

}  // namespace logplayer
