// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>
#include <functional>

#include "robotlink/commands/CommandTable.h"

namespace app {

/// Creates actions that run commands, so that menus, toolbars and shortcuts do the same as scripts. Errors of
/// all commands are reported by the signal refused(). GUI thread; the command table must outlive this object.
class CommandActions : public QObject {
  Q_OBJECT
 public:
  CommandActions(robotlink::CommandTable& commands, QObject* parent) : QObject(parent), commands_(commands) {}

  /// An action that runs a command with fixed arguments, owned by this object. Its object name is the
  /// command; its tooltip is the command's help with the shortcut.
  QAction* make(const QString& text, const char* icon, const QString& command,
                const std::vector<robotlink::CommandTable::Value>& arguments = {},
                const QList<QKeySequence>& shortcuts = {});
  /// Runs a command, unless the guard prevents it.
  void run(const QString& command, const std::vector<robotlink::CommandTable::Value>& arguments = {});
  /// Asks the guard whether the user may run a command.
  bool mayRun(const QString& command) const { return !guard_ || guard_(command); }
  /// Sets a function that is called with the name of each command that the user runs; if it returns false,
  /// the command is not run. Scripts bypass it.
  void setGuard(std::function<bool(const QString& command)> guard) { guard_ = std::move(guard); }

 Q_SIGNALS:
  /// A command failed; `reason` is a sentence for the user.
  void refused(const QString& reason);
  /// The command that failed last has succeeded now.
  void settled();

 private:
  robotlink::CommandTable& commands_;
  /// The guard of commands; may be empty.
  std::function<bool(const QString& command)> guard_;
  /// The command that failed last; empty: none.
  QString failed_;
};

}  // namespace app
