// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

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

/// Whether messages of a stream hold until they are told anew (tables, parameters, colour tables, the scene,
/// set-ups of programs), so that the newest of each process belongs at the start of whatever begins later.
/// `type` is the full name of the message's type.
bool holdsUntilToldAnew(std::string_view path, std::string_view type);

}  // namespace logplayer
