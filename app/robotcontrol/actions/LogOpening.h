// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

class QAction;
class QMenu;
class QMimeData;
class QWidget;

namespace app {

class CommandActions;

/// The ways to open a log in the GUI: by a dialog, from the list of recent logs, and by drag and drop. GUI
/// thread; belongs to the window.
class LogOpening : public QObject {
  Q_OBJECT
 public:
  /// `window` is the parent of dialogs.
  LogOpening(CommandActions& actions, QWidget* window);

  /// Adds "Open log...", "Add log...", "Recent logs" and "Close log".
  void fillMenu(QMenu& menu);
  /// Whether the data contains local files.
  static bool takes(const QMimeData& data);
  /// Opens dropped files: several logs on one timeline, with `add` in addition to those that are open.
  /// Scenes, layouts, pictures, folders of pictures and color tables are opened as such.
  void drop(const QMimeData& data, bool add);

  /// The recent logs, the latest one first.
  QStringList recent() const { return recent_; }
  void setRecent(const QStringList& files);
  /// Adds a log to the recent ones.
  void remember(const QString& file);
  /// Enables the entries that need an open log.
  void setLogOpen(bool open);

 private:
  /// Shows the file dialog.
  void ask(bool add);
  void open(const QString& file, bool add);
  /// Builds the submenu from recent_.
  void fillRecentMenu();

  CommandActions& actions_;
  QWidget* window_;
  QMenu* recentMenu_ = nullptr;
  QAction* add_ = nullptr;
  QAction* close_ = nullptr;
  /// The latest one first.
  QStringList recent_;
};

}  // namespace app
