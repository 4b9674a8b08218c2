// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/ListenAddress.h"

#include <charconv>

namespace robotlink::websocket {

Result<ListenAddress> parseListenAddress(std::string_view text) {
  const auto wrong = [&](const std::string& why) {
    return failure("foxglove.address", "'" + std::string(text) + "' is not an address to listen on: " + why,
                   {}, {std::string(text)});
  };
  ListenAddress result;
  const std::size_t colon = text.rfind(':');
  const std::string_view port = colon == std::string_view::npos ? text : text.substr(colon + 1);
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), result.port);
  if (port.empty() || error != std::errc() || end != port.data() + port.size())
    return wrong("write [ADDRESS:]PORT with a port from 0 to 65535, such as 8765 or 192.168.0.7:8765");
  if (colon == std::string_view::npos) return result;
  std::string_view address = text.substr(0, colon);
  if (address.starts_with('[') && address.ends_with(']')) {
    address = address.substr(1, address.size() - 2);
  } else if (address.find(':') != std::string_view::npos) {
    return wrong("an IPv6 address needs brackets, such as [::1]:8765");
  }
  if (address.find_first_of("[]") != std::string_view::npos)
    return wrong("an address has one pair of brackets at most, such as [::1]:8765");
  if (address.empty()) return wrong("there is a colon, but no address before it");
  if (address != "localhost") result.address = address;
  return result;
}

bool isLoopback(const ListenAddress& address) {
  // A name, or anything else that only begins like one of these, is no loopback.
  const bool isV4 = address.address.starts_with("127.") &&
                    address.address.find_first_not_of("0123456789.") == std::string::npos;
  return isV4 || address.address == "::1";
}

std::string toString(const ListenAddress& address) {
  const bool isV6 = address.address.find(':') != std::string::npos;
  return (isV6 ? "[" + address.address + "]" : address.address) + ":" + std::to_string(address.port);
}

}  // namespace robotlink::websocket
