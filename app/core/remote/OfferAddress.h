// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/foxglove/server/ListenAddress.h"

namespace app {

/// Reads the address at which robots are offered to others, "[ADDRESS:]PORT"; empty: the default port on this
/// machine only. Fails, with what to do instead, for addresses at which nothing may be offered.
robotlink::Result<robotlink::websocket::ListenAddress> parseOfferAddress(const std::string& text);

/// Returns the URLs for clients, "ws://192.168.1.7:8765". An address that stands for all networks of this
/// machine (0.0.0.0, ::) leads to one URL for each IPv4 address that other machines reach, or else
/// to that of the loopback interface. `scheme` is "ws" or "wss".
std::vector<std::string> offerUrls(const std::string& scheme,
                                   const robotlink::websocket::ListenAddress& address,
                                   const std::vector<std::string>& localAddresses);

}  // namespace app
