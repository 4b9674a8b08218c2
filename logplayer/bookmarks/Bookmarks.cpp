// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bookmarks/Bookmarks.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <random>

#include "logplayer/bookmarks/BookmarkStorage.h"
#include "logplayer/record/LogAppend.h"
#include "robotlink/session/VersionedFile.h"

namespace logplayer {
namespace {

using robotlink::Instant;
using robotlink::Result;

std::uint64_t newId() {
  std::random_device random;
  const std::uint64_t bits = (std::uint64_t{random()} << 32U) | random();
  return std::max<std::uint64_t>(bits >> 11U, 1);
}

/// While it exists, other programs of this project cannot save bookmarks of the same log.
class FileLock {
 public:
  explicit FileLock(const std::filesystem::path& file) : file_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
    held_ = file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) == 0;
  }
  ~FileLock() {
    if (file_ >= 0) ::close(file_);
  }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  bool held() const { return held_; }

 private:
  int file_;
  bool held_;
};

}  // namespace

Result<Bookmarks> Bookmarks::open(const std::filesystem::path& file,
                                  const std::function<bool(double)>& progress) {
  auto stored = readStoredBookmarks(file, progress);
  if (!stored) return tl::unexpected(stored.error());
  Bookmarks result;
  result.file_ = file;
  result.savedIn_ = stored->canAppend ? file : fileBeside(file);
  result.saved_ = stored->bookmarks();
  result.history_ = {result.saved_};
  result.problem_ = std::move(stored->problem);
  return result;
}

const Bookmark* Bookmarks::find(std::uint64_t id) const {
  const auto found = std::find_if(all().begin(), all().end(), [id](const Bookmark& b) { return b.id == id; });
  return found == all().end() ? nullptr : &*found;
}

std::uint64_t Bookmarks::add(Instant from, Instant to, const std::string& text) {
  const std::uint64_t id = newId();
  set(logplayer::changed(all(), {{id, Bookmark{id, std::min(from, to), std::max(from, to), text}}}));
  return id;
}

void Bookmarks::change(const Bookmark& bookmark) {
  if (!find(bookmark.id)) return;
  Bookmark ordered = bookmark;
  if (ordered.to < ordered.from) std::swap(ordered.from, ordered.to);
  set(logplayer::changed(all(), {{bookmark.id, ordered}}));
}

void Bookmarks::remove(std::uint64_t id) {
  set(logplayer::changed(all(), {{id, std::nullopt}}));
}

void Bookmarks::undo() {
  if (canUndo()) --position_;
}

void Bookmarks::redo() {
  if (canRedo()) ++position_;
}

void Bookmarks::set(std::vector<Bookmark> bookmarks) {
  if (bookmarks == all()) return;
  history_.resize(position_ + 1);
  history_.push_back(std::move(bookmarks));
  ++position_;
}

// Changes of other programs are no steps of this document, so that undo() does not revert them. Bookmarks
// that were changed here, too, are left alone.
void Bookmarks::takeOver(const BookmarkChanges& changes) {
  for (const auto& [id, bookmark] : changes) {
    const auto has = [id = id](const std::vector<Bookmark>& state) {
      return std::find_if(state.begin(), state.end(), [id](const Bookmark& b) { return b.id == id; }) !=
             state.end();
    };
    const bool known = std::any_of(history_.begin(), history_.end(), has);
    for (auto& state : history_) {
      if (!known || has(state)) state = logplayer::changed(state, {{id, bookmark}});
    }
  }
}

Result<void> Bookmarks::save() {
  const FileLock lock(file_);
  if (!lock.held()) {
    return robotlink::failure(
        "bookmarks.locked",
        "the bookmarks were not saved: the log is gone, or another program is writing to it; try again",
        {file_.string(), 0, 0});
  }
  auto stored = readStoredBookmarks(file_, {});
  if (!stored) return tl::unexpected(stored.error());
  if (stored->problem) {
    if (stored->problem->id == "settings.newer") return tl::unexpected(*stored->problem);
    stored->problem = robotlink::keepAside(fileBeside(file_), *stored->problem);
  }
  const BookmarkChanges mine = difference(saved_, all());
  BookmarkChanges theirs = difference(saved_, stored->bookmarks());
  for (const auto& [id, bookmark] : mine) theirs.erase(id);
  const auto inLog = logplayer::changed({}, stored->inLog);
  const auto result = logplayer::changed(stored->bookmarks(), mine);
  const BookmarkChanges toLog = difference(inLog, result);

  bool inFile = stored->canAppend;
  if (inFile && !toLog.empty()) {
    const auto write = [&](mcap::Writer& writer) { return writeBookmarks(writer, toLog); };
    inFile = appendToLog(file_, write).has_value();
  }
  if (const auto written = writeBookmarksBeside(file_, inFile ? BookmarkChanges{} : toLog); !written)
    return written;
  savedIn_ = inFile ? file_ : fileBeside(file_);
  problem_ = stored->problem;
  takeOver(theirs);
  saved_ = result;
  return {};
}

}  // namespace logplayer
