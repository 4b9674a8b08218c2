// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QLabel;
class QStatusBar;

namespace app {

class Workbench;

/// What always stands at the window's lower edge: simulated time, speed, ball contacts, dropped messages. GUI thread.
class StatusLine : public QObject {
  Q_OBJECT
 public:
  StatusLine(Workbench& workbench, QStatusBar& bar);
  void refresh();

 private:
  Workbench& workbench_;
  QLabel* state_;
  QLabel* time_;
  QLabel* speed_;
  QLabel* contacts_;
  QLabel* dropped_;
};

}  // namespace app
