// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace robotlink::arcos {

/// Data of packets and streams.
using Bytes = std::vector<std::uint8_t>;

/// The frame of every packet in both directions: 0xFA 0xFB COUNT ID data... CHECKSUM(high, low). COUNT is the
/// number of bytes after it: the id, the data, and two bytes of checksum.
inline constexpr std::uint8_t kHeader1 = 0xFA;
inline constexpr std::uint8_t kHeader2 = 0xFB;
/// The COUNT of a packet without data.
inline constexpr std::size_t kMinCount = 3;
/// Larger counts are treated as damage, as real clients do.
inline constexpr std::size_t kMaxCount = 249;
/// Robots ignore packets with a COUNT above 204, some clients those above 200, so none should be sent.
inline constexpr std::size_t kMaxSentCount = 200;
/// The most data that can be received, and that should be sent.
inline constexpr std::size_t kMaxData = kMaxCount - kMinCount;
inline constexpr std::size_t kMaxSentData = kMaxSentCount - kMinCount;

/// The sender of a packet, which determines the meaning of its id and data.
enum class Direction { kFromClient, kFromRobot };

/// A packet without its frame. Its contents are decoded in Command.h and ServerPackets.h.
struct Packet {
  std::uint8_t id = 0;
  Bytes data;

  /// The COUNT of its frame.
  std::size_t count() const { return data.size() + kMinCount; }
  /// The size of its frame: header and COUNT come before what COUNT counts.
  std::size_t frameSize() const { return count() + 3; }
  bool operator==(const Packet&) const = default;
};

/// The checksum of id and data: the sum of the big-endian 16-bit pairs, XORed with the last byte if the
/// number of bytes is odd.
std::uint16_t checksum(std::span<const std::uint8_t> idAndData);

/// Puts a packet into its frame. Data longer than kMaxData do not fit, which is a programming error; the
/// result is then empty.
Bytes encode(const Packet& packet);

/// Appends the encoded packet to `bytes`.
void append(const Packet& packet, Bytes& bytes);

/// Two hexadecimal digits a byte: "fafb03000000".
std::string toHex(std::span<const std::uint8_t> bytes);

}  // namespace robotlink::arcos
