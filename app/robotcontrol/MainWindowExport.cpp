// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: export of views as videos and series of images.
#include <qtadvanceddocking/DockWidget.h>
#include <QApplication>
#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>

#include "app/core/Workbench.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "widgets/export/ExportBar.h"
#include "widgets/export/ExportDialog.h"
#include "widgets/export/ViewExport.h"
#include "widgets/log/OpenLogs.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;
using Values = robotlink::CommandTable::Values;

/// The view in a dock; null if there is none.
widgets::View* viewIn(const ads::CDockWidget& dock) {
  return qobject_cast<widgets::View*>(dock.widget());
}

/// "field" of "field#2".
QString kindOf(const ads::CDockWidget& dock) {
  return dock.objectName().section(QLatin1Char('#'), 0, 0);
}

/// The dock that has the focus; empty: none.
QString focusedDock() {
  for (QWidget* widget = QApplication::focusWidget(); widget != nullptr; widget = widget->parentWidget()) {
    if (const auto* dock = qobject_cast<const ads::CDockWidget*>(widget)) return dock->objectName();
  }
  return {};
}

}  // namespace

void MainWindow::createExport() {
  export_ = new widgets::ViewExport(context_, this);
  exportBar_ = new widgets::ExportBar(*export_, centralWidget());
  static_cast<QVBoxLayout*>(centralWidget()->layout())->insertWidget(0, exportBar_);
  workbench_.addJob(
      [exporting = QPointer(export_)] { return exporting ? exporting->working() : Result<bool>(false); });
  connect(docks_, &ViewDocks::exportWanted, this, &MainWindow::showExport);
}

void MainWindow::attachExportCommands() {
  const auto names = [window = QPointer(this)](const std::vector<std::string>& before) {
    std::vector<std::string> all;
    if (!before.empty() || !window) return all;
    for (const ads::CDockWidget* dock : window->docks_->openDocks()) {
      const QString name = dock->objectName();
      all.push_back((name.endsWith(QLatin1String("#1")) ? kindOf(*dock) : name).toStdString());
    }
    return all;
  };
  const auto video = [](MainWindow& window, const Values& values) { return window.exportView(true, values); };
  const auto images = [](MainWindow& window, const Values& values) {
    return window.exportView(false, values);
  };
  attach("export.video", video, names);
  attach("export.images", images, names);
  attach("export.cancel", [](MainWindow& window, const Values&) -> Result<void> {
    if (!window.export_->isBusy()) return failure("export.none", "nothing is being exported");
    window.export_->cancel();
    return {};
  });
}

Result<void> MainWindow::exportView(bool isVideo, const Values& values) {
  const auto text = [&values](std::size_t index) { return std::get<std::string>(values[index]); };
  widgets::openLogs(context_).tick();  // processes a log that was opened just now
  auto& replay = widgets::openLogs(context_).replay();
  widgets::ExportPlan plan;
  plan.kind = isVideo ? widgets::ExportPlan::Kind::kVideo : widgets::ExportPlan::Kind::kImages;
  plan.target = text(1);
  plan.rate = std::get<double>(values[4]);
  const auto from = widgets::instantOf(text(2), context_.session, replay);
  const auto to = widgets::instantOf(text(3), context_.session, replay);
  for (const auto* each : {&from, &to}) {
    if (!*each) return tl::unexpected(each->error());
  }
  plan.from = *from;
  plan.to = *to;
  const auto dock = openView(text(0));
  if (!dock) return tl::unexpected(dock.error());
  const widgets::View* view = viewIn(**dock);
  if (view == nullptr) return failure("export.view", "there is nothing to export in this view");
  const auto size = widgets::sizeOf(text(5), view->shownPictureSize());
  if (!size) return tl::unexpected(size.error());
  plan.size = *size;
  plan.name = text(0);
  std::ranges::replace(plan.name, '#', '-');
  return export_->start(kindOf(**dock), *view, plan);
}

void MainWindow::showExport(const QString& name) {
  if (findChild<widgets::ExportDialog*>() != nullptr) return;
  std::vector<widgets::ExportDialog::Offer> offers;
  for (const ads::CDockWidget* dock : docks_->openDocks()) {
    if (const widgets::View* view = viewIn(*dock))
      offers.push_back({dock->objectName(), dock->windowTitle(), view->shownPictureSize()});
  }
  auto& replay = widgets::openLogs(context_).replay();
  if (offers.empty() || !widgets::exportable(context_.session, replay))
    return showErrors(
        {{"export.nothing",
          offers.empty() ? "no view is open that could be exported"
                         : "there is nothing to export: start a simulation, connect to a robot, "
                           "or open a log",
          {},
          {}}});
  // The timeline has no picture worth a video; it offers those of the others.
  const QString wanted = name.isEmpty() ? focusedDock() : name;
  const QString chosen = wanted.startsWith(QLatin1String("time-line")) ? QString() : wanted;
  auto* dialog =
      new widgets::ExportDialog(std::move(offers), chosen, context_.session, replay, exportChoices_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &widgets::ExportDialog::exportWanted, this, [this, dialog] {
    const auto answer = dialog->answer();
    const auto done = workbench_.commands().run(
        answer.isVideo ? "export.video" : "export.images",
        {answer.view, answer.target, answer.from, answer.to, answer.rate, answer.size});
    if (!done) return dialog->setProblem(QString::fromStdString(done.error().describe()));
    exportChoices_ = dialog->choices();
    dialog->accept();
  });
  dialog->open();
}

void MainWindow::tickExport() {
  export_->tick();
  exportBar_->tick();
  const int interval = export_->isBusy() ? kExportingTickMs : kWindowTickMs;
  if (tick_.interval() != interval) tick_.setInterval(interval);
}

}  // namespace app
