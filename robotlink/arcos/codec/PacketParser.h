// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <variant>

#include "robotlink/arcos/codec/Packet.h"

namespace robotlink::arcos {

/// Received bytes that are not a packet.
struct DamagedBytes {
  /// The kind of damage.
  enum class Kind {
    /// Bytes between packets.
    kGarbage,
    /// A header with an impossible count.
    kCount,
    /// A packet with a wrong checksum.
    kChecksum,
    /// The beginning of a packet whose rest never arrived.
    kPartial,
  };
  Kind kind = Kind::kGarbage;
  /// The bytes, at most a few hundred; longer garbage is split.
  Bytes bytes;
  bool operator==(const DamagedBytes&) const = default;
};

/// The kind in words: "wrong checksum", "no packet", ...
const char* describe(DamagedBytes::Kind kind);

/// Finds packets in a stream of bytes, whatever else it contains and however it is split.
///
///   parser.push(bytes);
///   while (auto found = parser.next()) { ... }   // empty: it needs more bytes
///
/// After damage it continues at the next header, even inside the length that the damaged packet claims, so a
/// wrong count costs only that packet. Every pushed byte ends up in exactly one packet or damage. The result
/// depends only on the calls. Not thread-safe.
class PacketParser {
 public:
  using Found = std::variant<Packet, DamagedBytes>;

  /// Counts since construction.
  struct Counters {
    std::uint64_t packets = 0;
    std::uint64_t checksumErrors = 0;
    /// Bytes of damage of any kind.
    std::uint64_t skippedBytes = 0;
    bool operator==(const Counters&) const = default;
  };

  /// The limit of unread bytes. Beyond it, the oldest bytes are skipped and counted.
  static constexpr std::size_t kMaxBuffered = 64U << 10U;

  /// Appends received bytes.
  void push(std::span<const std::uint8_t> bytes);
  /// The next packet or damage; empty if more bytes are needed.
  std::optional<Found> next();
  /// The bytes of the packet that next() found last, as they came; valid until the next push().
  std::span<const std::uint8_t> frame() const { return std::span(buffer_).first(begin_).last(frameSize_); }

  /// Whether the beginning of a packet waits for its rest. If nothing arrives for 100 ms, it never will: see
  /// dropPartial().
  bool isPartial() const { return begin_ < buffer_.size(); }
  /// Call it after silence within a packet: next() gives up packets that began before this call, and searches
  /// their bytes for other packets.
  void dropPartial() { giveUpBefore_ = buffer_.size(); }
  /// Drops all bytes, for a new connection; the counters keep their values.
  void clear();

  const Counters& counters() const { return counters_; }

 private:
  /// The position of the next header in [from, end), or `end`.
  std::size_t nextHeader(std::size_t from, std::size_t end) const;
  /// Removes bytes up to `end` as damage.
  DamagedBytes takeDamage(DamagedBytes::Kind kind, std::size_t end);
  /// Decides what to do with an incomplete packet.
  std::optional<Found> needMore();

  Bytes buffer_;
  /// Start of the unread bytes in buffer_.
  std::size_t begin_ = 0;
  /// The size of the packet that ends at begin_; 0 if none does.
  std::size_t frameSize_ = 0;
  /// Packets that start before this position get no more bytes.
  std::size_t giveUpBefore_ = 0;
  Counters counters_;
};

}  // namespace robotlink::arcos
