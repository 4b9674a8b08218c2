// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace logplayer {

struct Bookmark {
  std::uint64_t id = 0;         ///< random, below 2^53: unique in all files, so that files can be merged
  robotlink::Instant from, to;  ///< equal for a moment; times of the log, without any offset
  std::string text;
  bool operator==(const Bookmark&) const = default;
};

/// What became of bookmarks by their ids; nothing: removed.
using BookmarkChanges = std::map<std::uint64_t, std::optional<Bookmark>>;

/// The bookmarks of a log file: messages foxglove.Event on the channel "bookmarks", of which the last with an
/// id counts. A document with unlimited undo and redo. One thread.
///
/// save() appends what changed to the file without rewriting it. If that cannot be (the file is read-only,
/// lacks its summary, is being written, or is of an older format) it writes FILE.bookmarks.json beside it,
/// which open() reads, too, and which counts more. What somebody else saved meanwhile is kept, and taken
/// over; of a bookmark that both changed the one saved last counts.
class Bookmarks {
 public:
  /// Fails if the log cannot be read, or given up by `progress`, which is told the share done in [0, 1].
  static robotlink::Result<Bookmarks> open(const std::filesystem::path& file,
                                           const std::function<bool(double)>& progress = {});

  /// Sorted by time.
  const std::vector<Bookmark>& all() const { return history_[position_]; }
  /// Null if there is none.
  const Bookmark* find(std::uint64_t id) const;
  /// The id of the new one. Ends in the wrong order are exchanged.
  std::uint64_t add(robotlink::Instant from, robotlink::Instant to, const std::string& text);
  /// Nothing happens if there is none with its id.
  void change(const Bookmark& bookmark);
  void remove(std::uint64_t id);

  bool canUndo() const { return position_ > 0; }
  bool canRedo() const { return position_ + 1 < history_.size(); }
  void undo();
  void redo();

  bool changed() const { return all() != saved_; }
  /// All there is stays changed if it fails. May be undone, and saved again.
  robotlink::Result<void> save();
  /// Where save() writes, or wrote last.
  const std::filesystem::path& savedIn() const { return savedIn_; }
  /// What is wrong with the file beside the log; the bookmarks in the log are there nevertheless.
  const std::optional<robotlink::Error>& problem() const { return problem_; }

 private:
  Bookmarks() = default;
  void set(std::vector<Bookmark> bookmarks);
  void takeOver(const BookmarkChanges& changes);

  std::filesystem::path file_, savedIn_;
  std::vector<Bookmark> saved_;
  std::vector<std::vector<Bookmark>> history_{{}};  // all states in order; never empty
  std::size_t position_ = 0;                        // of the one that holds
  std::optional<robotlink::Error> problem_;
};

}  // namespace logplayer
