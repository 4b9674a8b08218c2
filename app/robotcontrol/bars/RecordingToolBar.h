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

/// The toolbar for recording: start and end, choice of the file, save the last seconds, mark an instant.
/// Settings are in the menu of the record button; duration, size and dropped messages are shown live. It
/// shows the state that the recorder reports, not what was clicked. GUI thread; the workbench must outlive
/// its use.
class RecordingToolBar : public QToolBar {
  Q_OBJECT
 public:
  RecordingToolBar(Workbench& workbench, CommandActions& actions, QWidget* parent);

  /// Shows the recorder's state; called after each tick.
  void refresh();
  /// A menu with everything that the toolbar offers, for the menu bar.
  QMenu* menu() const { return menu_; }

  /// The text beside the button: "0:12  8.4 MB", "keeps 10 s", and the number of dropped messages.
  static QString statusText(const robotcontrol::RecordingStatus& status);
  /// Duration and size of the current or the last recording: "0:12 (8.4 MB)".
  static QString lengthText(const robotcontrol::RecordingStatus& status);

 private:
  /// An entry of a menu with exclusive choices.
  struct Choice {
    QString text;
    /// The argument of the command.
    QVariant value;
  };
  void createActions();
  void createMenu();
  /// Adds a submenu whose entries run a command with different arguments.
  QActionGroup* addChoices(const QString& title, const char* icon, const char* command,
                           const std::vector<Choice>& choices);
  void createWidgets();
  /// These functions ask the user in a dialog and run the command.
  void chooseStreams();
  void chooseTrigger();
  void chooseFolder();
  void bookmark();
  /// Parts of refresh().
  void refreshFile(const robotcontrol::RecordingStatus& status);
  void refreshChoices(const robotcontrol::RecordingStatus& status);

  Workbench& workbench_;
  CommandActions& actions_;
  /// Starts and ends the recording.
  QAction* record_ = nullptr;
  /// Whether the button currently ends the recording.
  bool showsEnd_ = false;
  QAction* saveLast_ = nullptr;
  QAction* bookmark_ = nullptr;
  QMenu* menu_ = nullptr;
  /// Exclusive choices in the menu, checked as the recorder reports them.
  QActionGroup* images_ = nullptr;
  QActionGroup* compression_ = nullptr;
  QActionGroup* keep_ = nullptr;
  QAction* trigger_ = nullptr;
  /// The name of the file.
  QLabel* file_ = nullptr;
  /// The toolbar's action for file_, to show and hide it.
  QAction* fileAction_ = nullptr;
  /// See statusText().
  QLabel* status_ = nullptr;
};

}  // namespace app
