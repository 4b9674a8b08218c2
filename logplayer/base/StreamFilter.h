// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robotlink/session/LatchedMessages.h"

namespace logplayer {

/// Whether a path matches a pattern, in which "*" matches any text, including slashes: "*/camera/image",
/// "red1/*".
bool fits(std::string_view path, std::string_view pattern);

/// A selection of streams by patterns for their paths. A plain value.
struct StreamFilter {
  /// Empty: all streams.
  std::vector<std::string> include;
  /// Takes precedence over `include`.
  std::vector<std::string> exclude;

  /// Whether a stream is selected.
  bool has(std::string_view path) const;
  bool operator==(const StreamFilter&) const = default;
};

/// Whether a message is latched.
using robotlink::isLatched;

}  // namespace logplayer
