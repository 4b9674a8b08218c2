// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

#include "robotlink/foxglove/server/Outbox.h"

namespace robotlink::websocket {

class Server;
struct ServedClient;
using ClientPtr = std::shared_ptr<ServedClient>;

/// The description of a channel, without its id, which the server assigns.
struct ChannelSetup {
  std::string topic, encoding, schemaName, schema;
  /// Empty: that of the encoding.
  std::string schemaEncoding = {};
  Delivery delivery = Delivery::kLatest;
  /// How many messages of a complete channel may wait for a client.
  std::size_t maxWaiting = 1024;
  /// Whether new subscribers get the newest message at once. It is kept for them, so it must be published
  /// without subscribers, too.
  bool latched = false;
  /// Whether its messages get smaller by compression; images do not, or take too long.
  bool isCompressible = true;
};

/// A channel of a server, shared by the server and its publishers. All functions may be called from any
/// thread, also after the channel was removed or the server is gone; then nothing is published.
class ServerChannel {
 public:
  ServerChannel(std::weak_ptr<Server> server, std::uint64_t id, ChannelSetup setup)
      : setup_(std::move(setup)), id_(id), server_(std::move(server)) {}

  std::uint64_t id() const { return id_; }
  const ChannelSetup& setup() const { return setup_; }

  /// Whether a message would go anywhere; costs one atomic load. Ask before making its bytes.
  bool isWanted() const { return wanted_.load(std::memory_order_relaxed) > 0; }
  /// Publishes a message; never waits for a client.
  void publish(Instant time, SharedBytes payload);
  void publish(Instant time, std::string payload) {
    if (isWanted()) publish(time, std::make_shared<const std::string>(std::move(payload)));
  }
  /// Counts a message that was left out before it was published, as thinned for each subscriber.
  void noteThinned();

 private:
  friend class Server;
  struct Subscriber {
    ClientPtr client;
    std::uint32_t subscription = 0;
  };

  const ChannelSetup setup_;
  const std::uint64_t id_;
  const std::weak_ptr<Server> server_;
  /// The number of subscribers, and one for latching; 0 once it is removed.
  std::atomic<std::size_t> wanted_{0};
  // The server's mutex protects these.
  std::vector<Subscriber> subscribers_;
  Instant latchedTime_;
  SharedBytes latched_;
};

using ChannelPtr = std::shared_ptr<ServerChannel>;

}  // namespace robotlink::websocket
