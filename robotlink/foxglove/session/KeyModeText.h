// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Error.h"

namespace robotlink::websocket {

// The mode of a debug key as a text: "off", "always", "5 times", "every 3" (of the calls), "every 200 ms".

std::string textOf(const robotcontrol::KeyMode& mode);
/// The error says which texts there are.
Result<robotcontrol::KeyMode> keyModeOf(const std::string& text);

}  // namespace robotlink::websocket
