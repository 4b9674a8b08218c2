// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>

#include "app/robotcontrol/Appearance.h"
#include "app/robotcontrol/Perspectives.h"
#include "robotlink/base/Error.h"
#include "robotlink/session/CommandTable.h"
#include "widgets/View.h"

class QLabel;
class QMenu;
namespace widgets {
class ConnectDialog;
class EmptyHint;
}  // namespace widgets

namespace app {

class CommandActions;
class DockSpace;
class LayoutHistory;
class LogOpening;
class MaximizedView;
class LogToolBar;
class LogContentsBar;
class OpeningBar;
class RecordedBar;
class RecordingToolBar;
class SimulationToolBar;
class StatusLine;
class UndoOrder;
class ViewDocks;
class WindowKeys;
class Workbench;
struct LoadedPlatform;

/// The workbench's window: docks with views, toolbars, menus, status line; and the 30 Hz tick that all of
/// them live by.
///
/// What the user arranged is kept in a file of his, every few seconds and at the end, and comes back at the
/// next start. GUI thread; the workbench must outlive it.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  MainWindow(Workbench& workbench, const std::filesystem::path& userFolder);
  ~MainWindow() override;

  void showPerspective(const QString& name);
  /// What its views share.
  const widgets::ViewContext& context() const { return context_; }
  /// Takes in what is new, now; the timer calls it.
  void tick();
  /// Errors of a file that could not be used, above the views until they are dismissed.
  void showErrors(const robotlink::Errors& errors);
  ViewDocks& docks() { return *docks_; }
  /// What the user arranged and marked, in files; as when the window is closed, but without a question.
  void keep();

 Q_SIGNALS:
  /// The user closed it, and the program ends: floating docks and dialogs go with it.
  void closed();

 protected:
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  bool event(QEvent* event) override;
  /// What no view wanted: the keys that play a log.
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void createDocks();
  void tickDocks();
  /// Runs now, or as soon as no dock is being dragged or dropped and no menu or dialog is open.
  void whenDocksRest(std::function<void()> change);
  void resetPerspective();
  void deletePerspective();
  void createActions();
  void createLogs();
  void addBookmarkCommand();
  void addViewCommand();
  void createColors(const std::filesystem::path& userFolder);
  void createMaximizing();
  void createKeys();
  void addReplayKeys();
  void addColorKeys();
  void addEditingKeys();
  /// One of them may be below the widget.
  void findUndoStacks(QWidget* widget);
  bool showsColors() const;
  void saveWork();
  bool mayReplace(const QString& command);
  bool mayLoseColors();
  void createErrorBar();
  void createMenus();
  void createFileMenu();
  void createViewMenu();
  void createRobotMenus();
  void connectRobot();
  void createLogMenu();
  void createWindowMenu();
  void createAppearanceMenu(QMenu& menu);
  void createHelpMenu();
  void fillPerspectiveMenu();
  void connectSignals();
  void tickLogs();
  void restoreWindow();
  void keepWindow();
  void openScene();
  void setUpSimulation();
  void openLayout();
  void loadColorTable();
  void savePicture();
  void savePerspectiveAs();
  void setAppearance(Appearance appearance);
  void showShortcuts();
  void showAbout();
  void onLoaded();
  void showWhatBelongsTo(const LoadedPlatform& loaded);

  Workbench& workbench_;
  widgets::ViewContext context_;
  Perspectives perspectives_;
  QString beginning_;  // where people begin with what was loaded last; empty: nothing was
  Appearance appearance_ = Appearance::kSystem;
  std::vector<robotlink::CommandTable::Value> lastSetup_;  // of SimulationSetupDialog
  CommandActions* actions_ = nullptr;
  DockSpace* dockSpace_ = nullptr;
  WindowKeys* keys_ = nullptr;
  UndoOrder* undoOrder_ = nullptr;
  ViewDocks* docks_ = nullptr;
  LayoutHistory* layouts_ = nullptr;
  QAction* undoLayout_ = nullptr;
  QAction* redoLayout_ = nullptr;
  widgets::EmptyHint* noViews_ = nullptr;
  SimulationToolBar* toolBar_ = nullptr;
  RecordingToolBar* recordingBar_ = nullptr;
  LogToolBar* logToolBar_ = nullptr;
  MaximizedView* maximizedView_ = nullptr;
  LogOpening* opening_ = nullptr;
  OpeningBar* openingBar_ = nullptr;
  RecordedBar* recordedBar_ = nullptr;
  LogContentsBar* contentsBar_ = nullptr;
  widgets::ConnectDialog* connectDialog_ = nullptr;  // from the first time it is wanted
  QStringList recentRobots_;                         // addresses, newest first
  QString robotMap_;
  StatusLine* status_ = nullptr;
  QWidget* errorBar_ = nullptr;
  QLabel* errorText_ = nullptr;
  QMenu* simulationMenu_ = nullptr;
  QMenu* perspectiveMenu_ = nullptr;
  QTimer tick_;
  QElapsedTimer sinceKept_;
  QElapsedTimer sinceLooked_;  // at the layout
};

}  // namespace app
