// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <deque>
#include <list>
#include <memory>
#include <unordered_map>

#include "robotlink/foxglove/protocol/MessageCodec.h"
#include "robotlink/foxglove/server/Allowance.h"

namespace robotlink::websocket {

/// Bytes that all clients share.
using SharedBytes = std::shared_ptr<const std::string>;

/// The treatment of messages of a stream for which a client is too slow.
enum class Delivery {
  kLatest,    ///< A newer message replaces the one that waits: images, states, drawings.
  kComplete,  ///< All are sent, in order; over a bound the oldest is dropped: texts, tables, results.
};

/// Counts the messages of a stream for one client.
struct StreamCounters {
  std::uint64_t sent = 0, bytes = 0;
  /// Replaced by newer ones, or given up for other streams, as its delivery allows.
  std::uint64_t thinned = 0;
  /// Lost although all were to be sent.
  std::uint64_t dropped = 0;
  bool operator==(const StreamCounters&) const = default;
};

/// A WebSocket message in two parts: the head is the client's own, the payload is shared.
struct Outgoing {
  FrameKind kind = FrameKind::kText;
  std::array<std::uint8_t, kMessageHeadSize> head{};
  std::size_t headSize = 0;
  SharedBytes payload;
  /// Whether it gets smaller by compression; images do not.
  bool isCompressible = true;
  /// Whether another message waited when this one was taken.
  bool hasMore = false;

  std::size_t size() const { return headSize + (payload ? payload->size() : 0); }
};

/// The queues of messages to one client. Control messages go first and without regard to the budget; messages
/// of streams follow in the order in which their turns came: a message that replaces another takes its turn.
/// Small and large ones have a line of turns each, and while both wait, both get the same number of bytes: on
/// a slow link many readings pass an image, which otherwise would each wait for one. A stream with a rate
/// keeps its newest message until that is due. Memory is bounded; payloads are shared. Not thread-safe.
class Outbox {
 public:
  struct Limits {
    /// Control messages that may wait, and their bytes.
    std::size_t controlMessages = 1024, controlBytes = 16U << 20U;
    /// Bytes that may wait of all streams; over it the oldest messages go. A message that waits alone may be
    /// larger.
    std::size_t streamBytes = 16U << 20U;
    /// While at most this many bytes wait in messages of up to this size, such a message does not replace an
    /// older one of its stream: on a fast line nothing is thinned only because two messages were published
    /// at once, or because an image is being sent meanwhile.
    std::size_t calmBytes = 0;
    /// Messages of more than this are large.
    std::size_t smallBytes = 0;
  };
  using StreamId = std::uint64_t;

  explicit Outbox(const Limits& limits) : limits_(limits) {}

  /// The average rate of all messages together, in bytes a second, 0 without limit.
  Allowance& budget() { return budget_; }

  /// How often a message of a stream is sent at most, in messages a second, 0 without limit; only of streams
  /// of which the latest message counts.
  void setRate(StreamId stream, double messagesPerSecond);
  /// Returns false, and does nothing, if the queue is full.
  bool pushControl(FrameKind kind, SharedBytes bytes);
  /// `maxWaiting` bounds what waits of a complete stream.
  void push(StreamId stream, Outgoing message, Delivery delivery, std::size_t maxWaiting);
  /// Counts a message of a stream that was left out before it arrived here.
  void noteThinned(StreamId stream) { ++streams_[stream].counters.thinned; }
  /// Drops the waiting messages of a stream; its counters stay.
  void clear(StreamId stream);
  /// Forgets a stream, and drops its waiting messages.
  void remove(StreamId stream);
  /// Forgets everything that waits.
  void clear();

  /// The next message to send now, if there is one within the budget.
  std::optional<Outgoing> next(Instant now);
  bool isEmpty() const { return control_.empty() && !hasTurns(); }
  std::size_t waitingBytes() const { return controlBytes_ + streamBytes_; }

  StreamCounters counters(StreamId stream) const;
  std::uint64_t sentBytes() const { return sentBytes_; }

 private:
  struct Turn {
    StreamId stream = 0;
    Outgoing message;
    /// The number of turns that were given before.
    std::uint64_t number = 0;
  };
  using Turns = std::list<Turn>;
  /// The turns of small messages, or of large ones.
  struct Line {
    Turns turns;
    /// The bytes it has sent, as far as they are compared: a line that was empty has nothing saved up.
    std::uint64_t sent = 0;
  };
  struct Stream {
    std::deque<Turns::iterator> waiting;
    /// The line in which all messages of the stream wait: they keep their order.
    Line* line = nullptr;
    Delivery delivery = Delivery::kLatest;
    StreamCounters counters;
    /// The time between two messages, and when the next one may be sent.
    Duration gap{0};
    Instant due;
  };

  /// The turn that is next among those that are due; null: none.
  Turn* firstDue(Instant now);
  Turn* firstDueOf(Line& line, Instant now);
  void addTurn(StreamId id, Stream& stream, Outgoing message);
  /// Takes the first message of a stream away.
  Outgoing takeFirst(Stream& stream);
  /// The stream whose first message waits longest.
  Stream& longestWaiting();
  static void noteSent(Stream& stream, std::size_t bytes, Instant now);
  /// Drops one of those that wait of a stream.
  void giveUp(Stream& stream, std::deque<Turns::iterator>::iterator which);
  bool hasTurns() const { return !small_.turns.empty() || !large_.turns.empty(); }
  /// A message of this size waits from now on, or no longer.
  void addWaiting(std::size_t size);
  void removeWaiting(std::size_t size);

  const Limits limits_;
  Allowance budget_;
  std::deque<Outgoing> control_;
  std::size_t controlBytes_ = 0, streamBytes_ = 0;
  /// The part of streamBytes_ in messages of up to Limits::calmBytes.
  std::size_t smallBytes_ = 0;
  Line small_, large_;
  std::uint64_t turnCount_ = 0;
  std::unordered_map<StreamId, Stream> streams_;
  std::uint64_t sentBytes_ = 0;
};

}  // namespace robotlink::websocket
