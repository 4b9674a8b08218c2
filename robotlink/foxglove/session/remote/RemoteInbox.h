// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "robotlink/decoding/MessageType.h"
#include "robotlink/foxglove/protocol/ServerMessages.h"

namespace robotlink::websocket {

/// A channel of a server, as both threads know it.
struct RemoteChannel {
  explicit RemoteChannel(const Channel& channel);

  /// Whether messages of its type are large and many.
  bool isHeavy() const;

  const std::uint64_t id;
  /// `type`: what messages have that are decoded.
  const std::string topic, type, encoding;
  /// Whether its encoding is one that is decoded; false once its schema turned out to be invalid.
  std::atomic<bool> isDecoded;
  std::atomic<std::uint64_t> messages{0}, bytes{0};
};
using RemoteChannelPtr = std::shared_ptr<RemoteChannel>;

/// The decoded messages of a server, on their way from the link's thread to that of a session: packages of
/// their types. Bounded; over the limit the oldest are dropped and counted, also the server's texts, but
/// not latched messages.
class RemoteInbox {
 public:
  struct Arrival {
    RemoteChannelPtr channel;
    Instant time;
    PackagePtr value;
    std::size_t bytes = 0;
    /// If it is not a message: what is to be done, and whether it may be left out.
    std::function<void()> work;
    bool isSparable = false;

    /// Whether the limits are for it.
    bool isCounted() const { return value != nullptr || isSparable; }
  };
  struct Limits {
    std::size_t messages = 50'000, bytes = 64U << 20U;
    /// Changes of what the server offers.
    std::size_t changes = 20'000;
  };
  /// Makes another package of one, such as an image of a compressed one. Null: it cannot.
  using Convert = std::function<PackagePtr(const PackagePtr&)>;

  RemoteInbox(Limits limits, Convert convert) : limits_(limits), convert_(std::move(convert)) {}

  // The link's thread.
  std::vector<RemoteChannelPtr> add(const std::vector<Channel>& channels);
  void remove(const std::vector<Channel>& channels);
  void removeAll() { types_.clear(); }
  void push(const Channel& channel, Instant time, std::string_view payload);
  /// Queues work that is never left out.
  void push(std::function<void()> work);
  /// Queues a change of the server's offers, which is never left out. Returns false without taking it if too
  /// many of them wait: then the server is no longer followed, and its connection must end.
  bool pushChange(std::function<void()> work);
  /// Queues work on a text of `bytes` bytes, which is left out like messages are.
  void pushSparable(std::function<void()> work, std::size_t bytes);

  // The session's thread.
  std::deque<Arrival> take();
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Typed {
    RemoteChannelPtr channel;
    std::string schemaName, schema, schemaEncoding;
    /// The type, made with the first message.
    std::optional<MessageType> type;
  };
  PackagePtr decode(Typed& typed, std::string_view payload) const;
  void push(Arrival arrival);

  const Limits limits_;
  const Convert convert_;
  /// The link's thread alone.
  std::unordered_map<std::uint64_t, Typed> types_;
  std::atomic<std::uint64_t> dropped_{0};
  /// Protects what follows.
  std::mutex mutex_;
  std::deque<Arrival> arrivals_;
  std::size_t messages_ = 0, bytes_ = 0, changes_ = 0;
};

}  // namespace robotlink::websocket
