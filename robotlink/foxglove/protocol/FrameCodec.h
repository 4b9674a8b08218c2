// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Error.h"
#include "robotlink/foxglove/protocol/ClientMessages.h"
#include "robotlink/foxglove/protocol/ServerMessages.h"

// The two halves of the codec. Messages that are not of the half's kind must not be encoded by it.
namespace robotlink::websocket {

std::string encodeText(const ServerMessage& message);
std::string encodeText(const ClientMessage& message);
Result<ServerMessage> decodeServerText(std::string_view text);
Result<ClientMessage> decodeClientText(std::string_view text);

std::string encodeBinary(const ServerMessage& message);
std::string encodeBinary(const ClientMessage& message);
Result<ServerMessage> decodeServerBinary(std::string_view bytes);
Result<ClientMessage> decodeClientBinary(std::string_view bytes);

}  // namespace robotlink::websocket
