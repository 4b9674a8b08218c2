// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/SnapshotMenu.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include "app/core/Workbench.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "widgets/Icon.h"

namespace app {
namespace {

const QString kFolderKey = QStringLiteral("snapshots/folder");
constexpr double kRewinds[] = {0.1, 1, 5, 10, 30};  // s

const robotcontrol::SimulationStatus* statusOf(Workbench& workbench) {
  auto& session = workbench.session();
  const bool isSimulated = workbench.loaded() != nullptr && workbench.loaded()->isSimulated();
  if (!isSimulated) return nullptr;
  return session.store().latestAs<robotcontrol::SimulationStatus>(robotlink::streams::kSimulation,
                                                                  session.timeline().newest());
}

QString snapshotFolder() {
  return QSettings().value(kFolderKey).toString();
}

void rememberFolder(const QString& file) {
  QSettings().setValue(kFolderKey, QFileInfo(file).absolutePath());
}

/// The first of "1", "2", ... that no snapshot has as its name.
std::string freeName(const robotcontrol::SimulationStatus& status) {
  for (int number = 1;; ++number) {
    const std::string name = std::to_string(number);
    bool isTaken = false;
    for (const auto& snapshot : status.snapshots()) isTaken = isTaken || snapshot.name() == name;
    if (!isTaken) return name;
  }
}

}  // namespace

SnapshotMenu::SnapshotMenu(Workbench& workbench, CommandActions& actions, QWidget* parent)
    : QMenu(tr("S&napshots"), parent), workbench_(workbench), actions_(actions) {
  setObjectName(QStringLiteral("snapshotMenu"));
  setToolTipsVisible(true);
  connect(this, &QMenu::aboutToShow, this, &SnapshotMenu::fill);
  fill();
}

QAction* SnapshotMenu::addCommand(const QString& text, const char* name, const QString& tip,
                                  const QString& command, const std::string& argument) {
  QAction* action = addAction(text, this, [this, command, argument] { actions_.run(command, {argument}); });
  action->setObjectName(QLatin1String(name));
  action->setToolTip(tip);
  return action;
}

void SnapshotMenu::fill() {
  // Submenus are not deleted with their entries.
  qDeleteAll(findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly));
  clear();
  const auto* status = statusOf(workbench_);
  if (status == nullptr) {
    addAction(tr("No simulation is open"))->setEnabled(false);
    return;
  }
  QAction* take = addCommand(tr("&Take a snapshot"), "snapshot.take",
                             tr("Keeps the present state of the world until the scene is closed"),
                             QStringLiteral("simulation.snapshot"), freeName(*status));
  take->setIcon(widgets::icon("camera"));
  QAction* toFile = addAction(tr("Take a snapshot as a &file…"), this, &SnapshotMenu::takeFile);
  toFile->setObjectName(QStringLiteral("snapshot.take-file"));
  toFile->setToolTip(tr("Writes the present state of the world to a file"));
  QAction* fromFile = addAction(tr("&Go back to a file…"), this, &SnapshotMenu::restoreFile);
  fromFile->setObjectName(QStringLiteral("snapshot.restore-file"));
  fromFile->setToolTip(tr("Restores the state of the world from a file; the robots' programs keep running"));
  addSeparator();
  for (const auto& snapshot : status->snapshots()) {
    addSnapshot(
        snapshot.name(),
        tr("%1: at %2 s").arg(QString::fromStdString(snapshot.name())).arg(snapshot.time(), 0, 'f', 3));
  }
  addRewinding(!status->running(), status->rewindable());
  if (status->catching_up() <= 0) return;
  QAction* cancel =
      addAction(tr("&Cancel replaying the programs (%1 %)").arg(qRound(100 * status->catching_up())), this,
                [this] { actions_.run(QStringLiteral("simulation.cancel")); });
  cancel->setObjectName(QStringLiteral("snapshot.cancel"));
  cancel->setToolTip(tr("Leaves world and programs in their current state, and pauses"));
}

void SnapshotMenu::addSnapshot(const std::string& name, const QString& title) {
  QMenu* menu = addMenu(title);
  menu->setToolTipsVisible(true);
  const auto add = [&](const QString& text, const QString& tip, const QString& command,
                       const std::vector<robotlink::CommandTable::Value>& values) {
    QAction* action = menu->addAction(text, this, [this, command, values] { actions_.run(command, values); });
    action->setObjectName(command + QLatin1Char(' ') + QString::fromStdString(name));
    action->setToolTip(tip);
    return action;
  };
  add(tr("&Go back"), tr("Restores this state of the world; the robots' programs keep running"),
      QStringLiteral("simulation.restore"), {name, false});
  add(tr("Go back with the &programs"),
      tr("Also replays the programs from their start, with all requests, up to this snapshot"),
      QStringLiteral("simulation.restore"), {name, true})
      ->setObjectName(QStringLiteral("simulation.restore-programs ") + QString::fromStdString(name));
  add(tr("&Forget"), tr("Removes this snapshot"), QStringLiteral("simulation.forget"), {name});
}

void SnapshotMenu::addRewinding(bool isPaused, double rewindable) {
  addSeparator();
  for (const double seconds : kRewinds) {
    QAction* action = addAction(tr("Rewind by %1 s").arg(seconds), this, [this, seconds] {
      actions_.run(QStringLiteral("simulation.rewind"), {seconds});
    });
    action->setObjectName(QStringLiteral("rewind.%1").arg(seconds));
    action->setEnabled(isPaused && rewindable >= seconds - 1e-9);
    action->setToolTip(
        isPaused ? tr("Rewinds the world; the robots' programs keep running. The last %1 s are kept")
                       .arg(rewindable, 0, 'f', 1)
                 : tr("Pause the simulation to rewind it"));
  }
}

void SnapshotMenu::takeFile() {
  const QString file = QFileDialog::getSaveFileName(parentWidget(), tr("Take a snapshot"),
                                                    snapshotFolder() + QStringLiteral("/scene.snapshot"),
                                                    tr("Snapshots (*.snapshot)"));
  if (file.isEmpty()) return;
  rememberFolder(file);
  const QString whole =
      file.endsWith(QStringLiteral(".snapshot")) ? file : file + QStringLiteral(".snapshot");
  actions_.run(QStringLiteral("simulation.snapshot"), {whole.toStdString()});
}

void SnapshotMenu::restoreFile() {
  const QString file = QFileDialog::getOpenFileName(parentWidget(), tr("Go back to a snapshot"),
                                                    snapshotFolder(), tr("Snapshots (*.snapshot)"));
  if (file.isEmpty()) return;
  rememberFolder(file);
  actions_.run(QStringLiteral("simulation.restore"), {file.toStdString(), false});
}

}  // namespace app
