// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "robotlink/session/StreamStore.h"

namespace widgets {

/// The streams of one message type below one robot (below nothing: of the whole session), whatever they are
/// called: what a view shows follows from what is said, not from where. By path.
std::vector<const robotlink::StreamStore::Stream*> streamsOfType(const robotlink::StreamStore& store,
                                                                 const std::string& robot, const char* type);

/// A robot's table of that time by its path ("tables/keys"), as a list of one; empty if there is none.
/// Processes tell their own parts of tables below these paths; the joined one is what views show.
std::vector<const robotlink::StreamMessage*> latestTable(const robotlink::StreamStore& store,
                                                         const std::string& robot, const char* path,
                                                         robotlink::Instant time);

/// The newest messages not later than `time` of those streams; null where a stream began later. Their
/// addresses change whenever their contents do, which makes it cheap to see in a tick that nothing is new.
std::vector<const robotlink::StreamMessage*> latestOfType(const robotlink::StreamStore& store,
                                                          const std::string& robot, const char* type,
                                                          robotlink::Instant time);
/// The addresses of their values, to compare with those of the last tick.
std::vector<const void*> valuesOf(const std::vector<const robotlink::StreamMessage*>& messages);

/// What follows the last '/': "cognition" of "red1/stopwatches/cognition".
std::string lastPart(const std::string& path);
/// What precedes the first '/': the robot of a stream; empty for what belongs to the world.
std::string robotPart(const std::string& path);

/// Hands out each message of a stream once; also one that came late and was put in its place among those
/// handed out before. After a reset of the clock it begins anew.
class StreamCursor {
 public:
  struct News {
    std::vector<const robotlink::StreamMessage*> messages;  ///< oldest first; valid until the store changes
    bool restarted = false;  ///< what was handed out before is no longer true: the clock went back
  };
  News take(const robotlink::StreamStore::Stream& stream);

 private:
  bool seen(const robotlink::StreamMessage& message) const;

  std::uint64_t generation_ = 0;
  std::uint64_t count_ = 0;
  robotlink::Instant newest_;
  std::deque<robotlink::PackagePtr>
      recent_;  // kept alive, so that no new message has the address of an old one
};

}  // namespace widgets
