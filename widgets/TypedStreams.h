// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "robotlink/session/StreamStore.h"

// Finding streams by their message types, and reading their new messages. Views choose streams by type, not
// by name, so that they work for every program.
namespace widgets {

/// The streams of one message type of a robot (empty: of the whole session), sorted by path.
std::vector<const robotlink::StreamStore::Stream*> streamsOfType(const robotlink::StreamStore& store,
                                                                 const std::string& robot, const char* type);

/// A robot's table at a time by its path ("tables/keys"), as a list of one; empty if there is none. Processes
/// publish their parts of the table at paths below; the debug process publishes this one, which has all
/// parts.
std::vector<const robotlink::StreamMessage*> latestTable(const robotlink::StreamStore& store,
                                                         const std::string& robot, const char* path,
                                                         robotlink::Instant time);

/// The newest messages of those streams not later than `time`; null where a stream began later. The addresses
/// of their values change whenever their contents do, so comparing them (see valuesOf()) detects news
/// cheaply.
std::vector<const robotlink::StreamMessage*> latestOfType(const robotlink::StreamStore& store,
                                                          const std::string& robot, const char* type,
                                                          robotlink::Instant time);
/// The addresses of the messages' values, to be compared with those of the last tick.
std::vector<const void*> valuesOf(const std::vector<const robotlink::StreamMessage*>& messages);

/// The part behind the last '/': "cognition" of "red1/stopwatches/cognition".
std::string lastPart(const std::string& path);

/// Whether there are streams of other programs that belong to no robot, as in logs of ROS: all but those of
/// our own world ("scene", "map").
bool hasForeignStreams(const robotlink::StreamStore& store);

/// Returns each message of a stream once, including one that arrived late and was inserted among messages
/// that were returned before. Starts over after a reset of the clock.
class StreamCursor {
 public:
  /// The messages since the last call.
  struct News {
    /// Oldest first; valid until the store changes.
    std::vector<const robotlink::StreamMessage*> messages;
    /// The clock went back: messages that were returned before are no longer valid.
    bool restarted = false;
    /// Whether earlier new messages were dropped from the history before this call.
    bool missed = false;
  };
  /// Returns the new messages of `stream`, which must be the same one in each call.
  News take(const robotlink::StreamStore::Stream& stream);

 private:
  /// Whether the message was returned before.
  bool seen(const robotlink::StreamMessage& message) const;

  /// Generation and message count of the stream at the last call.
  std::uint64_t generation_ = 0;
  std::uint64_t count_ = 0;
  robotlink::Instant newest_;
  /// The last 256 messages that were returned, kept alive so that no new message has the address of an old
  /// one.
  std::deque<robotlink::PackagePtr> recent_;
};

}  // namespace widgets
