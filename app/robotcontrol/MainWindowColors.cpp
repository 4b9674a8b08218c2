// SPDX-License-Identifier: GPL-3.0-or-later
// What the main window does with the colour table that is being made: commands, recovery, unsaved samples.
#include <QStatusBar>

#include "app/core/Workbench.h"
#include "app/robotcontrol/MainWindow.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorCommands.h"
#include "widgets/color/ColorFileActions.h"
#include "widgets/color/ColorFiles.h"

namespace app {
namespace {

constexpr int kToldShownMs = 15'000;

}  // namespace

void MainWindow::createColors(const std::filesystem::path& userFolder) {
  widgets::addColorCommands(context_);
  auto& files = widgets::colorFiles(context_);
  connect(&files.bench(), &widgets::ColorBench::failed, this, [this](const QString& reason) {
    showErrors({{"color.failed", reason.toStdString(), {}, {}}});
  });
  connect(&files, &widgets::ColorFiles::told, this, [this](const QString& text) {
    statusBar()->showMessage(text.section(QLatin1Char('\n'), 0, 0), kToldShownMs);
  });
  files.startRecovery(userFolder / "colors");
}

bool MainWindow::mayLoseColors() {
  auto& files = widgets::colorFiles(context_);
  if (!widgets::mayLoseSamples(files, this)) return false;
  files.discard();
  return true;
}

}  // namespace app
