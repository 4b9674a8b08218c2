// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "robotlink/base/Clock.h"

namespace robotlink::websocket::test {

/// A line between clients on this machine and a server, as bad as one wants it: it delays, throttles, stalls,
/// and is cut. One thread of its own; any thread may change it.
class Relay {
 public:
  struct Line {
    /// One way.
    Duration delay{0};
    /// Each way; 0 is as fast as possible.
    double bytesPerSecond = 0;
    /// What waits in front of the throttle, as in a router; then TCP holds the sender back.
    std::size_t queueBytes = 8U << 10U;
  };
  enum class State {
    kOpen,
    kStalled,  ///< bytes wait
    kSilent,   ///< whatever is sent is lost, and connections that lost something never recover
    kCut       ///< connections are closed, and new ones, too
  };

  /// The server's port, and its IPv4 address.
  Relay(std::uint16_t target, Line line, const std::string& address = "127.0.0.1");
  ~Relay();
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

  std::uint16_t port() const;
  void set(State state);
  /// Both ways.
  std::size_t carriedBytes() const;

 private:
  struct Implementation;
  const std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink::websocket::test
