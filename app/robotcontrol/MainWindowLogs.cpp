// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: logs, that is menu, keys, drag and drop, toolbar and bars.
#include <QDragEnterEvent>
#include <QJsonArray>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QVBoxLayout>

#include "app/core/Workbench.h"
#include "app/core/replay/ReplayComputation.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/actions/LogOpening.h"
#include "app/robotcontrol/bars/LogContentsBar.h"
#include "app/robotcontrol/bars/LogToolBar.h"
#include "app/robotcontrol/bars/OpeningBar.h"
#include "app/robotcontrol/bars/RecordedBar.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "widgets/log/OpenLogs.h"

namespace app {

void MainWindow::createLogs() {
  auto& logs = widgets::openLogs(context_);
  logs.setComputation(computationByReplay());
  opening_ = new LogOpening(*actions_, this);
  addToolBarBreak();
  logToolBar_ = new LogToolBar(*actions_, logs, this);
  addToolBar(logToolBar_);
  setAcceptDrops(true);
  openingBar_ = new OpeningBar(workbench_, *actions_, centralWidget());
  static_cast<QVBoxLayout*>(centralWidget()->layout())->insertWidget(0, openingBar_);
  recordedBar_ = new RecordedBar(workbench_, *actions_, centralWidget());
  static_cast<QVBoxLayout*>(centralWidget()->layout())->insertWidget(0, recordedBar_);
  contentsBar_ = new LogContentsBar(logs, *actions_, centralWidget());
  static_cast<QVBoxLayout*>(centralWidget()->layout())->insertWidget(1, contentsBar_);
  connect(&logs, &widgets::OpenLogs::failed, this, [this](const QString& reason) {
    showErrors({{"log.failed", reason.toStdString(), {}, {}}});
  });
  connect(&logs, &widgets::OpenLogs::logsChanged, this, [this, &logs] {
    opening_->setLogOpen(!logs.logs().empty());
    for (const auto& log : logs.logs()) opening_->remember(QString::fromStdString(log->path));
  });
  addBookmarkCommand();
}

void MainWindow::addBookmarkCommand() {
  if (workbench_.commands().isAttached("log.bookmark")) return;
  const auto run = [shared = std::weak_ptr(context_.logs)](const auto& values) -> robotlink::Result<void> {
    const auto open = shared.lock();
    if (open != nullptr) open->tick();  // processes a log that was opened just now
    if (open == nullptr || !open->replay().open()) {
      return robotlink::failure("log.none", "no log is open; open one first: log.open FILE");
    }
    const double seconds = std::get<double>(values[0]);
    if (!(seconds >= 0 && seconds <= robotlink::seconds(open->replay().end() - open->replay().begin()))) {
      return robotlink::failure("log.time", "the log is not that long; choose a time within it");
    }
    open->addBookmarkAt(open->replay().begin() + robotlink::fromSeconds(seconds),
                        QString::fromStdString(std::get<std::string>(values[1])));
    return {};
  };
  workbench_.commands().attach("log.bookmark", run);
}

void MainWindow::createLogMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Log"));
  menu->setObjectName(QStringLiteral("logMenu"));
  logToolBar_->fillMenu(*menu);
}

void MainWindow::tickLogs() {
  widgets::openLogs(context_).tick();
  logToolBar_->refresh();
  openingBar_->refresh();
  recordedBar_->refresh();
  contentsBar_->refresh();
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (!logToolBar_->press(*event)) QMainWindow::keyPressEvent(event);
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  const bool pressed =
      event->type() == QEvent::KeyPress && logToolBar_->press(*static_cast<QKeyEvent*>(event));
  return pressed || QMainWindow::eventFilter(watched, event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (LogOpening::takes(*event->mimeData())) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  opening_->drop(*event->mimeData(), (event->keyboardModifiers() & Qt::ControlModifier) != 0);
}

}  // namespace app
