// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace app {

/// Returns a value as the text that `--json` prints: indented, with a newline at the end. Bytes that are not
/// UTF-8, as in the names of old files, are replaced; nlohmann's own default throws.
template <typename Json>
std::string jsonOutput(const Json& value) {
  return value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// The same in one line, as messages to other programs are.
template <typename Json>
std::string jsonMessage(const Json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace app
