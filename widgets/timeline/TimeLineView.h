// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "widgets/View.h"
#include "widgets/log/LogJob.h"
#include "widgets/log/OpenLogs.h"

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
/// that can be played in a loop, cut into a new log or exported. Long operations run as a LogJob with
/// progress and cancel. TimeLineJobs.cpp defines what starts them.
///
/// Registered as "time-line". GUI thread.
class TimeLineView final : public View {
  Q_OBJECT
 public:
  explicit TimeLineView(ViewContext& context, QWidget* parent = nullptr);
  /// Shows the logs, the play head and the progress of a job.
  void tick() override;

 protected:
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
  /// Passes the logs to the canvas.
  void showBands();
  std::vector<TimeLineBand> historyBands() const;
  void showHistory();
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
  void exportImages();
  void exportTable();
  void exportTexts();
  /// Starts the repair of a log (its path).
  void repair(const QString& log);
  /// The range in a log's own times; unset: none.
  std::optional<std::pair<robotlink::Instant, robotlink::Instant>> rangeOf(const OpenLogs::Log& log) const;
  /// Suggested name of an output file beside the log.
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
  TimeLineCanvas* canvas_ = nullptr;
  EmptyHint* hint_ = nullptr;
  LogJobBar* job_ = nullptr;
  LogDamageBar* damage_ = nullptr;
  QComboBox* images_ = nullptr;
  QLabel* range_ = nullptr;
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
  /// OpenLogs::version() of what is shown.
  std::uint64_t shownVersion_ = 0;
};

}  // namespace widgets
