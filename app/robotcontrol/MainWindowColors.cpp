// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: what is unsaved of color tables and motions, its recovery, and maximizing a view.
#include <QMenu>
#include <QStatusBar>

#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/docks/DockSpace.h"
#include "app/robotcontrol/docks/MaximizedView.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorCommands.h"
#include "widgets/color/ColorFileActions.h"
#include "widgets/color/ColorFiles.h"
#include "widgets/motions/MotionFiles.h"

namespace app {
namespace {

constexpr int kMessageShownMs = 15'000;

}  // namespace

void MainWindow::createColors(const std::filesystem::path& userFolder) {
  widgets::addColorCommands(context_);
  auto& files = widgets::colorFiles(context_);
  connect(&files.bench(), &widgets::ColorBench::failed, this, [this](const QString& reason) {
    showErrors({{"color.failed", reason.toStdString(), {}, {}}});
  });
  connect(&files.bench(), &widgets::ColorBench::settled, this, [this] { forgetErrors("color.failed"); });
  connect(&files, &widgets::ColorFiles::reported, this, [this](const QString& text) {
    forgetErrors("color.failed");
    statusBar()->showMessage(text.section(QLatin1Char('\n'), 0, 0), kMessageShownMs);
  });
  if (!isOfScript_) files.startRecovery(userFolder / "colors");
}

void MainWindow::createMotions(const std::filesystem::path& userFolder) {
  auto& files = widgets::motionFiles(context_);
  connect(&files, &widgets::MotionFiles::reported, this, [this](const QString& text, bool bad) {
    if (bad)
      showErrors({{"motion.failed", text.toStdString(), {}, {}}});
    else
      statusBar()->showMessage(text.section(QLatin1Char('\n'), 0, 0), kMessageShownMs);
    if (!bad) forgetErrors("motion.failed");
  });
  if (!isOfScript_) files.startRecovery(userFolder / "motions");
}

bool MainWindow::mayLoseMotion() {
  auto& files = widgets::motionFiles(context_);
  if (!widgets::mayLoseMotion(files, this)) return false;
  files.forget();
  return true;
}

void MainWindow::createMaximizing() {
  maximizedView_ = new MaximizedView(*dockSpace_, this);
  // The maximized view is restored before places are read, so that all views keep their places.
  connect(docks_, &ViewDocks::placesWanted, maximizedView_, &MaximizedView::restore);
  auto* menu = qobject_cast<QMenu*>(perspectiveMenu_->parent());
  auto* action = new QAction(tr("&Maximize or restore view"), this);
  action->setObjectName(QStringLiteral("maximizeView"));
  action->setShortcut(Qt::Key_F11);
  action->setToolTip(
      tr("Maximizes the view that was used last or is under the mouse; a second time restores the layout"));
  connect(action, &QAction::triggered, maximizedView_, &MaximizedView::toggle);
  addAction(action);
  if (menu != nullptr) menu->insertAction(perspectiveMenu_->menuAction(), action);
}

bool MainWindow::mayLoseColors() {
  auto& files = widgets::colorFiles(context_);
  if (!widgets::mayLoseSamples(files, this)) return false;
  files.discard();
  return true;
}

}  // namespace app
