// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/StreamFilter.h"

#include <algorithm>

namespace logplayer {

bool fits(std::string_view path, std::string_view pattern) {
  // A greedy match with a single point for backtracking: the last "*" and the length of the text that it
  // matched.
  std::size_t at = 0, next = 0;
  std::size_t star = std::string_view::npos, taken = 0;
  while (at < path.size()) {
    if (next < pattern.size() && pattern[next] == '*') {
      star = next++;
      taken = at;
    } else if (next < pattern.size() && pattern[next] == path[at]) {
      ++next;
      ++at;
    } else if (star != std::string_view::npos) {
      next = star + 1;
      at = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', next) == std::string_view::npos;
}

bool StreamFilter::has(std::string_view path) const {
  const auto fitsPath = [path](const std::string& pattern) { return fits(path, pattern); };
  return (include.empty() || std::any_of(include.begin(), include.end(), fitsPath)) &&
         std::none_of(exclude.begin(), exclude.end(), fitsPath);
}

}  // namespace logplayer
