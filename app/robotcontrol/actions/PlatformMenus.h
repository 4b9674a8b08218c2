// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include "app/robotcontrol/actions/FormMemory.h"

class QMenu;
class QWidget;
namespace robotlink {
class CommandTable;
class Session;
}  // namespace robotlink

namespace app {

class CommandActions;
class PlatformDialog;
struct PlatformAdapter;

/// The entries of menus that open platforms, and their dialogs, made from what the adapters declare. GUI
/// thread; belongs to the window; session and commands must outlive it.
class PlatformMenus final : public QObject {
  Q_OBJECT
 public:
  /// `window` is the parent of dialogs.
  PlatformMenus(CommandActions& actions, robotlink::Session& session, robotlink::CommandTable& commands,
                QWidget* window);

  /// Adds the entries of all adapters that open files in a file dialog.
  void addFiles(QMenu& menu);
  /// Adds the entries of the forms that belong into a menu: "file" or "robot".
  void addForms(QMenu& menu, const std::string& name);

  /// The values that users entered last.
  FormMemory& memory() { return memory_; }
  /// Call this in each tick of the session.
  void tick();
  /// Shows in the dialog of a robot that is being connected why that failed.
  void fail(const QString& reason);

 private:
  /// Asks for a file, and opens it.
  void openFile(const PlatformAdapter& adapter);
  /// Shows the dialog of an adapter, and opens what was chosen.
  void showForm(const PlatformAdapter& adapter);
  /// Shows the dialog of an adapter whose robot is connected later; it stays open until then.
  void showConnecting(const PlatformAdapter& adapter);

  CommandActions& actions_;
  robotlink::Session& session_;
  robotlink::CommandTable& commands_;
  QWidget* window_;
  FormMemory memory_;
  /// The modeless dialogs that have been shown.
  QList<PlatformDialog*> dialogs_;
};

}  // namespace app
