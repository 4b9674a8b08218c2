// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>
#include <functional>

#include "robotlink/session/CommandTable.h"

namespace app {

/// Makes actions of commands, so that menus, toolbars and shortcuts do what scripts do. What a command
/// refuses is reported to one handler. GUI thread.
class CommandActions : public QObject {
  Q_OBJECT
 public:
  CommandActions(robotlink::CommandTable& commands, QObject* parent) : QObject(parent), commands_(commands) {}

  /// An action that runs a command with fixed arguments. Its tooltip is the command's help with the shortcut.
  QAction* make(const QString& text, const char* icon, const QString& command,
                const std::vector<robotlink::CommandTable::Value>& arguments = {},
                const QList<QKeySequence>& shortcuts = {});
  void run(const QString& command, const std::vector<robotlink::CommandTable::Value>& arguments = {});
  /// Asked before each command that a person runs, with its name; false: it is not run. Scripts are not
  /// asked.
  void setGuard(std::function<bool(const QString& command)> guard) { guard_ = std::move(guard); }

 Q_SIGNALS:
  void refused(const QString& reason);

 private:
  robotlink::CommandTable& commands_;
  std::function<bool(const QString& command)> guard_;
};

}  // namespace app
