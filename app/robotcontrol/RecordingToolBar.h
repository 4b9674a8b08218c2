// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>

class QActionGroup;
class QLabel;
class QMenu;
class QToolButton;

namespace robotcontrol {
class RecordingStatus;
}

namespace app {

class CommandActions;
class Workbench;

/// Record and end, into which file, save the last seconds, mark an instant; what is recorded and how in the
/// record button's menu; and how long, how much and what was left out, live. Shows what the recorder reports,
/// not what was clicked. GUI thread.
class RecordingToolBar : public QToolBar {
  Q_OBJECT
 public:
  RecordingToolBar(Workbench& workbench, CommandActions& actions, QWidget* parent);

  /// Shows the recorder's state; called after each tick.
  void refresh();
  /// For the window's menu: all that the toolbar has.
  QMenu* menu() const { return menu_; }
  const QList<QAction*>& recordingActions() const { return recordingActions_; }

  /// What stands beside the button: "0:12  8.4 MB", "keeps 10 s", and what was left out.
  static QString statusText(const robotcontrol::RecordingStatus& status);
  /// "0:12 (8.4 MB)" of the recording that runs or ran last.
  static QString lengthText(const robotcontrol::RecordingStatus& status);

 private:
  struct Choice {
    QString text;
    QVariant value;  // as the command takes it
  };
  void createActions();
  void createMenu();
  QActionGroup* addChoices(const QString& title, const char* icon, const char* command,
                           const std::vector<Choice>& choices);
  void createWidgets();
  void chooseStreams();
  void chooseTrigger();
  void chooseFolder();
  void bookmark();
  void refreshFile(const robotcontrol::RecordingStatus& status);
  void refreshChoices(const robotcontrol::RecordingStatus& status);

  Workbench& workbench_;
  CommandActions& actions_;
  QAction* record_ = nullptr;
  bool showsEnd_ = false;  // the button ends the recording
  QAction* saveLast_ = nullptr;
  QAction* bookmark_ = nullptr;
  QMenu* menu_ = nullptr;
  QActionGroup* images_ = nullptr;
  QActionGroup* compression_ = nullptr;
  QActionGroup* keep_ = nullptr;
  QAction* trigger_ = nullptr;
  QLabel* file_ = nullptr;
  QAction* fileAction_ = nullptr;  // shows it
  QLabel* status_ = nullptr;
  QList<QAction*> recordingActions_;
};

}  // namespace app
