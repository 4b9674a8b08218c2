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

/// Describes the contents of open logs without a robot of this program, such as logs of other programs, for
/// which most views stay empty, and offers buttons for the views that do show them. Hidden for all other
/// logs. GUI thread; the logs must outlive its use.
class LogContentsBar : public QWidget {
  Q_OBJECT
 public:
  LogContentsBar(widgets::OpenLogs& logs, CommandActions& actions, QWidget* parent);
  /// Updates the text; called after each tick.
  void refresh();

 private:
  /// The description of one log.
  QString textOf(const widgets::LogOverview& overview) const;

  widgets::OpenLogs& logs_;
  QLabel* text_;
  /// OpenLogs::version() at the last refresh.
  quint64 shownVersion_ = 0;
};

}  // namespace app
