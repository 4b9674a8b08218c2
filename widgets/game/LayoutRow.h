// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;
class QComboBox;

namespace robotlink {
class CommandTable;
}

namespace widgets {

/// Chooses the process layout of a robot or a team, among those that the command layout.open offers. GUI
/// thread.
class LayoutRow final : public QWidget {
  Q_OBJECT
 public:
  /// The commands must outlive it.
  explicit LayoutRow(robotlink::CommandTable& commands, QWidget* parent = nullptr);

  /// Shows what is offered now; nothing can be chosen without a robot. `running`: the layout that it runs,
  /// which is shown until the user chooses another one; empty: it is not known.
  void showFor(const QString& robot, const QString& team, const QString& running);

 Q_SIGNALS:
  /// A command was run; the reason if it failed.
  void asked(const QString& reason);

 private:
  void use(const QString& name);

  robotlink::CommandTable& commands_;
  QComboBox* layouts_ = nullptr;
  QAction *forRobot_ = nullptr, *forTeam_ = nullptr;
  QString robot_, team_, running_;
};

}  // namespace widgets
