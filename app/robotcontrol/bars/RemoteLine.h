// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

#include "app/core/remote/RemoteRobots.h"

class QStatusBar;
class QToolButton;

namespace app {

class Workbench;

/// The part of the status bar about links: how each connection to robots elsewhere is, and whether this
/// session is offered to others. A click on one of them opens its dialog. GUI thread; the workbench must
/// outlive its use.
class RemoteLine : public QObject {
  Q_OBJECT
 public:
  RemoteLine(Workbench& workbench, QStatusBar& bar);
  /// Updates the buttons; called after each tick.
  void refresh();

 Q_SIGNALS:
  /// The user clicked.
  void connectionsClicked();
  void offerClicked();

 private:
  QToolButton* addButton(const QString& name);
  void showConnections();
  /// Shows how many connections there are.
  void showAll(const std::vector<RemoteRobots::Connection>& connections);
  void showOffer();

  Workbench& workbench_;
  QStatusBar& bar_;
  /// One for each connection; more than there are stay hidden.
  std::vector<QToolButton*> connections_;
  QToolButton* offer_;
};

}  // namespace app
