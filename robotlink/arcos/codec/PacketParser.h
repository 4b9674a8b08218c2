// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <variant>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// Bytes that were no packet, as they came.
struct Damage {
  enum class Kind {
    kGarbage,   ///< stood between packets
    kCount,     ///< a header whose count cannot be
    kChecksum,  ///< a packet whose checksum is wrong
    kPartial,   ///< the beginning of a packet whose rest never came
  };
  Kind kind = Kind::kGarbage;
  Bytes bytes;  ///< at most a few hundred; longer garbage comes in pieces
  bool operator==(const Damage&) const = default;
};

/// "wrong checksum", "no packet", ...
const char* describe(Damage::Kind kind);

/// Finds packets in a stream of bytes, whatever else is in it and however it is cut.
///
///   parser.push(bytes);
///   while (auto found = parser.next()) { ... }   // nothing: it needs more bytes
///
/// After damage it goes on at the next header, even if that lies within what the damaged packet's count
/// claims, so a lying count costs no packet but its own. Every byte pushed is in exactly one packet or
/// damage. A pure function of the calls; one thread at a time.
class PacketParser {
 public:
  using Found = std::variant<Packet, Damage>;

  struct Counters {
    std::uint64_t packets = 0;
    std::uint64_t checksumErrors = 0;
    std::uint64_t skippedBytes = 0;  ///< of damage of any kind
    bool operator==(const Counters&) const = default;
  };

  /// What a caller may leave unread. The oldest bytes past it are skipped, and counted.
  static constexpr std::size_t kMaximumBuffered = 64U << 10U;

  void push(std::span<const std::uint8_t> bytes);
  std::optional<Found> next();

  /// Whether the beginning of a packet is waiting for its rest. If nothing comes for 100 ms, it never will:
  /// see dropPartial().
  bool isPartial() const { return begin_ < buffer_.size(); }
  /// The line was silent within a packet: next() gives up what was begun before this call, and looks for
  /// packets in its bytes.
  void dropPartial() { giveUpBefore_ = buffer_.size(); }
  /// Forgets everything but the counters, as after a connection was made anew.
  void clear();

  const Counters& counters() const { return counters_; }

 private:
  std::size_t nextHeader(std::size_t from, std::size_t end) const;
  Damage takeDamage(Damage::Kind kind, std::size_t end);
  std::optional<Found> needMore();

  Bytes buffer_;
  std::size_t begin_ = 0;         ///< of buffer_: what is before it was handed out
  std::size_t giveUpBefore_ = 0;  ///< a packet that starts before it gets no more bytes
  Counters counters_;
};

}  // namespace robotlink::arcos
