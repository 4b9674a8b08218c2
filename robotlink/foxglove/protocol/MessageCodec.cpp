// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/protocol/MessageCodec.h"

#include "robotlink/foxglove/protocol/Fields.h"
#include "robotlink/foxglove/protocol/FrameCodec.h"

namespace robotlink::websocket {
namespace {

template <typename Message>
Frame frameOf(const Message& message) {
  const bool isText = std::visit([]<typename One>(const One&) { return IsText<One>; }, message);
  return isText ? Frame{FrameKind::kText, encodeText(message)}
                : Frame{FrameKind::kBinary, encodeBinary(message)};
}

}  // namespace

Frame encode(const ServerMessage& message) {
  return frameOf(message);
}

Frame encode(const ClientMessage& message) {
  return frameOf(message);
}

Result<ServerMessage> decodeServerMessage(FrameKind kind, std::string_view bytes) {
  return kind == FrameKind::kText ? decodeServerText(bytes) : decodeServerBinary(bytes);
}

Result<ClientMessage> decodeClientMessage(FrameKind kind, std::string_view bytes) {
  return kind == FrameKind::kText ? decodeClientText(bytes) : decodeClientBinary(bytes);
}

}  // namespace robotlink::websocket
