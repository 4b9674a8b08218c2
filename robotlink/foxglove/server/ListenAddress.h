// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

namespace robotlink::websocket {

/// An address to listen on: one of this machine, or all of them (0.0.0.0, ::).
struct ListenAddress {
  std::string address = "127.0.0.1";
  /// 0: any that is free.
  std::uint16_t port = 0;
  bool operator==(const ListenAddress&) const = default;
};

/// Reads [ADDRESS:]PORT. Loopback is the default, localhost means it; an IPv6 address is in brackets.
Result<ListenAddress> parseListenAddress(std::string_view text);

/// Whether only programs on this machine can reach it.
bool isLoopback(const ListenAddress& address);

/// Returns the address in the form in which it is parsed, with brackets for IPv6.
std::string toString(const ListenAddress& address);

}  // namespace robotlink::websocket
