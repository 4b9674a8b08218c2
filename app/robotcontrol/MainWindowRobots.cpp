// SPDX-License-Identifier: GPL-3.0-or-later
// How the main window connects robots.
#include "app/core/Workbench.h"
#include "app/core/program/RobotFiles.h"
#include "app/robotcontrol/MainWindow.h"
#include "robotlink/config/RobotDescription.h"
#include "widgets/drive/ConnectDialog.h"

namespace app {
namespace {

/// The layouts that the program of a robot can run in that is connected over a line, by their names.
std::vector<std::pair<QString, QString>> layoutsOfConnected() {
  std::vector<std::pair<QString, QString>> layouts;
  const auto description = readRobot(PioneerOptions{}.kind);
  if (!description) return layouts;
  for (const auto& file : Workbench::layoutsFor(**description)) {
    const QString name = QString::fromStdString(file.stem().string());
    layouts.emplace_back(name, name);
  }
  return layouts;
}

}  // namespace

void MainWindow::connectRobot() {
  if (!mayReplace(QStringLiteral("robot.connect"))) return;
  if (connectDialog_ == nullptr) {
    widgets::ConnectDialog::Choices choices;
    choices.recent = recentRobots_;
    choices.serialPorts = [] { return robotlink::arcos::serialPorts(); };
    choices.layouts = layoutsOfConnected();
    choices.map = robotMap_;
    connectDialog_ =
        new widgets::ConnectDialog(workbench_.session(), workbench_.commands(), std::move(choices), this);
    connect(connectDialog_, &widgets::ConnectDialog::recentChanged, this, [this] {
      recentRobots_ = connectDialog_->recent();
      robotMap_ = connectDialog_->map();
    });
  }
  connectDialog_->show();
  connectDialog_->raise();
  connectDialog_->activateWindow();
}

}  // namespace app
