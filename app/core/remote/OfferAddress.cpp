// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/OfferAddress.h"

#include "robotlink/foxglove/protocol/Codec.h"

namespace app {

using robotlink::websocket::ListenAddress;

robotlink::Result<ListenAddress> parseOfferAddress(const std::string& text) {
  auto address = robotlink::websocket::parseListenAddress(
      text.empty() ? std::to_string(robotlink::websocket::kDefaultPort) : text);
  if (address && !address->address.starts_with("127.") && address->address != "::1") {
    return robotlink::failure(
        "listen.address",
        "only addresses of this machine are possible, since there is no encryption yet: "
        "listen at 127.0.0.1, and forward the port with ssh -L");
  }
  return address;
}

}  // namespace app
