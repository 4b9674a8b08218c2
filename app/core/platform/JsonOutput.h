// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace app {

/// The same JSON with those control characters escaped that need not be: DEL and C1 (U+0080 to U+009F), which
/// terminals obey.
inline std::string withControlsEscaped(const std::string& json) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string escaped;
  for (std::size_t at = 0; at < json.size(); ++at) {
    auto byte = static_cast<unsigned char>(json[at]);
    const bool isC1 = byte == 0xC2 && at + 1 < json.size() && static_cast<unsigned char>(json[at + 1]) < 0xA0;
    if (isC1) byte = static_cast<unsigned char>(json[++at]);
    if (isC1 || byte == 0x7F) {
      escaped.append("\\u00").append({kDigits[byte >> 4U], kDigits[byte & 15U]});
    } else {
      escaped += json[at];
    }
  }
  return escaped;
}

/// Returns a value as the text that `--json` prints: indented, with a newline at the end. Bytes that are not
/// UTF-8, as in the names of old files, are replaced; nlohmann's own default throws.
template <typename Json>
std::string jsonOutput(const Json& value) {
  return withControlsEscaped(value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace)) + "\n";
}

/// The same in one line, as messages to other programs are.
template <typename Json>
std::string jsonMessage(const Json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace app
