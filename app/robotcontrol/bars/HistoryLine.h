// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;
class QMenu;
class QStatusBar;
class QToolButton;

namespace app {

class CommandActions;
class Workbench;

/// Pauses all views while the robots continue, and lets users look back: the menu's actions, and a part of
/// the status bar that says whether what is shown is what happens now, or how far behind that it is. A click
/// on it pauses, or returns to what happens now. Hidden while a log is open, which has a timeline of its
/// own. GUI thread; workbench and actions must outlive its use.
class HistoryLine : public QObject {
  Q_OBJECT
 public:
  HistoryLine(Workbench& workbench, CommandActions& actions, QStatusBar& bar);
  /// Updates the button and the actions; called after each tick.
  void refresh();
  /// The menu with all actions.
  QMenu* menu() const { return menu_; }
  /// Whether there is something to look back at: something sends, and it is no log.
  bool available() const;

 private:
  void toggle();
  /// Runs timeline.seek for an instant that far from the shown one.
  void seekBy(double seconds);

  Workbench& workbench_;
  CommandActions& actions_;
  QToolButton* button_;
  QMenu* menu_;
  QAction* pause_;
};

}  // namespace app
