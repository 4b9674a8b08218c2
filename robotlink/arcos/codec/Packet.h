// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace robotlink::arcos {

using Bytes = std::vector<std::uint8_t>;

/// The frame of every packet, in either direction: 0xFA 0xFB COUNT ID data... CHECKSUM(high, low). COUNT
/// counts what follows it: the id, the data, and the checksum's two bytes.
inline constexpr std::uint8_t kHeader1 = 0xFA;
inline constexpr std::uint8_t kHeader2 = 0xFB;
inline constexpr std::size_t kMinimumCount = 3;
/// Larger counts are taken for damage, as real clients do.
inline constexpr std::size_t kMaximumCount = 249;
/// Robots ignore what counts more than 204, some clients what counts more than 200: nothing sent should.
inline constexpr std::size_t kMaximumSentCount = 200;
inline constexpr std::size_t kMaximumData = kMaximumCount - kMinimumCount;
inline constexpr std::size_t kMaximumSentData = kMaximumSentCount - kMinimumCount;

/// Who sent a packet: what its number and its data mean depends on it.
enum class Direction { kFromClient, kFromRobot };

/// A packet without its frame: what it says is in Command.h and in
/// ServerPackets.h.
struct Packet {
  std::uint8_t id = 0;
  Bytes data;

  /// COUNT of its frame.
  std::size_t count() const { return data.size() + kMinimumCount; }
  bool operator==(const Packet&) const = default;
};

/// Over the id and the data: the sum of their big-endian pairs, exclusive or the last byte if it is left
/// alone.
std::uint16_t checksum(std::span<const std::uint8_t> idAndData);

/// The packet in its frame. Data past kMaximumData does not fit into a frame: that is a programming error;
/// nothing is encoded then (an empty result).
Bytes encode(const Packet& packet);

/// The same, appended to `bytes`.
void append(const Packet& packet, Bytes& bytes);

/// "fafb03000000"
std::string toHex(std::span<const std::uint8_t> bytes);

}  // namespace robotlink::arcos
