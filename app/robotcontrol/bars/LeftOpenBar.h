// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QStringList>
#include <QWidget>

class QLabel;

namespace app {

class CommandActions;
struct LoadedPlatform;
class Workbench;

/// After a workbench that did not end properly (a crash, a lost session), offers to open again what it had
/// open: the platform with its layout, and the connections to remote robots. Hidden unless there is
/// something to offer. GUI thread; the workbench must outlive its use.
class LeftOpenBar final : public QWidget {
  Q_OBJECT
 public:
  LeftOpenBar(Workbench& workbench, CommandActions& actions, QWidget* parent);

  /// Returns what is open now, to be saved while the workbench runs; empty: nothing.
  static QJsonObject stateOf(const Workbench& workbench);
  /// Shows the bar for what stateOf() returned in the workbench that did not end properly.
  void offer(const QJsonObject& left);
  /// Hides the bar if that is open again, however it was opened.
  void noticeOpened();

 private:
  void open();

  Workbench& workbench_;
  CommandActions& actions_;
  QLabel* text_ = nullptr;
  QStringList sources_, servers_;
  QString layout_;
};

}  // namespace app
