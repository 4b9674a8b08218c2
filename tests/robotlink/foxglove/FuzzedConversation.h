// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "robotlink/base/bytes/ByteReader.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"
#include "tests/robotlink/foxglove/Demand.h"

// The inputs of the fuzz targets of this protocol: conversations, in which each message has a byte for its
// kind and for what else happens, and two for its length.
namespace robotlink::websocket::test {

/// A message of a conversation.
struct FuzzedMessage {
  /// The bit of `head` that says that it is a text.
  static constexpr std::uint8_t kText = 2;

  std::uint8_t head = 0;
  FrameKind kind = FrameKind::kBinary;
  /// A part of the input.
  std::string_view bytes;

  bool has(unsigned bit) const { return (head & bit) != 0; }
};

/// Reads messages of less than `maxSize` bytes; nothing at the end of the input.
inline std::optional<FuzzedMessage> nextMessage(ByteReader& reader, std::size_t maxSize) {
  if (!reader.good() || reader.rest().empty()) return std::nullopt;
  FuzzedMessage message;
  message.head = reader.take<std::uint8_t>();
  const auto bytes = reader.take(reader.take<std::uint16_t>() % maxSize);
  message.kind = message.has(FuzzedMessage::kText) ? FrameKind::kText : FrameKind::kBinary;
  message.bytes = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  return message;
}

/// The reverse, for seeds; the kind follows from the bytes.
inline std::string framed(const std::string& wire, unsigned head) {
  const unsigned kind = wire.starts_with('{') ? FuzzedMessage::kText : 0;
  return std::string{static_cast<char>(head | kind), static_cast<char>(wire.size() & 255U),
                     static_cast<char>(wire.size() >> 8U)} +
         wire;
}
inline std::string framed(const ServerMessage& message, unsigned head) {
  return framed(encode(message).bytes, head);
}
inline std::string framed(const ClientMessage& message, unsigned head) {
  return framed(encode(message).bytes, head);
}

}  // namespace robotlink::websocket::test
