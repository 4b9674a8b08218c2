// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "widgets/PackageSubscription.h"

class QLabel;
class QStatusBar;
namespace robotcontrol {
class ReplayStatus;
class SimulationStatus;
}  // namespace robotcontrol

namespace app {

class Workbench;

/// The contents of the status bar: for a simulation its time, speed and ball contacts, for a log its position
/// and playback, for a real robot its connection; and the number of dropped messages. GUI thread; the
/// workbench must outlive its use.
class StatusLine : public QObject {
  Q_OBJECT
 public:
  StatusLine(Workbench& workbench, QStatusBar& bar);
  /// Updates the labels; called after each tick.
  void refresh();

 private:
  /// showSimulation(), showLog() and showNothing() set all labels for what is open.
  void showSimulation(const robotcontrol::SimulationStatus& status);
  /// Whether what is shown was sent over a line that is lost or ended now.
  bool isLost() const;
  /// The state of the connection to a real robot, local or remote, and for how long nothing was received.
  /// A robot with a base is only connected until that has sent something; others are running then.
  QString robotState(const robotcontrol::SimulationStatus& status);
  void showLog(const robotcontrol::ReplayStatus& status);
  void showNothing();

  Workbench& workbench_;
  /// The subscription of the packages that robotState() needs.
  widgets::PackageSubscription subscription_;
  /// The labels, owned by the status bar, from left to right.
  QLabel* state_;
  QLabel* time_;
  QLabel* speed_;
  QLabel* contacts_;
  QLabel* dropped_;
};

}  // namespace app
