// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;

namespace widgets {
class OpenLogs;
struct LogOverview;
}  // namespace widgets

namespace app {

class CommandActions;

/// What open logs hold in which no robot of this program is, such as those of other programs: most views stay
/// empty then. With buttons for the views that show it. Hidden for all other logs. GUI thread.
class LogContentsBar : public QWidget {
  Q_OBJECT
 public:
  LogContentsBar(widgets::OpenLogs& logs, CommandActions& actions, QWidget* parent);
  /// Called after each tick.
  void refresh();

 private:
  QString textOf(const widgets::LogOverview& overview) const;

  widgets::OpenLogs& logs_;
  QLabel* text_;
  quint64 shownVersion_ = 0;
};

}  // namespace app
