// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace app {

class CommandActions;
class Workbench;

/// Shows the progress of opening a log, with a button that cancels it. Visible only if opening takes longer
/// than a moment. GUI thread; the workbench must outlive its use.
class OpeningBar : public QWidget {
  Q_OBJECT
 public:
  OpeningBar(Workbench& workbench, CommandActions& actions, QWidget* parent);
  /// Updates the progress; called after each tick.
  void refresh();

 private:
  Workbench& workbench_;
  /// In thousandths.
  QProgressBar* progress_;
  QToolButton* cancel_;
  /// Number of ticks for which something has been opening.
  int ticks_ = 0;
};

}  // namespace app
