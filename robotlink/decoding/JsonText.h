// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace robotlink {

// JSON from files of unknown origin, which may be arbitrarily wrong.

/// Maximum nesting of objects and arrays; Protobuf supports 100 levels.
inline constexpr int kMaxJsonDepth = 64;

/// Parses an object; empty if the text is not JSON, another kind of value, or nested too deeply.
std::optional<nlohmann::json> parseJsonObject(std::string_view text);

/// Formats a value on one line; invalid UTF-8 is replaced.
std::string jsonText(const nlohmann::json& value);

/// Empty if the text is not base64.
std::optional<std::string> decodeBase64(std::string_view text);

}  // namespace robotlink
