// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"
#include "robotlink/foxglove/server/ListenAddress.h"

namespace app {

/// Reads the address at which robots are offered to others, "[ADDRESS:]PORT"; empty: the default port on this
/// machine only. Fails, with what to do instead, for addresses at which nothing may be offered.
robotlink::Result<robotlink::websocket::ListenAddress> parseOfferAddress(const std::string& text);

}  // namespace app
