// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

class QMenu;
class QMimeData;
class QWidget;

namespace app {

class CommandActions;

/// The ways to open a log with a mouse: by a dialog, from the recent ones, by dropping files. GUI thread.
class LogOpening : public QObject {
  Q_OBJECT
 public:
  /// `window` is what dialogs belong to.
  LogOpening(CommandActions& actions, QWidget* window);

  /// "Open log…", "Add log…", "Recent logs", "Close log".
  void fillMenu(QMenu& menu);
  /// Whether there is a file among it.
  static bool takes(const QMimeData& data);
  /// Opens what was dropped: of several logs all, on one time line; `add`: beside those that are open.
  /// Scenes, layouts and colour tables are opened as such.
  void drop(const QMimeData& data, bool add);

  QStringList recent() const { return recent_; }
  void setRecent(const QStringList& files);
  /// A log was opened.
  void remember(const QString& file);
  void setLogOpen(bool open);

 private:
  void ask(bool add);
  void open(const QString& file, bool add);
  void fillRecentMenu();

  CommandActions& actions_;
  QWidget* window_;
  QMenu* recentMenu_ = nullptr;
  QAction* add_ = nullptr;
  QAction* close_ = nullptr;
  QStringList recent_;  // newest first
};

}  // namespace app
