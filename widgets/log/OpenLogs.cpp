// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/OpenLogs.h"

#include <QUndoCommand>
#include <algorithm>

#include "logplayer/base/RobotNames.h"
#include "widgets/log/LogReader.h"

namespace widgets {

using robotlink::Duration;
using robotlink::Instant;

namespace {

constexpr int kSaveAfterTicks = 60;
constexpr std::size_t kMaxThumbnails = 600;  // about 25 kB each

/// A change of a log's bookmarks. The bookmarks keep their own history; this is the change's place among
/// those of other logs on the undo stack.
class BookmarkCommand final : public QUndoCommand {
 public:
  BookmarkCommand(const QString& text, std::function<logplayer::Bookmarks*()> document,
                  std::function<void(logplayer::Bookmarks&)> change)
      : QUndoCommand(text), document_(std::move(document)), change_(std::move(change)) {}

  void undo() override {
    if (auto* document = document_()) document->undo();
  }
  void redo() override {
    auto* document = document_();
    if (document == nullptr) return;
    done_ ? document->redo() : change_(*document);
    done_ = true;
  }

 private:
  std::function<logplayer::Bookmarks*()> document_;
  std::function<void(logplayer::Bookmarks&)> change_;
  bool done_ = false;
};

}  // namespace

OpenLogs::OpenLogs(robotlink::Session& session, ReadLog read, QObject* parent)
    : QObject(parent), read_(std::move(read)), replay_(session) {
  connect(&replay_, &ReplayControl::refused, this, &OpenLogs::failed);
  connect(&undo_, &QUndoStack::indexChanged, this, [this] { ++version_; });
}

OpenLogs::~OpenLogs() {
  saveBookmarks();
}

OpenLogs::Log* OpenLogs::find(const std::string& path) {
  const auto found =
      std::find_if(logs_.begin(), logs_.end(), [&](const auto& log) { return log->path == path; });
  return found == logs_.end() ? nullptr : found->get();
}

OpenLogs::Log* OpenLogs::at(Instant time) {
  for (const auto& log : logs_) {
    const auto& overview = *log->overview;
    if (time >= overview.begin + log->offset && time <= overview.end + log->offset) return log.get();
  }
  return logs_.empty() ? nullptr : logs_.front().get();
}

std::string OpenLogs::sessionPath(const Log& log, const std::string& stream) {
  return logplayer::renamedStream(stream, log.overview->robots, log.robots);
}

void OpenLogs::tick() {
  replay_.refresh();
  followLogs();
  for (const auto& log : logs_) {
    takeNews(*log);
    if (!log->bookmarks || !log->bookmarks->changed() || log->saveFailed) {
      log->ticksUnsaved = 0;
    } else if (++log->ticksUnsaved >= kSaveAfterTicks) {
      save(*log);
    }
  }
}

void OpenLogs::followLogs() {
  const auto& reported = replay_.status().logs();
  const auto isListed = [&](const auto& log) {
    return std::any_of(reported.begin(), reported.end(),
                       [&](const auto& entry) { return entry.path() == log->path; });
  };
  if (!std::all_of(logs_.begin(), logs_.end(), isListed)) {
    saveBookmarks();
    undo_.clear();
    std::erase_if(logs_, [&](const auto& log) { return !isListed(log); });
    replay_.setSteppedStream({});
    ++version_;
    Q_EMIT logsChanged();
  }
  for (const auto& entry : reported) {
    Log* log = find(entry.path());
    const Duration offset(entry.offset());
    const std::vector<std::string> robots(entry.robots().begin(), entry.robots().end());
    if (log != nullptr) {
      if (log->offset != offset || log->robots != robots) ++version_;
      log->offset = offset;
      log->robots = robots;
      continue;
    }
    auto opened = std::make_unique<Log>();
    opened->path = entry.path();
    opened->offset = offset;
    opened->robots = robots;
    opened->reading = read_(entry.path());
    opened->overview = opened->reading->overview();
    chooseDefaults(*opened);
    logs_.push_back(std::move(opened));
    ++version_;
    Q_EMIT logsChanged();
  }
}

void OpenLogs::takeNews(Log& log) {
  auto overview = log.reading->overview();
  if (overview != log.overview) {
    log.overview = std::move(overview);
    ++version_;
    chooseDefaults(log);
  }
  for (LogThumbnail& thumbnail : log.reading->takeThumbnails())
    log.thumbnails[thumbnail.time] = std::move(thumbnail.image);
  auto bookmarks = log.reading->takeBookmarks();
  if (!bookmarks) return;
  if (*bookmarks) {
    log.bookmarks.emplace(std::move(**bookmarks));
    ++version_;
    const auto& problem = log.bookmarks->problem();
    if (problem) Q_EMIT failed(QString::fromStdString(problem->describe()));
    addAsked(log);
  } else {
    Q_EMIT failed(
        tr("The bookmarks cannot be used: %1").arg(QString::fromStdString(bookmarks->error().describe())));
  }
}

void OpenLogs::chooseDefaults(Log& log) {
  const auto images = log.overview->imageStreams();
  if (images.empty()) return;
  if (log.imageStream.empty()) log.imageStream = images.front();
  if (replay_.steppedStream().empty()) replay_.setSteppedStream(sessionPath(log, images.front()));
}

void OpenLogs::changeBookmarks(Log& log, const QString& what,
                               std::function<void(logplayer::Bookmarks&)> change) {
  if (!log.bookmarks) return;
  const auto document = [this, path = log.path]() -> logplayer::Bookmarks* {
    Log* found = find(path);
    return found != nullptr && found->bookmarks ? &*found->bookmarks : nullptr;
  };
  undo_.push(new BookmarkCommand(what, document, std::move(change)));
  log.ticksUnsaved = 0;
  log.saveFailed = false;
}

std::uint64_t OpenLogs::addBookmark(Log& log, Instant from, Instant to, const QString& text) {
  std::uint64_t id = 0;
  changeBookmarks(log, tr("add a bookmark"),
                  [&id, from, to, words = text.toStdString()](logplayer::Bookmarks& bookmarks) {
                    id = bookmarks.add(from, to, words);
                  });
  return id;
}

bool OpenLogs::addBookmarkAt(Instant time, const QString& text) {
  Log* log = at(time);
  if (log == nullptr) return false;
  log->toBookmark.emplace_back(time - log->offset, text);
  addAsked(*log);
  return true;
}

void OpenLogs::addAsked(Log& log) {
  if (!log.bookmarks) return;
  for (const auto& [time, text] : std::exchange(log.toBookmark, {})) {
    addBookmark(log, time, time,
                text.isEmpty() ? tr("Bookmark %1").arg(log.bookmarks->all().size() + 1) : text);
  }
}

void OpenLogs::changeBookmark(Log& log, const logplayer::Bookmark& bookmark) {
  changeBookmarks(log, tr("change a bookmark"),
                  [bookmark](logplayer::Bookmarks& bookmarks) { bookmarks.change(bookmark); });
}

void OpenLogs::removeBookmark(Log& log, std::uint64_t id) {
  changeBookmarks(log, tr("remove a bookmark"),
                  [id](logplayer::Bookmarks& bookmarks) { bookmarks.remove(id); });
}

void OpenLogs::save(Log& log) {
  log.ticksUnsaved = 0;
  const auto saved = log.bookmarks->save();
  log.saveFailed = !saved;
  if (!saved)
    Q_EMIT failed(
        tr("The bookmarks were not saved: %1").arg(QString::fromStdString(saved.error().describe())));
}

void OpenLogs::saveBookmarks() {
  for (const auto& log : logs_) {
    if (log->bookmarks && log->bookmarks->changed()) save(*log);
  }
}

void OpenLogs::setHidden(Log& log, const std::string& stream, bool hidden) {
  hidden ? static_cast<void>(log.hidden.insert(stream)) : static_cast<void>(log.hidden.erase(stream));
  ++version_;
}

void OpenLogs::setCollapsed(Log& log, bool collapsed) {
  log.collapsed = collapsed;
  ++version_;
}

void OpenLogs::setImageStream(Log& log, const std::string& stream) {
  if (log.imageStream == stream) return;
  log.imageStream = stream;
  log.thumbnails.clear();
  log.reading->wantThumbnails(stream, {}, 1);  // drops those of the other stream that are on their way
  ++version_;
}

void OpenLogs::wantThumbnails(Log& log, std::vector<Instant> times, int height) {
  if (log.thumbnails.size() > kMaxThumbnails) log.thumbnails.clear();
  log.reading->wantThumbnails(log.imageStream, std::move(times), height);
}

OpenLogs& openLogs(ViewContext& context) {
  if (context.logs == nullptr) context.logs = std::make_shared<OpenLogs>(context.session, readLogFile);
  return *context.logs;
}

}  // namespace widgets
