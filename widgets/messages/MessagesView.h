// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "robotlink/base/Worker.h"
#include "robotlink/session/HistoryArchive.h"
#include "widgets/HiddenTick.h"
#include "widgets/TypedStreams.h"
#include "widgets/View.h"
#include "widgets/log/LogModel.h"

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace widgets {

class EmptyHint;
class LogFilter;

/// The text messages (foxglove.Log) of all robots in a table, with filters for level, robot and text, a
/// search, follow, pause, clear and copy. While the timeline is paused at an instant, the row of that instant
/// is the current one. If logs are open all their messages are listed, those after the play head muted; a
/// double click jumps to a message's time.
///
/// Registered as "messages". GUI thread.
class MessagesView final : public View, public HiddenTick {
  Q_OBJECT
 public:
  explicit MessagesView(ViewContext& context, QWidget* parent = nullptr);
  /// Appends new messages (unless paused) and moves the current row to the shown instant.
  void tick() override;
  void tickHidden() override;
  /// Sets the filter, as the user does; empty: none. Fails if it is no regular expression, but is to be one.
  robotlink::Result<void> setFilter(const std::string& text, bool isRegex);

 private:
  /// Texts to be read from disk, each stream's within a stretch whose ends are not included.
  struct Reading {
    std::uint64_t generation = 0;
    std::map<std::string, robotlink::Stretch> stretches = {};
    std::vector<robotlink::HistoryArchive::Piece> pieces = {};
  };
  struct Read {
    std::uint64_t generation = 0;
    std::vector<LogEntry> texts = {};
  };
  static Read readTexts(const Reading& reading, const std::stop_token& stop);

  /// Actions of the toolbar, among them regular expression, previous and next match, follow, pause.
  void createActions();
  void createFilters();
  void createViews();
  void connectSignals();
  /// Appends the messages that arrived since the last tick. Starts over when the store was reset or the set
  /// of open logs changed.
  void takeNew();
  /// Has read what the history has on disk of the texts that were not taken, and takes what was read.
  void takeArchived();
  /// Notes that texts of a stream from `from` to `to` are at most on disk, both not included.
  void noteMissed(const std::string& stream, robotlink::Instant from, robotlink::Instant to);
  /// Forgets the texts after a time, listed or about to be.
  void removeLater(robotlink::Instant time, std::vector<LogEntry>& unlisted);
  /// Replaces the table by all messages that the open logs hold, played or not.
  void takeLogs();
  /// Mutes rows after the play head and selects the row of the shown instant.
  void showInstant();
  /// Fills the combo box of robots; it is hidden while there is only one.
  void listRobots();
  /// Passes the filter text to the proxy; shows what is wrong with a regular expression.
  void setPattern();
  /// Selects the next match of the search; `step` is 1 (down), -1 (up) or 0 (from the current row on).
  void find(int step);
  /// Updates the count of messages and the hint of an empty table.
  void showState();
  /// The row with filters, search and buttons.
  QWidget* createBar();

  /// All messages, bounded; see LogModel.
  LogModel model_;
  LogFilter* filter_;
  QTableView* table_ = nullptr;
  QComboBox* level_ = nullptr;
  QComboBox* robot_ = nullptr;
  QLineEdit* pattern_ = nullptr;
  QLineEdit* search_ = nullptr;
  QLabel* state_ = nullptr;
  /// Error in the filter's regular expression; hidden if there is none.
  QLabel* problem_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* regex_ = nullptr;
  QAction* follow_ = nullptr;
  QAction* pause_ = nullptr;
  QAction* clear_ = nullptr;
  QAction* copy_ = nullptr;
  QAction* next_ = nullptr;
  QAction* previous_ = nullptr;
  /// The part of each stream that was already read, by path.
  std::map<std::string, StreamCursor> cursors_;
  /// The time of the newest message that was taken of each stream, by path.
  std::map<std::string, robotlink::Instant> newest_;
  /// The stretches that are still to be read from disk.
  std::map<std::string, robotlink::Stretch> missed_;
  /// Null until something is to be read.
  std::unique_ptr<robotlink::Worker<Reading, Read>> reader_;
  /// Generation of the store when it was last read; another one means that it was reset.
  std::uint64_t generation_ = 0;
  OpenLogs& logs_;
  /// The texts and offsets of the logs that are listed, to detect a change.
  std::vector<std::pair<std::shared_ptr<const std::vector<LogEntry>>, robotlink::Duration>> listed_;
  /// Keys of the messages that the open logs hold, so that a message is not listed again when it is played.
  std::set<std::string> logged_;
  /// The instant whose row was selected last.
  robotlink::Instant shown_;
};

}  // namespace widgets
