// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "logplayer/Bookmarks.h"
#include "logplayer/mcap/Reader.h"
#include "logplayer/mcap/Writer.h"
#include "robotlink/base/Error.h"

namespace logplayer {

// How bookmarks lie in files; see logplayer/LOGS.md.

/// What the channel "bookmarks" of a log says last of each id. Events of other programs, which have no id,
/// get one that is made of what they say.
BookmarkChanges readBookmarks(mcap::Reader& log);
robotlink::Result<void> writeBookmarks(mcap::Writer& log, const BookmarkChanges& changes);

/// FILE.bookmarks.json.
std::filesystem::path fileBeside(const std::filesystem::path& log);
/// Nothing if there is no such file.
robotlink::Result<BookmarkChanges> readBookmarksBeside(const std::filesystem::path& log);
/// Written as a whole or not at all; removed if there is nothing to say.
robotlink::Result<void> writeBookmarksBeside(const std::filesystem::path& log,
                                             const BookmarkChanges& changes);

/// All that is stored of a log's bookmarks.
struct StoredBookmarks {
  BookmarkChanges inLog;
  BookmarkChanges beside;                   ///< these count more
  bool canAppend = false;                   ///< to the log
  std::optional<robotlink::Error> problem;  ///< with the file beside the log

  /// Sorted by time.
  std::vector<Bookmark> bookmarks() const;
};
robotlink::Result<StoredBookmarks> readStoredBookmarks(const std::filesystem::path& log,
                                                       const std::function<bool(double)>& progress);
/// The same for a log that is open already, as an unfinished one takes long to open. Null: it is of an older
/// format, which holds none.
robotlink::Result<StoredBookmarks> storedBookmarksOf(const std::filesystem::path& log, mcap::Reader* open);

/// What must be said to those who know `from`, so that they know `to`.
BookmarkChanges difference(const std::vector<Bookmark>& from, const std::vector<Bookmark>& to);
/// Returns the changed bookmarks, sorted by time.
std::vector<Bookmark> changed(const std::vector<Bookmark>& bookmarks, const BookmarkChanges& changes);

}  // namespace logplayer
