// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/OfferAddress.h"

#include "robotlink/foxglove/protocol/MessageCodec.h"

namespace app {

robotlink::Result<robotlink::websocket::ListenAddress> parseOfferAddress(const std::string& text) {
  return robotlink::websocket::parseListenAddress(
      text.empty() ? std::to_string(robotlink::websocket::kDefaultPort) : text);
}

std::vector<std::string> offerUrls(const std::string& scheme,
                                   const robotlink::websocket::ListenAddress& address,
                                   const std::vector<std::string>& localAddresses) {
  using robotlink::websocket::ListenAddress;
  const auto urlOf = [&](const ListenAddress& one) { return scheme + "://" + toString(one); };
  if (address.address != "0.0.0.0" && address.address != "::") return {urlOf(address)};
  std::vector<std::string> urls;
  for (const std::string& local : localAddresses)
    if (const ListenAddress one{local, address.port}; !isLoopback(one)) urls.push_back(urlOf(one));
  if (urls.empty()) urls.push_back(urlOf({"127.0.0.1", address.port}));
  return urls;
}

}  // namespace app
