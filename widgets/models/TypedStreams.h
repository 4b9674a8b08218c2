// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "robotlink/session/StreamStore.h"

namespace widgets {

/// The streams of one message type below one robot (below nothing: of the whole session), whatever they are called: what a view
/// shows follows from what is said, not from where. By path.
std::vector<const robotlink::StreamStore::Stream*> streamsOfType(const robotlink::StreamStore& store,
                                                                 const std::string& robot, const char* type);

/// The newest messages not later than `time` of those streams; null where a stream began later. Their addresses change
/// whenever their contents do, which makes it cheap to see in a tick that nothing is new.
std::vector<const robotlink::StreamMessage*> latestOfType(const robotlink::StreamStore& store,
                                                          const std::string& robot, const char* type,
                                                          robotlink::Instant time);
/// The addresses of their values, to compare with those of the last tick.
std::vector<const void*> valuesOf(const std::vector<const robotlink::StreamMessage*>& messages);

/// What follows the last '/': "cognition" of "red1/stopwatches/cognition".
std::string lastPart(const std::string& path);
/// What precedes the first '/': the robot of a stream; empty for what belongs to the world.
std::string robotPart(const std::string& path);

/// Hands out each message of a stream once, in order; after a reset of the clock it begins anew. Keeps no message but the last.
class StreamCursor {
 public:
  /// The new ones are [first, last) of stream.messages.
  struct Range {
    std::size_t first = 0;
    std::size_t last = 0;
    bool restarted = false;  ///< what was handed out before is no longer true: the clock went back
  };
  Range take(const robotlink::StreamStore::Stream& stream);

 private:
  std::uint64_t count_ = 0;
  robotlink::StreamMessage last_;
};

}  // namespace widgets
