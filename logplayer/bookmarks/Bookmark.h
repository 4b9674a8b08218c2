// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "robotlink/base/Clock.h"

namespace logplayer {

/// A named instant or range of a log. A plain value.
struct Bookmark {
  /// Random, below 2^53 (exact in JSON), and thus unique in all files, so that files can be merged.
  std::uint64_t id = 0;
  /// Log times without any offset; equal for an instant.
  robotlink::Instant from, to;
  std::string text;
  bool operator==(const Bookmark&) const = default;
};

/// Changes by the ids of bookmarks; an empty value removes the bookmark.
using BookmarkChanges = std::map<std::uint64_t, std::optional<Bookmark>>;

}  // namespace logplayer
