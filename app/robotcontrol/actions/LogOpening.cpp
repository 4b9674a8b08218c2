// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/LogOpening.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QUrl>
#include <utility>

#include "app/core/platform/PlatformAdapter.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/actions/FileKind.h"
#include "widgets/Icon.h"

namespace app {
namespace {

constexpr int kMaxRecent = 10;

QStringList localFiles(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls()) {
    if (url.isLocalFile()) files << url.toLocalFile();
  }
  return files;
}

}  // namespace

LogOpening::LogOpening(CommandActions& actions, QWidget* window)
    : QObject(window), actions_(actions), window_(window) {}

void LogOpening::fillMenu(QMenu& menu) {
  QAction* open = menu.addAction(
      widgets::icon("time-line"), tr("Open &log…"), this, [this] { ask(false); },
      QKeySequence(QStringLiteral("Ctrl+L")));
  open->setObjectName(QStringLiteral("openLog"));
  add_ = menu.addAction(tr("&Add log…"), this, [this] { ask(true); });
  add_->setObjectName(QStringLiteral("addLog"));
  add_->setStatusTip(tr("Adds a log to the timeline"));
  recentMenu_ = menu.addMenu(tr("&Recent logs"));
  recentMenu_->setObjectName(QStringLiteral("recentLogs"));
  recentMenu_->setToolTipsVisible(true);
  close_ = menu.addAction(tr("&Close log"), this, [this] { actions_.run(QStringLiteral("log.close")); });
  close_->setObjectName(QStringLiteral("closeLog"));
  fillRecentMenu();
  setLogOpen(false);
}

void LogOpening::setLogOpen(bool open) {
  add_->setEnabled(open);
  close_->setEnabled(open);
}

void LogOpening::ask(bool add) {
  auto* dialog = new QFileDialog(window_, add ? tr("Add a log") : tr("Open a log"));
  dialog->setObjectName(QStringLiteral("openLogDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(add ? QFileDialog::ExistingFile : QFileDialog::ExistingFiles);
  dialog->setNameFilters(
      {tr("Logs and videos (*.mcap *.log *.mp4 *.mov *.avi *.mkv *.webm *.mpg)"), tr("All files (*)")});
  if (!recent_.isEmpty()) dialog->setDirectory(QFileInfo(recent_.front()).path());
  connect(dialog, &QFileDialog::filesSelected, this, [this, add](const QStringList& files) {
    for (int i = 0; i < files.size(); ++i) open(files[i], add || i > 0);
  });
  dialog->open();
}

void LogOpening::open(const QString& file, bool add) {
  const std::string path = QFileInfo(file).absoluteFilePath().toStdString();
  if (add) {
    actions_.run(QStringLiteral("log.add"), {path, 0.0});
  } else {
    actions_.run(QStringLiteral("log.open"), {path});
  }
}

bool LogOpening::takes(const QMimeData& data) {
  return !localFiles(data).isEmpty();
}

void LogOpening::drop(const QMimeData& data, bool add) {
  for (const QString& file : localFiles(data)) {
    const std::string path = file.toStdString();
    const std::vector<robotlink::CommandTable::Value> arguments = {path};
    switch (kindOfFile(path)) {
      case FileKind::kScene:
        actions_.run(QLatin1String(adapterFor(path)->command), arguments);
        break;
      case FileKind::kLayout:
        actions_.run(QStringLiteral("layout.open"), arguments);
        break;
      case FileKind::kPictures:
        actions_.run(QStringLiteral("color.open-pictures"), arguments);
        break;
      case FileKind::kColorTable:
        actions_.run(QStringLiteral("robot.color-table"), arguments);
        break;
      case FileKind::kMotion:
        actions_.run(QStringLiteral("motion.open"), arguments);
        actions_.run(QStringLiteral("view.show"), {std::string("motion-editor")});
        break;
      case FileKind::kLog:
        open(file, std::exchange(add, true));
        break;
    }
  }
}

void LogOpening::setRecent(const QStringList& files) {
  recent_ = files.mid(0, kMaxRecent);
  fillRecentMenu();
}

void LogOpening::remember(const QString& file) {
  QStringList files = recent_;
  files.removeAll(file);
  files.prepend(file);
  setRecent(files);
}

void LogOpening::fillRecentMenu() {
  if (recentMenu_ == nullptr) return;
  recentMenu_->clear();
  for (const QString& file : recent_) {
    QAction* action =
        recentMenu_->addAction(QFileInfo(file).fileName(), this, [this, file] { open(file, false); });
    action->setToolTip(file);
  }
  recentMenu_->setEnabled(!recent_.isEmpty());
}

}  // namespace app
