// SPDX-License-Identifier: GPL-3.0-or-later
// What RobotsDialog does with the robots that are ticked: connect them, compare and send their files.
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <algorithm>

#include "app/core/Workbench.h"
#include "app/core/deploy/DeployJobs.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/remote/RobotColumns.h"
#include "app/robotcontrol/remote/RobotsDialog.h"
#include "robotlink/foxglove/client/ServerUrl.h"
#include "widgets/Controls.h"

namespace app {
namespace {

using State = DeployDifference::State;

/// A URL as connections have it; empty if it makes no sense.
std::string urlOf(const std::string& address) {
  const auto parsed = robotlink::websocket::parseServerUrl(address);
  return parsed ? toString(*parsed) : std::string();
}

const RemoteRobots::Connection* connectionTo(const std::vector<RemoteRobots::Connection>& connections,
                                             const std::string& address) {
  const auto found = std::ranges::find(connections, urlOf(address), &RemoteRobots::Connection::url);
  return found == connections.end() ? nullptr : &*found;
}

QString stateNameOf(State state) {
  switch (state) {
    case State::kSame:
      return RobotsDialog::tr("the same");
    case State::kDiffers:
      return RobotsDialog::tr("differs");
    case State::kMissing:
      return RobotsDialog::tr("is missing");
    case State::kWaiting:
      return RobotsDialog::tr("the same; takes effect when the program restarts");
  }
  return {};
}

QString textOf(const DeployJobs::State& state) {
  if (state.isBusy) return RobotsDialog::tr("%1 %…").arg(static_cast<int>(100 * state.share));
  if (state.error) return QString::fromStdString(state.error->text);
  if (!state.differences) return {};
  const QString text = QString::fromStdString(describe(*state.differences)).section(QLatin1Char(':'), 0, 0);
  return state.wasSent        ? RobotsDialog::tr("deployed: %1").arg(text)
         : state.wasRestarted ? RobotsDialog::tr("restarted: %1").arg(text)
                              : text;
}

void showIn(QTreeWidgetItem& row, int column, const QString& text, const QString& toolTip = {}) {
  if (row.text(column) != text) row.setText(column, text);
  const QString& help = toolTip.isEmpty() ? text : toolTip;
  if (row.toolTip(column) != help) row.setToolTip(column, help);
}

}  // namespace

std::vector<RobotSet::Robot> RobotsDialog::chosen() const {
  const RobotSet all = set();
  std::vector<RobotSet::Robot> robots;
  for (int i = 0; i < table_->topLevelItemCount(); ++i)
    if (table_->topLevelItem(i)->checkState(kSetName) == Qt::Checked)
      robots.push_back(all.robots[static_cast<std::size_t>(i)]);
  return robots;
}

void RobotsDialog::connectAll() {
  state_->clear();
  QStringList problems;
  for (const RobotSet::Robot& robot : chosen()) {
    const auto connections = workbench_.remote().connections();
    if (connectionTo(connections, robot.address) != nullptr) continue;
    const auto done = workbench_.commands().run("remote.connect", {robot.address, std::string()});
    if (!done)
      problems << QStringLiteral("%1: %2").arg(QString::fromStdString(robot.name),
                                               QString::fromStdString(done.error().text));
  }
  if (!problems.isEmpty()) widgets::showOutcome(*state_, problems.join(QLatin1Char('\n')), true);
}

void RobotsDialog::disconnectAll() {
  for (const RobotSet::Robot& robot : chosen()) {
    const auto connections = workbench_.remote().connections();
    if (const auto* connection = connectionTo(connections, robot.address))
      actions_.run(QStringLiteral("remote.disconnect"), {connection->url});
  }
}

void RobotsDialog::deploy(Deploy what) {
  state_->clear();
  QStringList problems;
  reported_.clear();
  report_->clear();
  for (const RobotSet::Robot& robot : chosen()) {
    const QString problem = deployTo(robot, what);
    if (!problem.isEmpty()) {
      problems << problem;
      continue;
    }
    reported_.push_back(robot);
    new QTreeWidgetItem(report_);
  }
  if (!problems.isEmpty()) widgets::showOutcome(*state_, problems.join(QLatin1Char('\n')), true);
  showReport();
}

QString RobotsDialog::deployTo(const RobotSet::Robot& robot, Deploy what) {
  const QString name = QString::fromStdString(robot.name);
  const auto connections = workbench_.remote().connections();
  const auto* connection = connectionTo(connections, robot.address);
  auto files = filesFor(robot, folder());
  if (!files)
    return QStringLiteral("%1: %2").arg(name, QString::fromStdString(robotlink::describe(files.error())));
  DeployJobs* jobs = connection == nullptr ? nullptr : workbench_.deploymentAt(connection->url);
  if (jobs == nullptr || !connection->state.isConnected()) return tr("%1 is not connected.").arg(name);
  if (!connection->hasResources)
    return tr("%1 takes no files. Restart its program with --resources FOLDER.").arg(name);
  switch (what) {
    case Deploy::kCheck:
      jobs->check(robot.name, *std::move(files));
      break;
    case Deploy::kSend:
      jobs->send(robot.name, *std::move(files));
      break;
    case Deploy::kRestart:
      jobs->restart(robot.name, *std::move(files));
      break;
  }
  return {};
}

void RobotsDialog::cancelDeploying() {
  for (const RobotSet::Robot& robot : reported_)
    if (DeployJobs* jobs = workbench_.deploymentAt(urlOf(robot.address))) jobs->cancel();
}

void RobotsDialog::tick() {
  if (!isVisible()) return;
  showStates();
  showReport();
}

void RobotsDialog::showStates() {
  const auto connections = workbench_.remote().connections();
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    QTreeWidgetItem& row = *table_->topLevelItem(i);
    const auto* connection = connectionTo(connections, row.text(kSetAddress).trimmed().toStdString());
    const QString text =
        connection == nullptr ? tr("not connected") : QString::fromStdString(connection->text);
    // The figures of the line are for the tooltip, reasons are not.
    const bool isUp = connection != nullptr && connection->state.isConnected();
    showIn(row, kSetState, isUp ? text.section(QLatin1Char(','), 0, 0) : text, text);
  }
}

void RobotsDialog::showReport() {
  bool isBusy = false, waits = false;
  for (std::size_t i = 0; i < reported_.size(); ++i) {
    QTreeWidgetItem& row = *report_->topLevelItem(static_cast<int>(i));
    const DeployJobs* jobs = workbench_.deploymentAt(urlOf(reported_[i].address));
    const auto state = jobs == nullptr ? DeployJobs::State() : jobs->state(reported_[i].name);
    isBusy = isBusy || state.isBusy;
    waits = waits || (state.differences && needsRestart(*state.differences));
    showIn(row, 0, QString::fromStdString(reported_[i].name));
    showIn(row, 1, jobs == nullptr ? tr("not connected") : textOf(state));
    if (!state.differences || row.childCount() > 0) continue;
    for (const DeployDifference& one : *state.differences) {
      auto* file = new QTreeWidgetItem(&row);
      showIn(*file, 0, QString::fromStdString(one.path));
      showIn(*file, 1, stateNameOf(one.state));
    }
    const bool differs = std::ranges::any_of(
        *state.differences, [](const DeployDifference& one) { return one.state != State::kSame; });
    row.setExpanded(differs);
  }
  cancel_->setEnabled(isBusy);
  restart_->setEnabled(waits && !isBusy);
}

}  // namespace app
