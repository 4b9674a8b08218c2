// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "widgets/View.h"
#include "widgets/models/LogModel.h"
#include "widgets/models/TypedStreams.h"

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace widgets {

class EmptyHint;
class LogFilter;

/// What the robots say in words: a table with filters for level, robot and text, a search, follow, pause,
/// clear and copy. While the time line stands at an instant, the row of that instant is the current one. Of
/// open logs all messages are listed, those after the play head muted; a double click goes to a message's
/// time.
class MessagesView final : public View {
  Q_OBJECT
 public:
  explicit MessagesView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  void createActions();
  void createFilters();
  void createViews();
  void connectSignals();
  void takeNew();
  void takeLogs();
  void showInstant();
  void listRobots();
  void setPattern();
  void find(int step);
  void copy();
  void showState();
  QWidget* createBar();

  LogModel model_;
  LogFilter* filter_;
  QTableView* table_ = nullptr;
  QComboBox* level_ = nullptr;
  QComboBox* robot_ = nullptr;
  QLineEdit* pattern_ = nullptr;
  QLineEdit* search_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* problem_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* regex_ = nullptr;
  QAction* follow_ = nullptr;
  QAction* pause_ = nullptr;
  QAction* clear_ = nullptr;
  QAction* copy_ = nullptr;
  QAction* next_ = nullptr;
  QAction* previous_ = nullptr;
  std::map<std::string, StreamCursor> cursors_;  // by stream
  std::uint64_t generation_ = 0;                 // of the store that was read
  OpenLogs& logs_;
  std::vector<std::pair<std::shared_ptr<const std::vector<LogEntry>>, robotlink::Duration>>
      listed_;                    // of the logs, with offsets
  std::set<std::string> logged_;  // keys of the messages that the logs hold
  robotlink::Instant shown_;
};

}  // namespace widgets
