// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/PlatformMenus.h"

#include <QFileDialog>
#include <QKeySequence>
#include <QMenu>
#include <algorithm>

#include "app/core/platform/PlatformAdapter.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/actions/FieldEditor.h"
#include "app/robotcontrol/actions/PlatformDialog.h"
#include "widgets/Icon.h"

namespace app {
namespace {

/// The entry of a menu as the title of its dialog: "&Open scene…" is "Open scene".
QString titleOf(const QString& entry) {
  QString title = entry;
  return title.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
}

}  // namespace

PlatformMenus::PlatformMenus(CommandActions& actions, robotlink::Session& session,
                             robotlink::CommandTable& commands, QWidget* window)
    : QObject(window), actions_(actions), session_(session), commands_(commands), window_(window) {}

void PlatformMenus::addFiles(QMenu& menu) {
  bool first = true;
  for (const PlatformAdapter& adapter : platformAdapters()) {
    if (adapter.fileEntry == nullptr) continue;
    QAction* action = menu.addAction(widgets::icon("open"), formText(adapter.fileEntry), this,
                                     [this, &adapter] { openFile(adapter); });
    action->setObjectName(QLatin1String(adapter.command));
    if (std::exchange(first, false)) action->setShortcuts(QKeySequence::Open);
  }
}

void PlatformMenus::addForms(QMenu& menu, const std::string& name) {
  for (const PlatformAdapter& adapter : platformAdapters()) {
    const PlatformForm form = formOf(adapter);
    if (form.menu != name) continue;
    QAction* action = menu.addAction(
        widgets::icon(form.icon.c_str()), formText(form.entry), this, [this, &adapter] { showForm(adapter); },
        QKeySequence(QString::fromStdString(form.keys)));
    action->setObjectName(QString::fromStdString(form.action));
    action->setToolTip(formText(form.entryHelp));
  }
}

void PlatformMenus::openFile(const PlatformAdapter& adapter) {
  const QString file =
      QFileDialog::getOpenFileName(window_, titleOf(formText(adapter.fileEntry)), {},
                                   formText(adapter.fileFilter) + QStringLiteral(";;") + tr("All files (*)"));
  if (!file.isEmpty()) actions_.run(QLatin1String(adapter.command), {file.toStdString()});
}

void PlatformMenus::showForm(const PlatformAdapter& adapter) {
  const PlatformForm form = formOf(adapter);
  if (form.connects) return showConnecting(adapter);
  PlatformDialog dialog(form, session_, commands_, memory_, window_);
  if (dialog.exec() == QDialog::Accepted)
    actions_.run(QString::fromStdString(form.command), dialog.arguments());
}

void PlatformMenus::showConnecting(const PlatformAdapter& adapter) {
  const PlatformForm form = formOf(adapter);
  if (!actions_.mayRun(QString::fromStdString(form.command))) return;
  auto known = std::find_if(dialogs_.begin(), dialogs_.end(),
                            [&](const PlatformDialog* dialog) { return dialog->form().name == form.name; });
  if (known == dialogs_.end())
    known = dialogs_.insert(known, new PlatformDialog(form, session_, commands_, memory_, window_));
  (*known)->show();
  (*known)->raise();
  (*known)->activateWindow();
}

void PlatformMenus::tick() {
  for (PlatformDialog* dialog : dialogs_) dialog->tick();
}

void PlatformMenus::fail(const QString& reason) {
  for (PlatformDialog* dialog : dialogs_) dialog->fail(reason);
}

}  // namespace app
