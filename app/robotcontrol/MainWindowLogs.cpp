// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: logs, that is menu, keys, drag and drop, toolbar and bars.
#include <QDragEnterEvent>
#include <QJsonArray>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QVBoxLayout>
#include <algorithm>

#include "app/core/Workbench.h"
#include "app/platforms/replay/ReplayComputation.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/actions/LogOpening.h"
#include "app/robotcontrol/bars/LogContentsBar.h"
#include "app/robotcontrol/bars/LogToolBar.h"
#include "app/robotcontrol/bars/OpeningBar.h"
#include "app/robotcontrol/bars/RecordedBar.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "robotlink/base/Spelling.h"
#include "widgets/log/OpenLogs.h"

namespace app {
namespace {

using robotlink::Result;
using Values = robotlink::CommandTable::Values;

/// A bookmark of one of the open logs.
struct PlacedBookmark {
  widgets::OpenLogs::Log* log = nullptr;
  logplayer::Bookmark bookmark;
};

std::vector<std::string> bookmarkTexts(const widgets::OpenLogs& logs) {
  std::vector<std::string> texts;
  for (const auto& log : logs.logs()) {
    if (!log->bookmarks) continue;
    for (const auto& bookmark : log->bookmarks->all()) texts.push_back(bookmark.text);
  }
  return texts;
}

/// The first bookmark with this text. Fails if there is none.
Result<PlacedBookmark> bookmarkNamed(const widgets::OpenLogs& logs, const std::string& text) {
  for (const auto& log : logs.logs()) {
    if (!log->bookmarks) continue;
    const auto& all = log->bookmarks->all();
    const auto found = std::ranges::find(all, text, &logplayer::Bookmark::text);
    if (found != all.end()) return PlacedBookmark{log.get(), *found};
  }
  return robotlink::failure(
      "log.bookmark",
      "there is no bookmark '" + text + "'" + robotlink::suggestion(text, bookmarkTexts(logs)), {}, {text});
}

Result<void> addBookmark(widgets::OpenLogs& logs, const Values& values) {
  const double seconds = std::get<double>(values[0]);
  const auto& replay = logs.replay();
  if (!(seconds >= 0 && seconds <= robotlink::seconds(replay.end() - replay.begin())))
    return robotlink::failure("log.time", "the log is not that long; choose a time within it");
  logs.addBookmarkAt(replay.begin() + robotlink::fromSeconds(seconds),
                     QString::fromStdString(std::get<std::string>(values[1])));
  return {};
}

Result<void> removeBookmark(widgets::OpenLogs& logs, const Values& values) {
  const auto found = bookmarkNamed(logs, std::get<std::string>(values[0]));
  if (!found) return tl::unexpected(found.error());
  logs.removeBookmark(*found->log, found->bookmark.id);
  return {};
}

Result<void> renameBookmark(widgets::OpenLogs& logs, const Values& values) {
  auto found = bookmarkNamed(logs, std::get<std::string>(values[0]));
  if (!found) return tl::unexpected(found.error());
  found->bookmark.text = std::get<std::string>(values[1]);
  logs.changeBookmark(*found->log, found->bookmark);
  return {};
}

}  // namespace

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
  addBookmarkCommands();
}

void MainWindow::addBookmarkCommands() {
  auto& commands = workbench_.commands();
  if (commands.isAttached("log.bookmark")) return;
  using Run = Result<void> (*)(widgets::OpenLogs&, const Values&);
  const auto attachForLogs = [this, &commands](const char* name, Run run,
                                               robotlink::CommandTable::Offer offer = {}) {
    const auto act = [run, shared = std::weak_ptr(context_.logs)](const Values& values) -> Result<void> {
      const auto open = shared.lock();
      if (open != nullptr) open->tick();  // processes a log that was opened just now
      if (open == nullptr || !open->replay().open())
        return robotlink::failure("log.none", "no log is open; open one first: log.open FILE");
      return run(*open, values);
    };
    commands.attach(name, act, std::move(offer));
  };
  attachForLogs("log.bookmark", addBookmark);
  const auto texts = [shared = std::weak_ptr(context_.logs)](const std::vector<std::string>& before) {
    const auto open = shared.lock();
    return open != nullptr && before.empty() ? bookmarkTexts(*open) : std::vector<std::string>();
  };
  attachForLogs("log.remove-bookmark", removeBookmark, texts);
  attachForLogs("log.rename-bookmark", renameBookmark, texts);
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
