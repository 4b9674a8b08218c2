// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

#include "app/core/remote/RemoteRobots.h"

class QStatusBar;
class QToolButton;

namespace app {

class CommandActions;
class Workbench;

/// The part of the status bar about links: how each connection to remote robots is, whether this session
/// is offered to others, and who steers the selected robot. A click on one of the first opens its dialog; a
/// click on the last takes the steering over, or gives it up. GUI thread; workbench and actions
/// must outlive its use.
class RemoteLine : public QObject {
  Q_OBJECT
 public:
  RemoteLine(Workbench& workbench, CommandActions& actions, QStatusBar& bar);
  /// Updates the buttons; called after each tick.
  void refresh();

 Q_SIGNALS:
  /// The user clicked.
  void connectionsClicked();
  void offerClicked();

 private:
  QToolButton* addButton(const QString& name);
  /// The maximum width of the texts of all connections together, in pixels: what the others leave of the bar.
  int room(std::size_t shown) const;
  static QString tipOf(const RemoteRobots::Connection& connection);
  void showConnections();
  /// Shows how many connections there are.
  void showAll(const std::vector<RemoteRobots::Connection>& connections);
  void showOffer();
  /// Shows who steers the selected robot, if several people can.
  void showSteering();
  void takeSteering();

  Workbench& workbench_;
  CommandActions& actions_;
  QStatusBar& bar_;
  /// The buttons, one for each connection; those that are left over are hidden.
  std::vector<QToolButton*> connections_;
  QToolButton* offer_;
  QToolButton* steering_;
};

}  // namespace app
