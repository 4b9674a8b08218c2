// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "logplayer/bookmarks/Bookmark.h"
#include "logplayer/mcap/read/Reader.h"
#include "logplayer/mcap/write/Writer.h"
#include "robotlink/base/Error.h"

namespace logplayer {

// How bookmarks are stored in files; the formats are described in logplayer/LOGS.md.

/// Reads the channel "bookmarks" of a log; the last message of each id counts. Events of other programs have
/// no id and get one that is derived from their contents.
BookmarkChanges readBookmarks(mcap::Reader& log);
/// Writes one message per change, which replaces or removes the bookmark of that id.
robotlink::Result<void> writeBookmarks(mcap::Writer& log, const BookmarkChanges& changes);

/// The path of the file beside a log: FILE.bookmarks.json.
std::filesystem::path fileBeside(const std::filesystem::path& log);
/// Empty if there is no such file; fails if it cannot be read or understood.
robotlink::Result<BookmarkChanges> readBookmarksBeside(const std::filesystem::path& log);
/// Replaces the file atomically; removes it if there are no changes.
robotlink::Result<void> writeBookmarksBeside(const std::filesystem::path& log,
                                             const BookmarkChanges& changes);

/// All bookmarks that are stored for a log, in the log itself and in the file beside it.
struct StoredBookmarks {
  BookmarkChanges inLog;
  /// These take precedence over those in the log.
  BookmarkChanges beside;
  /// Whether bookmarks can be appended to the log.
  bool canAppend = false;
  /// The problem with the file beside the log, if there is one.
  std::optional<robotlink::Error> problem;

  /// Sorted by time.
  std::vector<Bookmark> bookmarks() const;
};
/// Fails if the log cannot be read, or with "log.given-up" if `progress` returns false.
robotlink::Result<StoredBookmarks> readStoredBookmarks(const std::filesystem::path& log,
                                                       const std::function<bool(double)>& progress);
/// The same for a log that is already open, since an incomplete log takes long to open. `open` is null for a
/// log of an older format, which contains no bookmarks.
robotlink::Result<StoredBookmarks> storedBookmarksOf(const std::filesystem::path& log, mcap::Reader* open);

/// The changes that turn `from` into `to`.
BookmarkChanges difference(const std::vector<Bookmark>& from, const std::vector<Bookmark>& to);
/// Returns the changed bookmarks, sorted by time.
std::vector<Bookmark> changed(const std::vector<Bookmark>& bookmarks, const BookmarkChanges& changes);

}  // namespace logplayer
