// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "robotlink/base/Error.h"

namespace robotlink::arcos {

/// The port of the first robot, used if the URL has none.
inline constexpr std::uint16_t kDefaultPort = 8101;
/// The default rate of ARCOS.
inline constexpr int kDefaultBaud = 9600;

/// A robot, or its simulator, in the network.
struct TcpAddress {
  // A name or an address, without brackets.
  std::string host;
  std::uint16_t port = kDefaultPort;
  bool operator==(const TcpAddress&) const = default;
};

/// A robot at a serial port.
struct SerialAddress {
  std::string device;
  // The baud rate, one of those that ARCOS supports.
  int baud = kDefaultBaud;
  bool operator==(const SerialAddress&) const = default;
};

/// The address of a robot as users write it: "tcp://HOST[:PORT]" (an IPv6 address in brackets) or
/// "serial://DEVICE[?baud=RATE]" with an absolute path as DEVICE. Short forms are "HOST:PORT" and
/// "/dev/ttyUSB0".
using StreamUrl = std::variant<TcpAddress, SerialAddress>;

/// Parses a URL; the error ("url.bad") says how to write it.
Result<StreamUrl> parseUrl(const std::string& text);

/// The inverse of parseUrl(): parseUrl(toString(url)) is url.
std::string toString(const StreamUrl& url);

}  // namespace robotlink::arcos
