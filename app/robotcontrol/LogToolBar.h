// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>
#include <map>
#include <string>
#include <vector>

#include "robotlink/session/CommandTable.h"
#include "widgets/models/ReplayKeys.h"

class QComboBox;
class QKeyEvent;
class QLabel;
class QLineEdit;
class QMenu;

namespace widgets {
class OpenLogs;
}

namespace app {

class CommandActions;

/// Plays the open logs: play, stop, steps, time and frame (shown, and typed to jump), speed, loop, gaps,
/// bookmarks. It is there while a log is open. Shows what the replay says, not what was clicked. GUI thread;
/// the logs must outlive its use.
class LogToolBar : public QToolBar {
  Q_OBJECT
 public:
  LogToolBar(CommandActions& actions, widgets::OpenLogs& logs, QWidget* parent);

  /// Shows the replay's state; called after each tick.
  void refresh();
  /// All that can be done, for a menu.
  void fillMenu(QMenu& menu);
  /// Does what a key stands for that nobody else wanted. False: it stands for nothing, or no log is open.
  bool press(const QKeyEvent& event);
  /// The one that switches between times since the beginning and time stamps, in all views.
  QAction* timeStampsAction() const { return timeStamps_; }
  /// What a key does; the action's text says what that is now.
  QAction* action(widgets::ReplayKey key) const { return keyed_.at(key); }
  /// The speeds to choose from, times real time.
  static std::vector<double> speeds() { return {0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50}; }

 private:
  struct Text {
    const char* name;
    const char* icon;
    QString text, tip;
  };
  using Values = std::vector<robotlink::CommandTable::Value>;

  QAction* make(const Text& text, std::function<void()> action);
  QAction* make(widgets::ReplayKey key, const Text& text, std::function<void()> action);
  void createSteps();
  void createLongSteps();
  void createRangeActions();
  void createOptions();
  void createFields();
  void createBar();
  void jumpToTypedTime();
  void jumpToTypedFrame();
  void refreshProcesses();
  void refreshFields();
  void refreshTips();

  CommandActions& actions_;
  widgets::OpenLogs& logs_;
  std::map<widgets::ReplayKey, QAction*> keyed_;
  QAction* stop_ = nullptr;
  QAction* loop_ = nullptr;
  QAction* skipGaps_ = nullptr;
  QAction* clearRange_ = nullptr;
  QAction* timeStamps_ = nullptr;
  QComboBox* speed_ = nullptr;
  QComboBox* process_ = nullptr;
  QLineEdit* time_ = nullptr;
  QLabel* end_ = nullptr;
  QLineEdit* frame_ = nullptr;
  QLabel* frames_ = nullptr;
  bool wasOpen_ = true;
};

}  // namespace app
