// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>
#include <map>
#include <string>
#include <vector>

#include "robotlink/commands/CommandTable.h"
#include "widgets/log/ReplayKeys.h"

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

/// The toolbar that plays the open logs: play, stop, steps, time and frame (editable, to jump there), speed,
/// loop, gaps, bookmarks. Visible while a log is open. It shows the state that the replay reports, not what
/// was clicked. GUI thread; the logs must outlive its use.
class LogToolBar : public QToolBar {
  Q_OBJECT
 public:
  LogToolBar(CommandActions& actions, widgets::OpenLogs& logs, QWidget* parent);

  /// Shows the replay's state; called after each tick.
  void refresh();
  /// Adds all actions to a menu.
  void fillMenu(QMenu& menu);
  /// Executes the action of a key that no other widget handled. Returns false if the key has no action or no
  /// log is open.
  bool press(const QKeyEvent& event);
  /// The checkable action that switches all views between time since the begin and timestamps.
  QAction* timeStampsAction() const { return timeStamps_; }
  /// The action of a key; its text describes the current effect.
  QAction* action(widgets::ReplayKey key) const { return keyed_.at(key); }
  /// The available speeds, times real time.
  static std::vector<double> speeds() { return {0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50}; }

 private:
  /// Object name, icon, text and tooltip of an action.
  struct Text {
    const char* name;
    const char* icon;
    QString text, tip;
  };
  using Values = std::vector<robotlink::CommandTable::Value>;

  /// Creates an action that calls a function.
  QAction* make(const Text& text, std::function<void()> action);
  /// Creates an action with a key, and adds it to keyed_.
  QAction* make(widgets::ReplayKey key, const Text& text, std::function<void()> action);
  /// The create functions are called once, by the constructor.
  void createSteps();
  void createLongSteps();
  void createRangeActions();
  void createOptions();
  void createFields();
  void createBar();
  /// jumpToTypedTime() and jumpToTypedFrame() handle input in the fields.
  void jumpToTypedTime();
  void jumpToTypedFrame();
  /// Parts of refresh().
  void refreshProcesses();
  void refreshFields();
  void refreshTips();

  CommandActions& actions_;
  widgets::OpenLogs& logs_;
  /// The actions with keys.
  std::map<widgets::ReplayKey, QAction*> keyed_;
  /// The actions without keys.
  QAction* stop_ = nullptr;
  QAction* loop_ = nullptr;
  QAction* skipGaps_ = nullptr;
  QAction* clearRange_ = nullptr;
  QAction* timeStamps_ = nullptr;
  /// Speed of the playback, and the process whose frames are stepped.
  QComboBox* speed_ = nullptr;
  QComboBox* process_ = nullptr;
  /// The current time, editable, and the time of the log's end.
  QLineEdit* time_ = nullptr;
  QLabel* end_ = nullptr;
  /// The current frame number, editable, and the number of frames.
  QLineEdit* frame_ = nullptr;
  QLabel* frames_ = nullptr;
  /// Whether a log was open at the last refresh.
  bool wasOpen_ = true;
};

}  // namespace app
