// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/ServerUrl.h"

#include <algorithm>

#include "robotlink/base/ParsedNumber.h"
#include "robotlink/base/Utf8.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"

namespace robotlink::websocket {
namespace {

constexpr std::string_view kPlain = "ws://", kEncrypted = "wss://";
constexpr std::size_t kMaxUrl = 2048;

tl::unexpected<Error> wrongUrl(std::string_view text, const std::string& why) {
  const std::string shown = validUtf8(std::string(text.substr(0, 100)));
  return failure("foxglove.url",
                 "'" + shown + "' is not the address of a robot: " + why +
                     "; write ws://HOST:PORT, such as ws://127.0.0.1:8765",
                 {}, {shown});
}

/// Anything else could end the line of the HTTP request that it becomes a part of.
bool isVisible(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c > ' ' && c < 0x7f; });
}

}  // namespace

bool isServerUrl(std::string_view text) {
  return text.starts_with(kPlain) || text.starts_with(kEncrypted);
}

Result<ServerUrl> parseServerUrl(std::string_view text) {
  if (!isServerUrl(text)) return wrongUrl(text, "it does not begin with ws:// or wss://");
  if (text.size() > kMaxUrl || !isVisible(text))
    return wrongUrl(text, "it has blanks or other characters that addresses do not have");
  ServerUrl url;
  url.isEncrypted = text.starts_with(kEncrypted);
  std::string_view rest = text.substr(url.isEncrypted ? kEncrypted.size() : kPlain.size());
  const std::size_t end = std::min(rest.find_first_of("/?#"), rest.size());
  if (end < rest.size()) {
    url.target = rest.substr(end, rest.find('#') - end);
    if (!url.target.starts_with('/')) url.target.insert(0, "/");
  }
  rest = rest.substr(0, end);
  if (rest.find('@') != std::string_view::npos)
    return wrongUrl("", "user names do not belong there; give a token separately");
  const bool isBracketed = rest.starts_with('[');
  const std::size_t hostEnd = isBracketed ? rest.find(']') : std::min(rest.find(':'), rest.size());
  if (hostEnd == std::string_view::npos) return wrongUrl(text, "the bracket ']' is missing");
  url.host = rest.substr(isBracketed ? 1 : 0, hostEnd - (isBracketed ? 1 : 0));
  rest = rest.substr(isBracketed ? hostEnd + 1 : hostEnd);
  if (url.host.empty()) return wrongUrl(text, "the name of the host is missing");
  if (url.host.find_first_of("[]") != std::string::npos)
    return wrongUrl(text, "an address has one pair of brackets at most, such as [::1]");
  url.port = kDefaultPort;
  if (rest.empty()) return url;
  const auto port = parsedNumber<std::uint16_t>(rest.substr(1));
  if (!rest.starts_with(':') || !port || *port == 0)
    return wrongUrl(text, "the port must be a number from 1 to 65535");
  url.port = *port;
  return url;
}

std::string toString(const ServerUrl& url) {
  const bool isIpV6 = url.host.find(':') != std::string::npos;
  const std::string host = isIpV6 ? "[" + url.host + "]" : url.host;
  const std::string path = url.target.substr(0, url.target.find('?'));
  return std::string(url.isEncrypted ? kEncrypted : kPlain) + host + ":" + std::to_string(url.port) +
         (path == "/" ? std::string() : path);
}

}  // namespace robotlink::websocket
