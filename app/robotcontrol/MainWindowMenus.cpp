// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: the menus and the functions of their entries.
#include <QActionGroup>
#include <QApplication>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QStatusBar>

#include "app/core/Workbench.h"
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/actions/AppearanceMenu.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/actions/LogOpening.h"
#include "app/robotcontrol/actions/ManualWindow.h"
#include "app/robotcontrol/actions/PlatformMenus.h"
#include "app/robotcontrol/actions/PluginsDialog.h"
#include "app/robotcontrol/actions/ProblemReport.h"
#include "app/robotcontrol/actions/ShortcutsDialog.h"
#include "app/robotcontrol/bars/ColorTableButton.h"
#include "app/robotcontrol/bars/HistoryLine.h"
#include "app/robotcontrol/bars/LightMenu.h"
#include "app/robotcontrol/bars/RecordingToolBar.h"
#include "app/robotcontrol/bars/SimulationToolBar.h"
#include "app/robotcontrol/bars/SnapshotMenu.h"
#include "app/robotcontrol/bars/Tour.h"
#include "app/robotcontrol/docks/LayoutHistory.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "app/robotcontrol/docks/ViewMenu.h"
#include "app/robotcontrol/language/LanguageMenu.h"
#include "app/robotcontrol/remote/RemoteMenus.h"
#include "robotlink/base/Resources.h"
#include "widgets/Icon.h"
#include "widgets/console/CommandLog.h"

namespace app {
namespace {

constexpr int kLanguageShownMs = 15'000;

}  // namespace

void MainWindow::createMenus() {
  createFileMenu();
  createViewMenu();
  createRobotMenus();
  createLogMenu();
  createWindowMenu();
  createHelpMenu();
  // Floating docks are windows of their own, in which the keys of menus must work, too.
  for (const QMenu* menu : menuBar()->findChildren<QMenu*>()) {
    for (QAction* action : menu->actions()) {
      // Keys that play a log are left to WindowKeys, since text fields and lists need some of them.
      if (action->shortcutContext() == Qt::WindowShortcut)
        action->setShortcutContext(Qt::ApplicationShortcut);
    }
  }
}

void MainWindow::createFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  menu->setObjectName(QStringLiteral("fileMenu"));
  addSceneEntries(*menu);
  platforms_->addFiles(*menu);
  platforms_->addForms(*menu, "file");
  menu->addAction(widgets::icon("layout"), tr("Open process la&yout…"), this, &MainWindow::openLayout)
      ->setObjectName(QStringLiteral("file.openLayout"));
  menu->addSeparator();
  opening_->fillMenu(*menu);
  menu->addSeparator();
  menu->addAction(widgets::icon("save"), tr("Save &picture of the window…"), this, &MainWindow::savePicture)
      ->setObjectName(QStringLiteral("file.savePicture"));
  addCopying(*menu);
  menu->addAction(widgets::icon("video"), tr("Export a &view as video or images…"), this,
                  [this] { showExport({}); })
      ->setObjectName(QStringLiteral("file.export"));
  menu->addSeparator();
  menu->addAction(tr("&Quit"), this, &QWidget::close, QKeySequence::Quit)
      ->setObjectName(QStringLiteral("file.quit"));
}

void MainWindow::createViewMenu() {
  menuBar()->addMenu(new ViewMenu(*docks_, this));
}

void MainWindow::createRobotMenus() {
  QMenu* robot = menuBar()->addMenu(tr("&Robot"));
  robot->setObjectName(QStringLiteral("robotMenu"));
  remote_->addConnect(*robot);
  platforms_->addForms(*robot, "robot");
  remote_->addRobots(*robot);
  remote_->addRecordings(*robot);
  remote_->addOffer(*robot);
  robot->addSeparator();
  robot->addAction(toolBar_->stopAction());
  robot->addMenu(history_->menu());
  robot->addSeparator();
  QAction* table = robot->addAction(tr("Load &color table…"), this, &MainWindow::loadColorTable);
  table->setObjectName(QStringLiteral("robot.color-table"));
  table->setToolTip(tr("The selected robot's program uses it from the next image on"));
  QAction* none = robot->addAction(tr("&Use the built-in color table"), this,
                                   [this] { actions_->run(QStringLiteral("robot.no-color-table")); });
  none->setObjectName(QStringLiteral("robot.no-color-table"));
  none->setToolTip(
      tr("The selected robot's program makes a color table from the field's colors, as it does before one is "
         "sent"));
  robot->setToolTipsVisible(true);
  toolBar_->colorTableButton().menu()->addActions({table, none});
  simulationMenu_ = menuBar()->addMenu(tr("&Simulation"));
  simulationMenu_->setObjectName(QStringLiteral("simulationMenu"));
  simulationMenu_->addActions(toolBar_->simulationActions());
  menuBar()->addMenu(recordingBar_->menu());
  QMenu* speed = simulationMenu_->addMenu(tr("S&peed"));
  for (const double value : SimulationToolBar::speeds()) {
    QAction* action = speed->addAction(SimulationToolBar::speedText(value), this, [this, value] {
      actions_->run(QStringLiteral("simulation.speed"), {value});
    });
    action->setObjectName(QStringLiteral("speed.%1").arg(value));
  }
  simulationMenu_->addMenu(new SnapshotMenu(workbench_, *actions_, simulationMenu_));
  simulationMenu_->addMenu(new LightMenu(workbench_, *actions_, simulationMenu_));
}

