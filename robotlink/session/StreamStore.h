// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/session/HistoryArchive.h"
#include "robotlink/session/StreamMessage.h"

namespace robotlink {

/// The bounded history of all streams of a session. Messages are never copied: views share them. Up to
/// horizon() it is complete: of each stream it has the newest message at that instant, however old, and all
/// later ones, so that rarely changing messages (tables, transforms) are never lost.
///
/// Older messages beyond the limits are dropped into the archive, if there is one. A stretch of time that
/// is looked at stays among the messages of its streams, beyond what the limits allow; between it and the
/// horizon there may be a gap, see has().
///
/// Used by one thread, the GUI's; producers push to Session. The messages of one process in one stream arrive
/// in order of time (several processes may write to one stream, such as the log; their messages are merged by
/// time here). A message that is older than its predecessor means that the simulation was reset: all later
/// messages of all streams are dropped. Only latched messages (tables, the scene; see LatchedMessages.h)
/// stay, with that time.
///
/// The number of streams is limited, in case a robot makes up paths; messages of further streams are refused
/// and counted. Pointers to messages and streams are valid until the next add() or clear().
class StreamStore {
 public:
  /// Longer than any program runs.
  static constexpr Duration kNoLimit = std::chrono::hours(24 * 3650);
  /// Messages that are older or exceed these limits are dropped, oldest first.
  struct Limits {
    // In the platform's time, before the newest message.
    Duration age = kNoLimit;
    std::size_t bytes = std::size_t{1} << 30U;
    // How many paths may exist at once.
    std::size_t streams = 10'000;
  };
  struct Stream {
    std::string path;
    /// Full name of the message type.
    std::string type;
    /// In order of time, oldest first.
    std::deque<StreamMessage> messages;
    /// The store's generation() when the stream appeared.
    std::uint64_t generation = 0;
    /// Messages received since it appeared.
    std::uint64_t count = 0;
    /// Memory held by `messages`.
    std::uint64_t bytes = 0;
    /// How many of `messages`, at their front, are there only because they are looked at.
    std::size_t lookedAt = 0;
    /// Messages per second, over the last second of the platform's time; updated every 0.1 s of it.
    double rate = 0;
    /// Memory that these messages take, bytes per second; updated together.
    double byteRate = 0;
    /// The readers that have read it, as bits of setReader().
    mutable std::uint64_t readers = 0;
    /// Time of the first message after the start or a reset.
    Instant since;
    /// Time of the newest message of each process.
    std::map<std::string, Instant> newestOf = {};
  };

  explicit StreamStore(Limits limits);
  /// Stores a message; one without a value is ignored. Drops what exceeds the limits.
  void add(StreamMessage message);
  /// Drops everything and increments generation().
  void clear();

  /// Sets the archive for dropped messages; null: none. It must outlive the store's use.
  void setArchive(HistoryArchive* archive) { archive_ = archive; }
  /// Sets the current reader of streams, as one bit; 0: a reader that is not counted. find() and latest()
  /// note it in Stream::readers. StreamReaders has their names.
  void setReader(std::uint64_t bit) { reader_ = bit; }
  std::uint64_t reader() const { return reader_; }
  /// Notes it for a stream that was found in another way.
  void noteRead(const Stream& stream) const { stream.readers |= reader_; }
  void forgetReaders();

  /// Changes how many bytes are kept. Drops what exceeds them, at once if there is no archive, otherwise by
  /// lowerBound().
  void setBytes(std::size_t bytes);
  /// Drops a part of what exceeds the limit since it was lowered, if the archive has room for it. Called in
  /// each tick.
  void lowerBound();
  const Limits& limits() const { return limits_; }
  /// The instant from which on the history is complete; Instant::min() if nothing was dropped yet.
  Instant horizon() const { return horizon_; }
  /// Whether the messages of an instant are here: it is not before the horizon, or it is looked at.
  bool has(Instant time) const;
  /// Returns the stretch that is looked at; unset: none.
  const std::optional<Stretch>& lookedAt() const { return looked_; }
  /// Looks at a stretch that is not before the horizon: its messages stay from now on.
  void lookAt(Stretch stretch);
  /// Looks at a stretch that was dropped: its messages are among those of their streams again. `messages` are
  /// in order of time and begin with the newest of each stream at the stretch's begin.
  void lookAt(Stretch stretch, std::vector<StreamMessage> messages);
  /// Drops what was only there because it was looked at.
  void lookAway();

  /// Increases with every clear(): values derived from an earlier generation are obsolete.
  std::uint64_t generation() const { return generation_; }

  /// Null if the stream does not exist.
  const Stream* find(const std::string& path) const;
  /// All streams whose path starts with `prefix`, sorted by path.
  std::vector<const Stream*> streams(const std::string& prefix = {}) const;
  /// The newest message not later than `time`; null if there is none. Logarithmic in the length of the
  /// stream.
  const StreamMessage* latest(const std::string& path, Instant time) const;
  /// The same as a T; null if there is none or if it is of another type.
  template <typename T>
  const T* latestAs(const std::string& path, Instant time) const {
    const StreamMessage* message = latest(path, time);
    return message ? dynamic_cast<const T*>(message->value.get()) : nullptr;
  }
  /// Increases with every change to the list of streams or their types, so that views need not compare lists.
  std::uint64_t listVersion() const { return listVersion_; }
  std::size_t bytes() const { return bytes_; }
  /// The latest time of all messages; the clock's zero if there are none.
  Instant newest() const { return newest_; }
  /// The number of messages dropped because there were too many streams.
  std::uint64_t refused() const { return refused_; }

 private:
  Stream* streamFor(const StreamMessage& message);
  void insert(Stream& stream, StreamMessage message);
  /// Drops messages that another one of their stream follows not later than `until`, and then the oldest
  /// while they hold more than `bytes`.
  void drop(Instant until, std::size_t bytes);
  /// Drops the oldest messages of a stream that are not looked at, this many, and adds them to `dropped`.
  void dropOldest(Stream& stream, std::size_t count, std::vector<StreamMessage>& dropped);
  /// Drops messages later than `time` after the platform's clock was set back.
  void forgetAfter(Instant time);
  void forgetOld();
  /// Drops old messages and updates the rates of all streams.
  void sweep();

  Limits limits_;
  /// How many bytes are kept now: more than the limit for a while after that was lowered.
  std::size_t bound_;
  std::map<std::string, Stream> streams_;
  HistoryArchive* archive_ = nullptr;
  Instant horizon_ = Instant::min();
  std::optional<Stretch> looked_;
  /// The sizes of all messages, and of those that are there only because they are looked at.
  std::size_t bytes_ = 0;
  std::size_t lookedBytes_ = 0;
  std::uint64_t listVersion_ = 0;
  std::uint64_t generation_ = 0;
  std::uint64_t refused_ = 0;
  /// The bit of the current reader.
  std::uint64_t reader_ = 0;
  Instant newest_;
  /// When sweep() last ran, in the platform's time.
  Instant swept_;
};

}  // namespace robotlink
