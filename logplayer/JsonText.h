// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace logplayer {

// JSON of files of others.

/// How deep objects and arrays may be nested; Protobuf takes no more than 100 levels.
inline constexpr int kMaxJsonDepth = 64;

/// An object; nothing if the text is no JSON, another value, or nested too deeply.
std::optional<nlohmann::json> parseJsonObject(std::string_view text);

/// On one line; text that is no UTF-8 is replaced.
std::string jsonText(const nlohmann::json& value);

/// Nothing if the text is no base64.
std::optional<std::string> decodeBase64(std::string_view text);

}  // namespace logplayer
