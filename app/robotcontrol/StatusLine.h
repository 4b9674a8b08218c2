// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "widgets/PackageWish.h"

class QLabel;
class QStatusBar;
namespace robotcontrol {
class ReplayStatus;
class SimulationStatus;
}  // namespace robotcontrol

namespace app {

class Workbench;

/// What always stands at the window's lower edge: of a simulation its time, speed and ball contacts, of a log
/// where it is and how it is played; dropped messages. GUI thread.
class StatusLine : public QObject {
  Q_OBJECT
 public:
  StatusLine(Workbench& workbench, QStatusBar& bar);
  void refresh();

 private:
  void showSimulation(const robotcontrol::SimulationStatus& status);
  /// What a robot at the end of a line does: whether it is heard, and how long it is not.
  QString robotState();
  void showLog(const robotcontrol::ReplayStatus& status);
  void showNothing();

  Workbench& workbench_;
  widgets::PackageWish wish_;
  QLabel* state_;
  QLabel* time_;
  QLabel* speed_;
  QLabel* contacts_;
  QLabel* dropped_;
};

}  // namespace app
