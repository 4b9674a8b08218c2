// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: connecting real robots.
#include "app/core/Workbench.h"
#include "app/robotcontrol/MainWindow.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/RobotDescription.h"
#include "widgets/drive/ConnectDialog.h"

namespace app {
namespace {

/// The names of the layouts for Pioneers.
std::vector<std::pair<QString, QString>> pioneerLayouts() {
  std::vector<std::pair<QString, QString>> layouts;
  const auto description = robotlink::readRobotDescription(robotlink::resource("robots/p3at.yaml"));
  if (!description) return layouts;
  for (const auto& file : Workbench::layoutsFor(*description)) {
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
    choices.layouts = pioneerLayouts();
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
