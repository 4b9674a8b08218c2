// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "logplayer/bookmarks/Bookmark.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace logplayer {

/// The bookmarks of a log file: messages of type foxglove.Event on the channel "bookmarks", of which the last
/// one with an id is valid. An editable document with unlimited undo and redo. One thread.
///
/// save() appends the changes to the log without rewriting it. If that is impossible (the file is read-only,
/// lacks its summary, is being written, or has an older format), save() writes FILE.bookmarks.json beside it
/// instead; open() reads both, and the file beside the log takes precedence. Changes that another program
/// saved in the meantime are merged; if both changed the same bookmark, the one that saves last wins.
class Bookmarks {
 public:
  /// Fails if the log cannot be read, or with "log.given-up" if `progress`, called with the share done in [0,
  /// 1], returns false.
  static robotlink::Result<Bookmarks> open(const std::filesystem::path& file,
                                           const std::function<bool(double)>& progress = {});

  /// Sorted by time.
  const std::vector<Bookmark>& all() const { return history_[position_]; }
  /// Null if there is none. Valid until the next change.
  const Bookmark* find(std::uint64_t id) const;
  /// Adds a bookmark and returns its id. The ends may be in any order.
  std::uint64_t add(robotlink::Instant from, robotlink::Instant to, const std::string& text);
  /// Replaces the bookmark with the same id; ignored if there is none.
  void change(const Bookmark& bookmark);
  void remove(std::uint64_t id);

  /// Whether undo() or redo() has an effect.
  bool canUndo() const { return position_ > 0; }
  bool canRedo() const { return position_ + 1 < history_.size(); }
  void undo();
  void redo();

  /// Whether there are unsaved changes.
  bool changed() const { return all() != saved_; }
  /// Writes the changes; if that fails, they remain unsaved. A saved change can still be undone, and saved
  /// again.
  robotlink::Result<void> save();
  /// The file to which save() writes, or wrote last: the log, or the file beside it.
  const std::filesystem::path& savedIn() const { return savedIn_; }
  /// The problem with the file beside the log; the bookmarks in the log are available nevertheless.
  const std::optional<robotlink::Error>& problem() const { return problem_; }

 private:
  Bookmarks() = default;
  /// Adds a state to the history, discarding those that were undone.
  void set(std::vector<Bookmark> bookmarks);
  /// Merges changes of other programs into all states of the history, so that undo() does not revert them.
  void takeOver(const BookmarkChanges& changes);

  std::filesystem::path file_, savedIn_;
  /// The state of the last save; the base for difference().
  std::vector<Bookmark> saved_;
  /// All states in order; never empty.
  std::vector<std::vector<Bookmark>> history_{{}};
  /// Index of the current state.
  std::size_t position_ = 0;
  std::optional<robotlink::Error> problem_;
};

}  // namespace logplayer
