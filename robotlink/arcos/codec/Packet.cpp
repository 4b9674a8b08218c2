// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/Packet.h"

#include <cassert>

namespace robotlink::arcos {

std::uint16_t checksum(std::span<const std::uint8_t> idAndData) {
  unsigned sum = 0;
  std::size_t i = 0;
  for (; i + 1 < idAndData.size(); i += 2)
    sum += (static_cast<unsigned>(idAndData[i]) << 8U) | idAndData[i + 1];
  sum &= 0xFFFFU;
  if (i < idAndData.size()) sum ^= idAndData[i];
  return static_cast<std::uint16_t>(sum);
}

void append(const Packet& packet, Bytes& bytes) {
  assert(packet.data.size() <= kMaxData);
  if (packet.data.size() > kMaxData) return;
  const std::size_t start = bytes.size();
  bytes.insert(bytes.end(), {kHeader1, kHeader2, static_cast<std::uint8_t>(packet.count()), packet.id});
  bytes.insert(bytes.end(), packet.data.begin(), packet.data.end());
  const std::uint16_t sum = checksum(std::span(bytes).subspan(start + 3));
  bytes.push_back(static_cast<std::uint8_t>(sum >> 8U));
  bytes.push_back(static_cast<std::uint8_t>(sum & 0xFFU));
}

Bytes encode(const Packet& packet) {
  Bytes bytes;
  bytes.reserve(packet.count() + 3);
  append(packet, bytes);
  return bytes;
}

std::string toHex(std::span<const std::uint8_t> bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

}  // namespace robotlink::arcos
