// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "robotlink/base/Error.h"

namespace robotlink::arcos {

inline constexpr std::uint16_t kDefaultPort = 8101;
inline constexpr int kDefaultBaud = 9600;

struct TcpAddress {
  std::string host;
  std::uint16_t port = kDefaultPort;
  bool operator==(const TcpAddress&) const = default;
};

struct SerialAddress {
  std::string device;
  int baud = kDefaultBaud;
  bool operator==(const SerialAddress&) const = default;
};

/// Where a robot is, as people write it: "tcp://HOST[:PORT]" (an IPv6 address in brackets) or
/// "serial://DEVICE[?baud=RATE]", whose DEVICE is an absolute path. In short "HOST:PORT" and "/dev/ttyUSB0".
using StreamUrl = std::variant<TcpAddress, SerialAddress>;

/// The error ("url.bad") says how it should have been written.
Result<StreamUrl> parseUrl(const std::string& text);

/// parseUrl(toString(url)) is url.
std::string toString(const StreamUrl& url);

}  // namespace robotlink::arcos
