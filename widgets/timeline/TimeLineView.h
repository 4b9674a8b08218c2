// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "robotlink/commands/CommandTable.h"
#include "widgets/HiddenTick.h"
#include "widgets/View.h"
#include "widgets/log/LogJobs.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/log/ReplayKeys.h"
#include "widgets/timeline/HistoryStrips.h"
#include "widgets/timeline/TimeLineTracks.h"

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace widgets {

class EmptyHint;
class LogDamageBar;
class LogJobBar;
class TimeLineCanvas;
struct TimeLineBand;

/// The replay's logs over time: images, messages, warnings and errors, bookmarks, the play head, and a range
/// that can be played in a loop, cut into a new log or exported. Without a log, what is kept of live robots,
/// to look back while they continue. Long operations run as a LogJob with
/// progress and cancel. TimeLineJobs.cpp defines what starts them.
///
/// Registered as "time-line". GUI thread.
class TimeLineView final : public View, public HiddenTick {
  Q_OBJECT
 public:
  explicit TimeLineView(ViewContext& context, QWidget* parent = nullptr);
  /// Shows the logs, the play head and the progress of a job.
  void tick() override;
  void tickHidden() override;
  /// The data shown of all logs and robots: bookmarks, warnings and errors, and the curves' points in sight.
  std::optional<QString> numbers() override;
  /// Shows a value as a curve: "red1/models/ball: position.x".
  robotlink::Result<void> addTrack(const QString& source) { return tracks_.add(source); }
  /// False: there is no such curve.
  bool removeTrack(const QString& source);
  QStringList tracks() const { return tracks_.sources(); }

 protected:
  /// Shows the newest extent at once.
  void showEvent(QShowEvent* event) override;
  /// Handles the keys of the replay, see ReplayKey.
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void createActions();
  /// Loop, cut, export and clear.
  void createRangeActions();
  void createViews();
  /// The tool row.
  QWidget* createBar();
  void connectSignals();
  /// Connects the canvas's signals about bookmarks with the logs.
  void connectBookmarks();
  /// The log of a band; null: there is none.
  OpenLogs::Log* logAt(int band);
  /// Sets the shape of a band's images to that of its thumbnails.
  static void setImageAspect(TimeLineBand& band);
  /// Passes the logs to the canvas.
  void showBands();

  // TimeLineHistory.cpp: live robots, to look back while they continue.
  /// Whether there are robots, and no log.
  bool hasHistory() const;
  void createHistoryActions();
  /// A band for each robot, with what is kept of its messages.
  std::vector<TimeLineBand> historyBands();
  /// Passes the extent of the history to the canvas.
  void showHistory();
  void showHistoryActions();
  void pressInHistory(ReplayKey key, QKeyEvent& event);
  void fillHistoryMenu(QMenu& menu);
  /// Adds the entry that removes the curve at a point of the canvas.
  void addTrackEntry(QMenu& menu, const QPoint& at);
  /// Entries that begin and end the range at the shown instant.
  void addRangeEnds(QMenu& menu);
  /// Asks how much is to be kept.
  void askForLimits();
  /// Runs a command; a failure is shown.
  void run(const char* command, const std::vector<robotlink::CommandTable::Value>& arguments = {});

  // TimeLineMarks.cpp: marks, and steps to changes.
  /// The field for the value whose changes are stepped, and its actions.
  void createSteps();
  /// Shows the next or the previous instant at which that value changes.
  void stepChange(const char* direction);
  /// Passes texts and hits to the canvas.
  void showMarks();

  /// Passes the range to the canvas and enables its actions.
  void showRange();
  /// Fills the combo box of the streams of images.
  void showImageStreams();
  /// Passes damage reports to the bar.
  void showDamage();
  /// Requests the thumbnails that the canvas misses.
  void wantThumbnails();
  /// Makes a stream the one whose messages are stepped.
  void chooseStream(int band, const std::string& path);
  /// Marks that stream in the canvas.
  void showSteppedStream();
  void addBookmark(int band, robotlink::Instant time);
  /// Plays the range in a loop.
  void loopRange();
  /// Asks for files and starts the jobs.
  void cut();
  /// The same for some streams, which the user selects first; without a range of all of the logs.
  void cutStreams();
  /// Asks for the file of a new log, and writes it.
  void writeCut(const LogRange& range, const logplayer::StreamFilter& streams);
  void exportImages();
  void exportTable();
  void exportTexts();
  /// Aligns two logs by an event that is in both: it is marked in one, and found again in the other.
  void addAligning(QMenu& menu, int band, robotlink::Instant time);
  /// Starts the repair of a log (its path).
  void repair(const QString& log);
  /// The range in a log's own times; unset: none.
  std::optional<std::pair<robotlink::Instant, robotlink::Instant>> rangeOf(const OpenLogs::Log& log) const;
  /// Suggested name of an output file in the folder of the log.
  QString suggested(const OpenLogs::Log& log, const QString& suffix) const;
  /// A dialog for an output file.
  struct FileQuestion {
    const char* name;
    QString title, suggestion, filter;
    /// Whether it asks for a folder instead of a file.
    bool folder = false;
  };
  /// Opens the dialog; `chosen` is called unless it is canceled.
  void askForFile(const FileQuestion& question, std::function<void(const QString&)> chosen);

  OpenLogs& logs_;
  TimeLineTracks tracks_;
  HistoryStrips strips_;
  TimeLineCanvas* canvas_ = nullptr;
  EmptyHint* hint_ = nullptr;
  LogJobBar* job_ = nullptr;
  LogDamageBar* damage_ = nullptr;
  QComboBox* images_ = nullptr;
  QComboBox* stepBy_ = nullptr;
  QAction* changeBack_ = nullptr;
  QAction* changeOn_ = nullptr;
  /// TimeMarks::version() of what is marked.
  std::uint64_t marksVersion_ = 0;
  QLabel* range_ = nullptr;
  /// An event of a log (its path), in the log's own time, by which another one is aligned.
  std::optional<std::pair<std::string, robotlink::Instant>> marked_;
  QAction* pause_ = nullptr;
  QAction* back_ = nullptr;
  QAction* on_ = nullptr;
  QAction* live_ = nullptr;
  /// The buttons of these, hidden while a log is open.
  std::vector<QToolButton*> history_;
  /// The earliest instant of the session, by its restarts; what was dropped since is shown as such.
  std::pair<std::uint64_t, robotlink::Instant> earliest_{~std::uint64_t{0}, {}};
  int ticks_ = 0;
  /// Whether it was not ticked before: what the history dropped meanwhile is read again.
  bool isShownAnew_ = false;
  QAction* bookmark_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QAction* zoomIn_ = nullptr;
  QAction* zoomOut_ = nullptr;
  QAction* fit_ = nullptr;
  QAction* follow_ = nullptr;
  QAction* loop_ = nullptr;
  QAction* cut_ = nullptr;
  QAction* export_ = nullptr;
  QAction* clear_ = nullptr;
  QMenu* exportMenu_ = nullptr;
  /// Exports that read a log.
  std::vector<QAction*> logExports_;
  /// OpenLogs::version() of what is shown.
  std::uint64_t shownVersion_ = 0;
};

}  // namespace widgets
