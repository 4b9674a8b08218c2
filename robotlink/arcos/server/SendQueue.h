// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <deque>
#include <span>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// The bytes of packets that wait for a client to read them, oldest first.
///
/// A slow client gets recent data: packets older than kMaxAge are dropped, and the oldest ones if more
/// than kMaxBytes wait. Only whole packets are dropped, never one that was written in part. What the
/// operating systems of both ends have buffered can no longer be dropped. Not thread-safe.
class SendQueue {
 public:
  using Instant = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kMaxAge{1};
  static constexpr std::size_t kMaxBytes = 64U << 10U;

  /// Appends a packet; drops the oldest ones if there are too many bytes.
  void push(const Packet& packet, Instant now);
  /// Drops packets that are too old at `now`.
  void dropOld(Instant now);
  /// The bytes to write next; valid until the queue changes.
  std::span<const std::uint8_t> bytes() const { return bytes_; }
  /// Removes the first `count` bytes of bytes() after they were written.
  void written(std::size_t count);
  /// Drops all packets; the counters keep their values.
  void clear();

  std::uint64_t sentPackets() const { return sent_; }
  std::uint64_t droppedPackets() const { return dropped_; }

 private:
  /// A packet in bytes_.
  struct Entry {
    /// How many of its bytes still wait.
    std::size_t size = 0;
    Instant pushed;
  };
  /// Drops that many packets, beginning with the first whole one.
  void drop(std::size_t packets);
  /// The index of the first packet that may be dropped.
  std::size_t firstWhole() const { return begun_ ? 1 : 0; }

  Bytes bytes_;
  std::deque<Entry> packets_;
  /// The first packet was written in part.
  bool begun_ = false;
  std::uint64_t sent_ = 0, dropped_ = 0;
};

}  // namespace robotlink::arcos
