// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robotlink/session/HeldMessages.h"

namespace logplayer {

/// Whether a path fits a pattern, in which "*" stands for any text, slashes too: "*/camera/image", "red1/*".
bool fits(std::string_view path, std::string_view pattern);

/// Some of the streams of a log, chosen by patterns of their paths.
struct StreamChoice {
  std::vector<std::string> include;  ///< empty: all
  std::vector<std::string> exclude;

  bool has(std::string_view path) const;
  bool operator==(const StreamChoice&) const = default;
};

using robotlink::holdsUntilToldAnew;

}  // namespace logplayer