void MainWindow::createWindowMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Window"));
  perspectiveMenu_ = menu->addMenu(tr("&Perspective"));
  perspectiveMenu_->setObjectName(QStringLiteral("perspectiveMenu"));
  menu->addAction(tr("&Save perspective as…"), this, &MainWindow::savePerspectiveAs)
      ->setObjectName(QStringLiteral("savePerspective"));
  menu->addAction(tr("&Export perspective…"), this, &MainWindow::exportPerspective)
      ->setObjectName(QStringLiteral("exportPerspective"));
  menu->addAction(tr("&Import perspective…"), this, &MainWindow::importPerspective)
      ->setObjectName(QStringLiteral("importPerspective"));
  menu->addAction(tr("&Reset perspective"), this, &MainWindow::resetPerspective)
      ->setObjectName(QStringLiteral("resetPerspective"));
  menu->addSeparator();
  undoLayout_ = menu->addAction(
      widgets::icon("undo"), tr("&Undo layout change"), this, [this] { stepLayout(&LayoutHistory::undo); },
      QKeySequence(QStringLiteral("Ctrl+Shift+U")));
  undoLayout_->setObjectName(QStringLiteral("undoLayout"));
  redoLayout_ = menu->addAction(widgets::icon("redo"), tr("Re&do layout change"), this,
                                [this] { stepLayout(&LayoutHistory::redo); });
  redoLayout_->setObjectName(QStringLiteral("redoLayout"));
  undoLayout_->setEnabled(false);
  redoLayout_->setEnabled(false);
  menu->addSeparator();
  appearance_ = new AppearanceMenu(menu);
  menu->addMenu(appearance_);
  // Existing docks keep the palette with which they were created, so they are created again.
  connect(appearance_, &AppearanceMenu::changed, this, [this] {
    whenDocksRest([this] {
      if (!docks_->empty()) docks_->restore(docks_->save());
    });
  });
  language_ = new LanguageMenu(menu);
  menu->addMenu(language_);
  connect(language_, &LanguageMenu::chosen, this,
          [this](const QString& message) { statusBar()->showMessage(message, kLanguageShownMs); });
}

void MainWindow::createHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  menu->setObjectName(QStringLiteral("helpMenu"));
  QAction* manual = menu->addAction(tr("&Manual"), this, &MainWindow::showManual, QKeySequence::HelpContents);
  manual->setObjectName(QStringLiteral("help.manual"));
  manual->setToolTip(tr("Opens the manual at the page of the focused view"));
  manual->setShortcutContext(Qt::ApplicationShortcut);  // also in floating views
  menu->addAction(tr("&Tour"), this, &MainWindow::showTour)->setObjectName(QStringLiteral("help.tour"));
  menu->addAction(tr("&Keyboard shortcuts…"), this, &MainWindow::showShortcuts,
                  QKeySequence(QStringLiteral("Shift+F1")))
      ->setObjectName(QStringLiteral("help.shortcuts"));
  menu->addAction(tr("&Plug-ins…"), this, &MainWindow::showPlugins)
      ->setObjectName(QStringLiteral("help.plugins"));
  menu->addAction(tr("&Report a problem…"), this, &MainWindow::reportProblem)
      ->setObjectName(QStringLiteral("help.report"));
  menu->addAction(tr("&About RobotControl"), this, &MainWindow::showAbout)
      ->setObjectName(QStringLiteral("help.about"));
}

void MainWindow::showManual() {
  const QString page = manualPageOf(QApplication::focusWidget());
  if (manual_ == nullptr)
    manual_ = new ManualWindow(QString::fromStdString(robotlink::resource("manual").string()), this);
  manual_->showPage(page);
  manual_->show();
  manual_->raise();
  manual_->activateWindow();
}

void MainWindow::showTour() {
  if (tour_ == nullptr) tour_ = new Tour(*this, *docks_);
  tour_->start();
}

void MainWindow::reportProblem() {
  keepWindow();  // so that the report has how the window is arranged now
  ProblemDialog(problemReport(workbench_, widgets::commandLog(context_), perspectives_.window()), this)
      .exec();
}

void MainWindow::openLayout() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open process layout"), {},
                                                    tr("Process layouts (*.yaml);;All files (*)"));
  if (!file.isEmpty()) actions_->run(QStringLiteral("layout.open"), {file.toStdString()});
}

void MainWindow::loadColorTable() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Load color table"), {},
                                   tr("Color tables (*.c64 *.tm *.raw *.cal *.lut *.bz2);;All files (*)"));
  if (!file.isEmpty()) actions_->run(QStringLiteral("robot.color-table"), {file.toStdString()});
}

void MainWindow::savePicture() {
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save picture"), QStringLiteral("robotcontrol.png"), tr("Pictures (*.png)"));
  if (file.isEmpty()) return;
  if (const auto saved = saveScreenshot("window", file.toStdString()); !saved) showErrors({saved.error()});
}

void MainWindow::showShortcuts() {
  ShortcutsDialog(*shortcuts_, this).exec();
}

void MainWindow::showPlugins() {
  PluginsDialog(this).exec();
}

void MainWindow::showAbout() {
  QMessageBox::about(
      this, tr("About RobotControl"),
      tr("<b>RobotControl %1</b><p>A workbench for developing and debugging the control programs of "
         "robots.</p><p>Free software under the GNU General Public License, version 3 or later.</p>")
          .arg(QApplication::applicationVersion()));
}

}  // namespace app
