// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

namespace robotlink::websocket {

/// The groups of a robot's parameters: "red1/keys/...".
inline constexpr char kKeysGroup[] = "keys", kSolutionsGroup[] = "solutions";

/// A name in front of the first slash, and what follows it: a robot, and its stream; no robot without slash.
inline std::pair<std::string, std::string> splitAtSlash(const std::string& path) {
  const std::size_t slash = path.find('/');
  if (slash == std::string::npos) return {"", path};
  return {path.substr(0, slash), path.substr(slash + 1)};
}

}  // namespace robotlink::websocket
