// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace logplayer {

struct Bookmark {
  std::uint64_t id = 0;  ///< unique in its file, never used again
  robotlink::Instant from, to;  ///< equal for a moment; times of the log, without any offset
  std::string text;
  bool operator==(const Bookmark&) const = default;
};

/// The bookmarks of a log file: messages foxglove.Event on the channel "bookmarks", of which the last with an id counts. A
/// document with unlimited undo and redo. save() appends what changed to the file without rewriting it, or, if that is
/// read-only or of an older format, writes FILE.bookmarks.json beside it, which open() reads, too. One thread.
class Bookmarks {
 public:
  static robotlink::Result<Bookmarks> open(const std::filesystem::path& file);

  /// By time.
  const std::vector<Bookmark>& all() const { return bookmarks_; }
  std::uint64_t add(robotlink::Instant from, robotlink::Instant to, const std::string& text);
  void change(const Bookmark& bookmark);
  void remove(std::uint64_t id);

  bool canUndo() const { return position_ > 0; }
  bool canRedo() const { return position_ < history_.size(); }
  void undo();
  void redo();

  bool changed() const { return bookmarks_ != saved_; }
  robotlink::Result<void> save();
  /// Where save() writes.
  const std::filesystem::path& savedIn() const { return savedIn_; }

 private:
  Bookmarks() = default;
  void set(std::vector<Bookmark> bookmarks);

  std::filesystem::path file_, savedIn_;
  std::vector<Bookmark> bookmarks_, saved_;
  std::vector<std::vector<Bookmark>> history_;  // states before each change
  std::size_t position_ = 0;
  std::uint64_t nextId_ = 1;
};

}  // namespace logplayer
