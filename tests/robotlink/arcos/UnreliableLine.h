// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <deque>

#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Random.h"

namespace robotlink::arcos {

/// One direction of a line that loses, damages and delays packets, reproducibly by its seed.
class UnreliableLine {
 public:
  struct Faults {
    /// All are shares of the packets; lost: never arrives.
    double lost = 0;
    /// One bit is wrong.
    double damaged = 0;
    /// The end is missing.
    double shortened = 0;
    /// Arrives 20 to 200 ms later, possibly behind others.
    double delayed = 0;
    /// Random bytes precede it.
    double garbage = 0;
  };

  explicit UnreliableLine(std::uint64_t seed) : random_(seed) {}

  Faults faults;
  /// Whether nothing arrives at all.
  bool cut = false;

  void write(const Packet& packet, Instant now) {
    if (cut || happens(faults.lost)) return;
    Bytes bytes = encode(packet);
    if (happens(faults.damaged))
      bytes[random_.bits() % bytes.size()] ^= static_cast<std::uint8_t>(1U << (random_.bits() % 8));
    if (happens(faults.shortened)) bytes.resize(random_.bits() % bytes.size());
    if (happens(faults.garbage)) {
      for (auto count = random_.bits() % 20; count > 0; --count)
        bytes.insert(bytes.begin(), static_cast<std::uint8_t>(random_.bits()));
    }
    const Duration delay = happens(faults.delayed) ? fromSeconds(random_.uniform(0.02, 0.2)) : Duration(0);
    const auto later =
        std::find_if(waiting_.begin(), waiting_.end(), [&](const auto& w) { return w.at > now + delay; });
    waiting_.insert(later, {now + delay, std::move(bytes)});
  }

  /// Writes complete packets.
  void write(const Bytes& packets, Instant now) {
    PacketParser parser;
    parser.push(packets);
    while (const auto found = parser.next()) write(std::get<Packet>(*found), now);
  }

  /// Returns what has arrived by now.
  Bytes read(Instant now) {
    Bytes bytes;
    while (!waiting_.empty() && waiting_.front().at <= now) {
      bytes.insert(bytes.end(), waiting_.front().bytes.begin(), waiting_.front().bytes.end());
      waiting_.pop_front();
    }
    return bytes;
  }

 private:
  bool happens(double share) { return share > 0 && random_.uniform() < share; }

  struct Waiting {
    Instant at;
    Bytes bytes;
  };
  Random random_;
  std::deque<Waiting> waiting_;
};

/// A parser at the end of a line with the timeout of its users: 100 ms of silence end a packet.
class LineEnd {
 public:
  template <typename Take>
  void take(const Bytes& bytes, Instant now, Take take) {
    if (!bytes.empty()) {
      lastBytes_ = now;
    } else if (parser.isPartial() && now - lastBytes_ >= std::chrono::milliseconds(100)) {
      parser.dropPartial();
    }
    parser.push(bytes);
    while (const auto found = parser.next()) take(*found);
  }

  PacketParser parser;

 private:
  Instant lastBytes_{};
};

}  // namespace robotlink::arcos
