// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/OfferAddress.h"

#include "robotlink/foxglove/protocol/Codec.h"

namespace app {

robotlink::Result<robotlink::websocket::ListenAddress> parseOfferAddress(const std::string& text) {
  return robotlink::websocket::parseListenAddress(
      text.empty() ? std::to_string(robotlink::websocket::kDefaultPort) : text);
}

}  // namespace app
