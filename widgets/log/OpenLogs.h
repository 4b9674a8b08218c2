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

#include "logplayer/Bookmarks.h"
#include "widgets/View.h"
#include "widgets/models/LogOverview.h"
#include "widgets/models/ReplayControl.h"

namespace widgets {

/// The logs of the replay, as all views of a window share them: what they hold, their bookmarks with undo and
/// redo, and what is shown of them. Follows what the replay says of its logs. Bookmarks are saved two seconds
/// after a change, when their log is closed, and at the end.
///
/// tick() is called once a tick, after the session's. GUI thread; the session must outlive it.
class OpenLogs final : public QObject {
  Q_OBJECT
 public:
  struct Log {
    std::string path;
    robotlink::Duration offset{0};    ///< added to its times
    std::vector<std::string> robots;  ///< as the replay calls them: where names are equal they get "-2", "-3"
    std::shared_ptr<const LogOverview> overview;
    std::optional<logplayer::Bookmarks> bookmarks;
    std::vector<std::pair<robotlink::Instant, QString>> toBookmark;  ///< was asked for before they were read
    std::string imageStream;                                         ///< whose images are shown; empty: none
    std::map<robotlink::Instant, QImage> thumbnails;
    std::set<std::string> hidden;  ///< streams without a row in the time line
    bool collapsed = false;
    std::unique_ptr<LogReading> reading;
    int ticksUnsaved = 0;
    bool saveFailed = false;  ///< since the last change; it was told
  };

  OpenLogs(robotlink::Session& session, ReadLog read, QObject* parent = nullptr);
  ~OpenLogs() override;

  void tick();
  ReplayControl& replay() { return replay_; }
  QUndoStack& undoStack() { return undo_; }
  const std::vector<std::unique_ptr<Log>>& logs() const { return logs_; }
  /// A log by its path; null if it is not open.
  Log* find(const std::string& path);
  /// The one that holds a time of the time line, else the first; null without any.
  Log* at(robotlink::Instant time);
  /// That of what is shown now.
  Log* current() { return at(replay_.shown()); }
  /// What the replay calls a stream of a log: "nao-2/camera/image".
  static std::string toldAs(const Log& log, const std::string& stream);
  /// Grows with every change of anything of this but thumbnails.
  std::uint64_t version() const { return version_; }

  /// All of them can be undone. Their times are the log's own.
  std::uint64_t addBookmark(Log& log, robotlink::Instant from, robotlink::Instant to, const QString& text);
  /// At a time of the time line, in the log that holds it; later, if its bookmarks are not yet read. An empty
  /// text: "Bookmark 3". False: no log is open.
  bool addBookmarkAt(robotlink::Instant time, const QString& text);
  bool addBookmarkHere() { return addBookmarkAt(replay_.shown(), {}); }
  void changeBookmark(Log& log, const logplayer::Bookmark& bookmark);
  void removeBookmark(Log& log, std::uint64_t id);
  /// Writes what was not yet saved; tells failed() where that does not work.
  void saveBookmarks();

  void setHidden(Log& log, const std::string& stream, bool hidden);
  void setCollapsed(Log& log, bool collapsed);
  void setImageStream(Log& log, const std::string& stream);
  void wantThumbnails(Log& log, std::vector<robotlink::Instant> times, int height);

 Q_SIGNALS:
  /// Something could not be done: what, and why.
  void failed(const QString& reason);
  /// Another log is open, or none any more.
  void logsChanged();

 private:
  void followLogs();
  void takeNews(Log& log);
  void chooseDefaults(Log& log);
  void changeBookmarks(Log& log, const QString& what, std::function<void(logplayer::Bookmarks&)> change);
  void addAsked(Log& log);
  void save(Log& log);

  ReadLog read_;
  ReplayControl replay_;
  QUndoStack undo_;
  std::vector<std::unique_ptr<Log>> logs_;
  std::uint64_t version_ = 1;
};

/// Those of a window; made when they are first asked for.
OpenLogs& openLogs(ViewContext& context);

}  // namespace widgets
