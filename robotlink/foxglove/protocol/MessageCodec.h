// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/foxglove/protocol/ClientMessages.h"
#include "robotlink/foxglove/protocol/ServerMessages.h"

// The Foxglove WebSocket protocol, version 1, as bytes: sub-protocols "foxglove.sdk.v1" and
// "foxglove.websocket.v1", which have the same messages. Pure functions of any thread. Decoders take foreign
// bytes: lengths, depths and types are checked, and errors name the field and what it must be. Members of
// JSON objects that are not known are ignored, because later versions may add some.
namespace robotlink::websocket {

inline constexpr char kSdkProtocol[] = "foxglove.sdk.v1";
inline constexpr char kWebSocketProtocol[] = "foxglove.websocket.v1";
inline constexpr std::uint16_t kDefaultPort = 8765;

enum class FrameKind { kText, kBinary };

/// A WebSocket message.
struct Frame {
  FrameKind kind = FrameKind::kText;
  std::string bytes;
  bool operator==(const Frame&) const = default;
};

/// The bytes before the payload of MessageData: opcode, subscription id, time.
inline constexpr std::size_t kMessageHeadSize = 1 + 4 + 8;
/// The deepest nesting of JSON, and the longest name (of a topic, a parameter, an asset...) that is read.
inline constexpr int kMaxJsonDepth = 32;
inline constexpr std::size_t kMaxName = 4096;

/// A time as the protocol has it, ns since 1970; there is none before that.
inline std::uint64_t wireTime(Instant time) {
  return static_cast<std::uint64_t>(std::max(time.time_since_epoch(), Duration::zero()).count());
}

Frame encode(const ServerMessage& message);
Frame encode(const ClientMessage& message);

/// The messages may refer to `bytes`.
Result<ServerMessage> decodeServerMessage(FrameKind kind, std::string_view bytes);
Result<ClientMessage> decodeClientMessage(FrameKind kind, std::string_view bytes);

}  // namespace robotlink::websocket
