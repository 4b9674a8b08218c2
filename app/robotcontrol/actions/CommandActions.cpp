// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/CommandActions.h"

#include <QCoreApplication>

#include "widgets/Icon.h"

namespace app {

QAction* CommandActions::make(const QString& text, const char* icon, const QString& command,
                              const std::vector<robotlink::CommandTable::Value>& arguments,
                              const QList<QKeySequence>& shortcuts) {
  auto* action = new QAction(widgets::icon(icon), text, this);
  action->setObjectName(command);
  action->setShortcuts(shortcuts);
  action->setShortcutContext(Qt::ApplicationShortcut);
  const auto* known = commands_.find(command.toStdString());
  QString tip = known != nullptr ? QCoreApplication::translate("Command", known->help.c_str()) : text;
  if (!shortcuts.isEmpty())
    tip += QStringLiteral(" (%1)").arg(QKeySequence::listToString(shortcuts, QKeySequence::NativeText));
  action->setToolTip(tip);
  action->setStatusTip(tip);
  connect(action, &QAction::triggered, this, [this, command, arguments] { run(command, arguments); });
  return action;
}

void CommandActions::run(const QString& command,
                         const std::vector<robotlink::CommandTable::Value>& arguments) {
  if (!mayRun(command)) return;
  const auto done = commands_.run(command.toStdString(), arguments);
  if (!done) {
    failed_ = command;
    Q_EMIT refused(QString::fromStdString(done.error().describe()));
  } else if (command == failed_) {
    failed_.clear();
    Q_EMIT settled();
  }
}

}  // namespace app
