// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// Messages that are in a log as a whole or not at all: what one frame of one process told, its FrameInfo
/// last. Immutable and shared by those who keep it.
struct RecordedFrame {
  std::vector<robotlink::StreamMessage> messages;
  std::size_t bytes = 0;    ///< about what they occupy
  std::size_t largest = 0;  ///< the same of the largest message
  bool holds = false;       ///< some message holds until it is told anew
};
using RecordedFramePtr = std::shared_ptr<const RecordedFrame>;

/// What did not fit.
struct DroppedMessages {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
  DroppedMessages operator-(const DroppedMessages& other) const {
    return {messages - other.messages, bytes - other.bytes};
  }
};

}  // namespace logplayer
