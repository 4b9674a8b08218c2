// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "robotlink/session/StreamMessage.h"

namespace robotlink {

/// The bounded history of all streams of a session. A message that is kept is never copied: views share it.
/// The newest message of a stream is always kept, so that what changes rarely (tables, transforms) is never
/// lost.
///
/// Used by one thread, the GUI's: producers hand messages to Session. What one process tells in one stream
/// comes in order of time (several may tell in one, as in the log: their messages are put in order here); a
/// message that goes back in time (the simulation was reset) forgets what is later in all streams of that
/// session. Only what holds until it is told anew - tables, the scene - stays, as if told then.
///
/// Streams that nobody expects (a robot that makes up paths) are refused past a limit, and counted. Pointers
/// to messages and streams are valid until the next add() or clear().
class StreamStore {
 public:
  struct Limits {
    Duration age = std::chrono::seconds(60);
    std::size_t bytes = 512U << 20U;
    std::size_t streams = 10'000;
  };
  struct Stream {
    std::string path;
    std::string type;                    ///< full name of the message type
    std::deque<StreamMessage> messages;  ///< oldest first
    std::uint64_t generation = 0;        ///< of the store when this stream came into it
    std::uint64_t count = 0;             ///< received since then
    std::uint64_t bytes = 0;             ///< kept
    double rate = 0;  ///< Hz, over the last second of the platform's time; renewed ten times in each
    Instant since;    ///< the first message after the start or a reset
    std::map<std::string, Instant> newestOf = {};  ///< by process
  };

  explicit StreamStore(Limits limits);
  void add(StreamMessage message);
  void clear();

  /// Grows with every clear(): what was read before is no longer true.
  std::uint64_t generation() const { return generation_; }

  /// Null if it has never been seen.
  const Stream* find(const std::string& path) const;
  /// All streams whose path starts with `prefix`, by path.
  std::vector<const Stream*> streams(const std::string& prefix = {}) const;
  /// The newest message not later than `time`; null if there is none.
  const StreamMessage* latest(const std::string& path, Instant time) const;
  /// The same as its type; null if it is of another.
  template <typename T>
  const T* latestAs(const std::string& path, Instant time) const {
    const StreamMessage* message = latest(path, time);
    return message ? dynamic_cast<const T*>(message->value.get()) : nullptr;
  }
  /// Grows with every change of the list of streams, so that a view need not compare lists.
  std::uint64_t listVersion() const { return listVersion_; }
  std::size_t bytes() const { return bytes_; }
  /// The latest time of all messages; the start of time if there are none.
  Instant newest() const { return newest_; }
  /// How far back the history reaches: what is kept only because it is the newest of its stream does not
  /// count.
  Instant oldest() const;
  /// Messages that were not taken because there are too many streams.
  std::uint64_t refused() const { return refused_; }

 private:
  Stream* streamFor(const StreamMessage& message);
  void insert(Stream& stream, StreamMessage message);
  void popFront(Stream& stream);
  void forgetAfter(Instant time);
  void forgetOld();
  void sweep();

  Limits limits_;
  std::map<std::string, Stream> streams_;
  std::size_t bytes_ = 0;
  std::uint64_t listVersion_ = 0;
  std::uint64_t generation_ = 0;
  std::uint64_t refused_ = 0;
  Instant newest_;
  Instant swept_;
};

}  // namespace robotlink
