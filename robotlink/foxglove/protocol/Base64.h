// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace robotlink::websocket {

/// Returns base64 with padding, as in RFC 4648.
std::string toBase64(std::string_view bytes);
/// Returns nothing if the text is not base64 with padding.
std::optional<std::string> fromBase64(std::string_view text);

}  // namespace robotlink::websocket
