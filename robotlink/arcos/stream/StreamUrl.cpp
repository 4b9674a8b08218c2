// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/stream/StreamUrl.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "robotlink/base/ParsedNumber.h"

namespace robotlink::arcos {
namespace {

constexpr std::string_view kTcp = "tcp://";
constexpr std::string_view kSerial = "serial://";
// The rates that ARCOS supports.
constexpr std::array kBauds = {9600, 19200, 38400, 57600, 115200};

tl::unexpected<Error> bad(const std::string& url, const std::string& problem) {
  return failure("url.bad", "'" + url + "' is not the address of a robot: " + problem, {}, {url});
}

Result<StreamUrl> parseTcp(const std::string& url, std::string_view rest) {
  if (rest.ends_with('/')) rest.remove_suffix(1);
  std::string_view host = rest, port;
  // An IPv6 address contains colons.
  if (rest.starts_with('[')) {
    const auto end = rest.find(']');
    if (end == std::string_view::npos) return bad(url, "the bracket around the IPv6 address is not closed");
    host = rest.substr(1, end - 1);
    port = rest.substr(end + 1);
  } else if (const auto colon = rest.find(':'); colon != std::string_view::npos) {
    host = rest.substr(0, colon);
    port = rest.substr(colon);
    if (port.find(':', 1) != std::string_view::npos) {
      return bad(url, "put an IPv6 address in brackets, as in tcp://[::1]:8101");
    }
  }
  if (host.empty()) return bad(url, "the host is missing, as in tcp://localhost:8101");
  if (host.find_first_of("/?#@ ") != std::string_view::npos) {
    return bad(url, "after tcp:// there is a host and a port only, as in tcp://localhost:8101");
  }
  TcpAddress address{std::string(host), kDefaultPort};
  if (!port.empty()) {
    const auto number = port.starts_with(':') ? parsedNumber<int>(port.substr(1)) : std::nullopt;
    if (!number || *number < 1 || *number > 65535)
      return bad(url, "its port must be a number from 1 to 65535");
    address.port = static_cast<std::uint16_t>(*number);
  }
  return address;
}

Result<StreamUrl> parseSerial(const std::string& url, std::string_view rest) {
  const auto question = rest.find('?');
  SerialAddress address{std::string(rest.substr(0, question)), kDefaultBaud};
  if (!address.device.starts_with('/') || address.device == "/") {
    return bad(url, "after serial:// comes the device's whole path, as in serial:///dev/ttyUSB0");
  }
  if (question == std::string_view::npos) return address;
  const std::string_view option = rest.substr(question + 1);
  if (!option.starts_with("baud=")) return bad(url, "its only option is the speed, as in ?baud=9600");
  const auto baud = parsedNumber<int>(option.substr(5));
  if (!baud || std::ranges::find(kBauds, *baud) == kBauds.end()) {
    return bad(url, "its speed must be one of 9600, 19200, 38400, 57600, 115200 baud");
  }
  address.baud = *baud;
  return address;
}

}  // namespace

Result<StreamUrl> parseUrl(const std::string& text) {
  const std::string_view view = text;
  if (view.starts_with(kTcp)) return parseTcp(text, view.substr(kTcp.size()));
  if (view.starts_with(kSerial)) return parseSerial(text, view.substr(kSerial.size()));
  if (view.starts_with('/')) return parseSerial(text, view);
  // A text with a port can only be a network address.
  if (view.find("://") == std::string_view::npos && view.find(':') != std::string_view::npos)
    return parseTcp(text, view);
  if (!text.empty() && view.find("://") == std::string_view::npos)
    return bad(text, "for a network address also give its port, as in " + text +
                         ":8101; for a serial line the device's whole path");
  return bad(text, "write tcp://localhost:8101 or serial:///dev/ttyUSB0?baud=9600");
}

std::string toString(const StreamUrl& url) {
  if (const auto* serial = std::get_if<SerialAddress>(&url)) {
    return std::string(kSerial) + serial->device + "?baud=" + std::to_string(serial->baud);
  }
  const auto& tcp = std::get<TcpAddress>(url);
  const bool isV6 = tcp.host.find(':') != std::string::npos;
  return std::string(kTcp) + (isV6 ? "[" + tcp.host + "]" : tcp.host) + ":" + std::to_string(tcp.port);
}

}  // namespace robotlink::arcos
