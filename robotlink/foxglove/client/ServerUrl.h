// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace robotlink::websocket {

/// The URL of a server: ws://HOST[:PORT][/TARGET], or wss:// with encryption.
struct ServerUrl {
  bool isEncrypted = false;
  /// A name or an IP address; one of IPv6 without its brackets.
  std::string host;
  std::uint16_t port = 0;
  /// The part after the port, for the HTTP request: at least "/".
  std::string target = "/";
  bool operator==(const ServerUrl&) const = default;
};

/// Whether a text begins as the URL of a server does.
bool isServerUrl(std::string_view text);
/// Reads a URL; without a port it is 8765. The error says how to write one.
Result<ServerUrl> parseServerUrl(std::string_view text);
/// The URL for users and logs: without its query, which may contain a token.
std::string toString(const ServerUrl& url);

}  // namespace robotlink::websocket
