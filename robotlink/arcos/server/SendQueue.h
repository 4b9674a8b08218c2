// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <deque>
#include <span>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// The bytes of packets that wait until a client reads them, oldest first.
///
/// A client that reads slowly gets what is new: packets older than kMaximumAge are dropped, and the oldest
/// ones where more than kMaximumBytes wait. Only whole packets are dropped; one whose first bytes have gone
/// out stays. What the operating systems of both ends have taken already is out of reach.
class SendQueue {
 public:
  using Instant = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kMaximumAge{1};
  static constexpr std::size_t kMaximumBytes = 64U << 10U;

  void push(const Packet& packet, Instant now);
  /// Drops what is too old at `now`.
  void dropOld(Instant now);
  /// What is to be written next; valid until the queue changes.
  std::span<const std::uint8_t> bytes() const { return bytes_; }
  /// The first bytes of bytes() have gone out.
  void written(std::size_t count);
  /// Forgets what waits; the counters stay.
  void clear();

  std::uint64_t sentPackets() const { return sent_; }
  std::uint64_t droppedPackets() const { return dropped_; }

 private:
  struct Entry {
    std::size_t size = 0;  ///< of its bytes that still wait
    Instant pushed;
  };
  void drop(std::size_t packets);
  /// The index of the first packet that may be dropped.
  std::size_t firstWhole() const { return begun_ ? 1 : 0; }

  Bytes bytes_;
  std::deque<Entry> packets_;
  bool begun_ = false;  ///< some bytes of the first packet have gone out
  std::uint64_t sent_ = 0, dropped_ = 0;
};

}  // namespace robotlink::arcos
