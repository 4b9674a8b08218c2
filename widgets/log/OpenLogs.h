// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QUndoStack>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "logplayer/bookmarks/Bookmarks.h"
#include "logplayer/search/Computation.h"
#include "widgets/View.h"
#include "widgets/log/LogOverview.h"
#include "widgets/log/ReplayControl.h"

namespace widgets {

/// The open logs of the replay, shared by all views of a window: their contents, their bookmarks with undo
/// and redo, and the options of their display. Follows the replay's status. Bookmarks are saved two seconds
/// after a change, when their log is closed, and at the end.
///
/// tick() is called once per tick, after the session's. GUI thread; the session must outlive it.
class OpenLogs final : public QObject {
  Q_OBJECT
 public:
  /// An open log.
  struct Log {
    /// Path of the file; identifies the log.
    std::string path;
    /// Added to the log's times to get times of the timeline.
    robotlink::Duration offset{0};
    /// Names of the log's robots in the replay, in the order of LogOverview::robots; equal names of several
    /// logs get "-2", "-3".
    std::vector<std::string> robots;
    /// Never null.
    std::shared_ptr<const LogOverview> overview;
    /// Unset until they are read.
    std::optional<logplayer::Bookmarks> bookmarks;
    /// Bookmarks that were added before the others were read, in the log's own times.
    std::vector<std::pair<robotlink::Instant, QString>> toBookmark;
    /// Stream whose thumbnails are shown; empty: none.
    std::string imageStream;
    /// Keyed by the times for which they were requested.
    std::map<robotlink::Instant, QImage> thumbnails;
    /// Paths of streams without a row in the timeline.
    std::set<std::string> hidden;
    /// Whether the timeline hides the log's streams.
    bool collapsed = false;
    /// Reads the log; never null.
    std::unique_ptr<LogReading> reading;
    /// Ticks since the last change of the bookmarks.
    int ticksUnsaved = 0;
    /// Whether saving has failed since the last change; it is not repeated then.
    bool saveFailed = false;
  };

  /// `read` opens a log for reading; tests replace it.
  OpenLogs(robotlink::Session& session, ReadLog read, QObject* parent = nullptr);
  ~OpenLogs() override;

  /// Follows the replay, takes what was read, and saves bookmarks.
  void tick();
  /// Returns how searches compute what the logs lack; empty, as at first: not at all. Called in any thread.
  const logplayer::MakeComputation& computation() const { return computation_; }
  void setComputation(logplayer::MakeComputation make) { computation_ = std::move(make); }
  /// The control of the replay, which all views share.
  ReplayControl& replay() { return replay_; }
  /// Changes of the bookmarks of all logs; cleared when a log is closed.
  QUndoStack& undoStack() { return undo_; }
  const std::vector<std::unique_ptr<Log>>& logs() const { return logs_; }
  /// Null if it is not open.
  Log* find(const std::string& path);
  /// The log that contains a time of the timeline, else the first; null without any.
  Log* at(robotlink::Instant time);
  /// The log at the play head.
  Log* current() { return at(replay_.shown()); }
  /// Path of a log's stream in the replay: "nao-2/camera/image".
  static std::string sessionPath(const Log& log, const std::string& stream);
  /// Grows with every change of logs, overviews, bookmarks or options, but not of thumbnails.
  std::uint64_t version() const { return version_; }

  /// Adds a bookmark and returns its id; 0 if the bookmarks are not read yet. Times are the log's own. All
  /// changes of bookmarks can be undone.
  std::uint64_t addBookmark(Log& log, robotlink::Instant from, robotlink::Instant to, const QString& text);
  /// Adds a bookmark at a time of the timeline, in the log that contains it, as soon as its bookmarks are
  /// read. An empty text gives "Bookmark 3". False: no log is open.
  bool addBookmarkAt(robotlink::Instant time, const QString& text);
  bool addBookmarkHere() { return addBookmarkAt(replay_.shown(), {}); }
  /// Replaces the bookmark with the same id.
  void changeBookmark(Log& log, const logplayer::Bookmark& bookmark);
  void removeBookmark(Log& log, std::uint64_t id);
  /// Writes unsaved bookmarks; emits failed() if that fails.
  void saveBookmarks();

  void setHidden(Log& log, const std::string& stream, bool hidden);
  void setCollapsed(Log& log, bool collapsed);
  void setImageStream(Log& log, const std::string& stream);
  /// Requests thumbnails of the log's imageStream; times are the log's own, `height` in pixels.
  void wantThumbnails(Log& log, std::vector<robotlink::Instant> times, int height);

 Q_SIGNALS:
  /// Something could not be done: what, and why.
  void failed(const QString& reason);
  /// A log was opened or closed.
  void logsChanged();

 private:
  /// Opens and closes logs as the replay reports them.
  void followLogs();
  /// Takes overview, thumbnails and bookmarks that were read.
  void takeNews(Log& log);
  /// Chooses the streams of images and of stepping, if none is chosen.
  void chooseDefaults(Log& log);
  /// Makes a change of the bookmarks as a step of the undo stack.
  void changeBookmarks(Log& log, const QString& what, std::function<void(logplayer::Bookmarks&)> change);
  /// Adds the bookmarks that waited for the others to be read.
  void addAsked(Log& log);
  void save(Log& log);

  ReadLog read_;
  logplayer::MakeComputation computation_;
  ReplayControl replay_;
  QUndoStack undo_;
  std::vector<std::unique_ptr<Log>> logs_;
  std::uint64_t version_ = 1;
};

/// The logs of a window, created on the first call.
OpenLogs& openLogs(ViewContext& context);

}  // namespace widgets
