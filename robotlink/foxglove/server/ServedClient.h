// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <set>

#include "robotlink/foxglove/server/ServerOptions.h"

namespace robotlink::websocket {

/// A server's state for one client. The server's mutex protects all but the information and atomic members.
struct ServedClient {
  const ClientInfo info;
  Outbox outbox;
  /// Called with the server's mutex locked when something waits again after next() found nothing; must not
  /// call the server. Empty when the client is gone.
  std::function<void()> wake;
  bool isIdle = true;
  /// Whether something waits for the end of a Batch.
  bool isHeld = false;
  /// Why it is being closed; empty while it is not.
  std::string closing = {};

  std::map<std::uint32_t, ChannelPtr> subscriptions = {};
  std::map<std::uint32_t, ClientChannel> channels = {};
  std::set<std::string> parameterNames = {};
  /// The rates in messages a second, by topic.
  std::map<std::string, double> rates = {};
  bool wantsAllParameters = false;
  bool wantsGraph = false;
  std::size_t calls = 0;
  /// The parts that have arrived of a call that is sent in parts.
  struct PartialCall {
    ServiceCallRequest call;
    std::size_t total = 0;
    std::string payload = {};
  };
  std::optional<PartialCall> partialCall = {};

  /// When the link heard anything of it, by the server's clock, since its zero.
  std::atomic<Duration::rep> heardAt{0};
  /// The silence after which a sign of life is requested, unless the link is faster; 0: the link decides.
  std::atomic<Duration::rep> pingEvery{0};
};

}  // namespace robotlink::websocket
