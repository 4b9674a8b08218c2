// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QJsonObject>
#include <QMainWindow>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>

#include "app/robotcontrol/RobotBodies.h"
#include "app/robotcontrol/docks/Perspectives.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/process/Link.h"
#include "widgets/View.h"

class QLabel;
class QMenu;
namespace ads {
class CDockWidget;
}
namespace widgets {
class EmptyHint;
class ExportBar;
class ParameterEdits;
class ParameterSweep;
class SceneView;
class ViewExport;
}  // namespace widgets

namespace app {

class AppearanceMenu;
class CommandActions;
class CommandPalette;
class DockSpace;
class HistoryLine;
class LanguageMenu;
class LayoutHistory;
class LogOpening;
class ManualWindow;
class MaximizedView;
class LogToolBar;
class LeftOpenBar;
class LogContentsBar;
class OpeningBar;
class PlatformMenus;
class RecordedBar;
class RecordingToolBar;
class RemoteLine;
class RemoteMenus;
class Shortcuts;
class SimulationToolBar;
class StatusLine;
class Tour;
class UndoOrder;
class ViewDocks;
class WindowKeys;
class Workbench;
struct LoadedPlatform;

/// The time between two ticks, about 30 Hz; less while a view is exported, which should not take
/// longer than it must.
inline constexpr int kWindowTickMs = 33, kExportingTickMs = 2;

/// The main window of the workbench: docks with views, toolbars, menus, status line, and the 30 Hz tick that
/// updates all of them. It creates all its parts and connects them; MainWindow*.cpp group its functions by
/// topic.
///
/// What the user arranged is saved to a file in the user's folder, every few seconds and at the end, and
/// restored at the next start. GUI thread; the workbench must outlive it.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// The owner of the window. A script's window keeps nothing for the next start but perspectives that are
  /// saved by name: neither how it is arranged nor what is unsaved; and what others left unsaved is not
  /// restored in it.
  enum class Owner : std::uint8_t { kUser, kScript };
  /// `userFolder`: the folder of the file and of recovered color samples, motions and scenes.
  MainWindow(Workbench& workbench, const std::filesystem::path& userFolder, Owner owner = Owner::kUser);
  ~MainWindow() override;

  /// Shows a perspective as soon as no dock is being dragged; the current one is saved first.
  void showPerspective(const QString& name);
  /// Shows a perspective that the user has chosen. It is shown again whenever the present scene or log is
  /// opened; before anything is open, it stays when something is.
  void choosePerspective(const QString& name);
  /// The context that all views share.
  const widgets::ViewContext& context() const { return context_; }
  widgets::ViewContext& context() { return context_; }
  /// Processes new messages and updates the visible views now; the timer calls it.
  void tick();
  /// Shows errors above the views until they are dismissed or something else is loaded.
  void showErrors(const robotlink::Errors& errors);
  /// Hides errors that are no longer true, if they have this id.
  void forgetErrors(const std::string& id);
  /// The docks, for tests and pictures.
  ViewDocks& docks() { return *docks_; }
  /// All keys, and those that the user has chosen.
  Shortcuts& shortcuts() { return *shortcuts_; }
  /// Whether nothing was saved by an earlier start.
  bool isFirstStart() const { return isFirstStart_; }
  /// Explains the parts of the window one after the other.
  void showTour();
  /// Saves bookmarks and layout, as closing the window does, but without asking about unsaved samples. To be
  /// called before the program ends.
  void keep();
  /// Saves what the user arranged and what is open, for the case of a crash; the timer calls it.
  void keepWindow();

 Q_SIGNALS:
  /// The user closed the window, so that the program ends, together with floating docks and dialogs.
  void closed();

 protected:
  /// Shows floating docks again once the window is visible.
  void showEvent(QShowEvent* event) override;
  /// Asks about unsaved samples, then saves the layout; ignored if the user cancels.
  void closeEvent(QCloseEvent* event) override;
  /// Repaints after a change of the palette.
  bool event(QEvent* event) override;
  /// Handles keys that views have ignored: those that play a log.
  void keyPressEvent(QKeyEvent* event) override;
  /// Handles those keys in floating windows, which are windows of their own.
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// dragEnterEvent() and dropEvent() accept files, see LogOpening::drop(); with Ctrl, logs are added to the
  /// open ones.
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  /// Docks and perspectives (MainWindowDocks.cpp).
  void createDocks();
  /// Updates the visible views, and from time to time the history of the layout.
  void tickDocks();
  /// Calls a function now, or as soon as no dock is being dragged or dropped and no menu or dialog is open.
  void whenDocksRest(std::function<void()> change);
  /// Shows the current perspective as it is shipped; can be undone.
  void resetPerspective();
  /// Toolbars of simulation and recording, and the status line.
  void createActions();
  /// Toolbar and bars for logs, and their connections (MainWindowLogs.cpp).
  void createLogs();
  /// Attaches the commands about bookmarks of logs.
  void addBookmarkCommands();
  /// Commands about the window and its views, and the palette (MainWindowCommands.cpp).
  using WindowCommand =
      std::function<robotlink::Result<void>(MainWindow&, const robotlink::CommandTable::Values&)>;
  void attachCommands();
  void attach(const char* name, WindowCommand run, robotlink::CommandTable::Offer offer = {});
  void attachViewCommands();
  void attachPerspectiveCommands();
  void attachAppearanceCommands();
  void attachPlotCommands();
  void attachSearchCommands();
  void createPalette();
  /// Export of views as videos and images (MainWindowExport.cpp).
  void createExport();
  void attachExportCommands();
  /// Commands about what views show (MainWindowViews.cpp).
  void attachPictureCommands();
  void attachPoseCommand();
  void attachDataCommands();
  void attachToolCommands();
  /// Commands about views of a scene, copies of views, and the scene's files (MainWindowScene.cpp).
  void attachSceneCommands();
  void attachSceneViewCommands();
  /// Runs something for a view of the scene, or for all that are open, one of which is opened if there is
  /// none.
  robotlink::Result<void> inSceneViews(
      const std::string& name, const std::function<robotlink::Result<void>(widgets::SceneView&)>& run);
  /// Copies what a view shows, which is opened if need be; an empty name is the view in focus.
  robotlink::Result<void> copyView(const std::string& id, bool asNumbers);
  void addCopying(QMenu& menu);
  /// Lets views write changes into the files of the open scene.
  void offerSceneFiles();
  /// The view of the name that commands use, opened if need be. Fails if it is not of this class.
  template <typename V>
  robotlink::Result<V*> openAs(const std::string& name);
  /// Asks what is to be exported; `name`: the dock to begin with, empty: the one in focus.
  void showExport(const QString& name);
  /// Runs export.video (or export.images) with checked values.
  robotlink::Result<void> exportView(bool isVideo, const robotlink::CommandTable::Values& values);
  /// Goes on with an export, and shows its progress.
  void tickExport();
  void createPresets(widgets::ParameterEdits& parameters);
  void createSweep(widgets::ParameterEdits& parameters);
  /// Brings a view to the front and opens it if needed. Fails if there is none of this name.
  robotlink::Result<ads::CDockWidget*> openView(const std::string& id);
  /// Writes a PNG file of a view, or of the "window".
  /// Ends when what is visible has drawn what it shows now, or after a few seconds.
  void finishPictures(QWidget& shown);
  robotlink::Result<void> saveScreenshot(const std::string& view, const std::string& file);
  /// Writes what a view, which is opened if need be, can save.
  robotlink::Result<void> saveView(const std::string& id, const std::string& file);
  /// The first open view of a kind; null if there is none. shownView() opens one then.
  template <typename V>
  V* findView(const char* id) const;
  template <typename V>
  V* shownView(const char* id);
  /// Undoes or redoes a change of the layout.
  void stepLayout(void (LayoutHistory::*step)());
  /// Saves the layout as a perspective. Fails if the name is empty.
  robotlink::Result<void> savePerspective(const QString& name);
  /// Writes the shown perspective to a file, and shows that of a file.
  robotlink::Result<void> writePerspective(const std::filesystem::path& file);
  robotlink::Result<void> readPerspective(const std::filesystem::path& file);
  /// Removes a perspective of the user; Play is shown if it was the current one. Fails for shipped ones.
  robotlink::Result<void> removePerspective(const QString& name);
  /// Commands and recovery of color samples; `userFolder` is the folder for the recovery.
  void createColors(const std::filesystem::path& userFolder);
  /// Recovery of the motion that is edited.
  void createMotions(const std::filesystem::path& userFolder);
  /// Recovery of the scene files that are edited (MainWindowScenes.cpp).
  void createScenes(const std::filesystem::path& userFolder);
  void addSceneEntries(QMenu& menu);
  /// Maximizing a view by F11.
  void createMaximizing();
  /// Keys that work in the whole window (MainWindowKeys.cpp).
  void createKeys();
  void addReplayKeys();
  void addColorKeys();
  void addEditingKeys();
  /// Registers the undo stacks of a widget and its parents with undoOrder_.
  void findUndoStacks(QWidget* widget);
  /// Whether a color view is visible; only then digits select classes.
  bool showsColors() const;
  /// Saves bookmarks, color samples, and the motion and scene files that are edited (Ctrl+S).
  void saveWork();
  /// Asks the user before a command replaces what is open while there are unsaved samples. Returns whether to
  /// continue.
  bool mayReplace(const QString& command);
  /// Asks the user before unsaved samples would be lost at the end.
  bool mayLoseColors();
  /// The same for the motion and the scene files that are edited.
  bool mayLoseMotion();
  bool mayLoseScenes();
  /// Makes the views and the selection follow an object of the scene that was renamed.
  void followRenames();
  /// The bar above the views that shows errors.
  void addRegisteredToolBars();
  void createErrorBar();
  /// Menus and their commands (MainWindowMenus.cpp).
  void createMenus();
  void createFileMenu();
  void createViewMenu();
  void createRobotMenus();
  void createLogMenu();
  void createWindowMenu();
  void createHelpMenu();
  /// Rebuilds the menu of perspectives after one was added, removed or shown.
  void fillPerspectiveMenu();
  void connectSignals();
  /// Updates everything that concerns logs and recordings.
  void tickLogs();
  /// Reads the file with everything that the user arranged, which keepWindow() writes.
  void restoreWindow();
  /// Takes up how everything is arranged now.
  void noteWindow();
  /// The functions of menu entries.
  void openLayout();
  void loadColorTable();
  void savePicture();
  void savePerspectiveAs();
  void exportPerspective();
  void importPerspective();
  void showShortcuts();
  /// Shows the manual's page of the view that has the focus.
  void showManual();
  void reportProblem();
  void showPlugins();
  void showAbout();
  /// Called when the workbench has loaded another platform.
  void onLoaded();
  /// Updates what views know of local and remote robots, and the title.
  void showRobots();
  /// Shows for a moment what the platform that ran before reported about its end.
  void showEnded(const std::vector<std::string>& reported);
  /// Changes to the perspective for what was loaded, unless the user has chosen another one.
  void showWhatBelongsTo(const LoadedPlatform& loaded);
  /// Keeps the views of the scene before, and shows those with which this one was left. False: it is the same
  /// one, or none that was left.
  bool showViewsOfScene(const LoadedPlatform& loaded);
  /// Whether what was opened is the scene that is edited, and both editor and scene are shown already: then
  /// the window stays as it is.
  bool goesOnEditing(const LoadedPlatform& loaded);

  Workbench& workbench_;
  /// Refers to the session; destroyed before the widgets that are children of the window, see the destructor.
  widgets::ViewContext context_;
  /// Used by the context.
  RobotBodies bodies_;
  Perspectives perspectives_;
  /// The default perspective for what was loaded last; empty: nothing was loaded.
  QString beginning_;
  /// The file of the simulated scene whose views are shown; empty: none.
  std::string shownScene_;
  /// The objects of the scene when followRenames() was called last.
  robotlink::PackagePtr objects_;
  /// The robot that was selected then, and whether it has another name now under which it is still to be
  /// selected.
  std::string selectedRobot_;
  bool isRobotRenamed_ = false;
  /// Whether a perspective was chosen for what is opened next.
  bool isPerspectiveWanted_ = false;
  /// Whether the window closes, so that nothing that is open was left so by a crash.
  bool isEnding_ = false;
  const bool isOfScript_;
  bool isFirstStart_ = false;
  /// The parts of the window; Qt owns them as children.
  CommandActions* actions_ = nullptr;
  AppearanceMenu* appearance_ = nullptr;
  LanguageMenu* language_ = nullptr;
  DockSpace* dockSpace_ = nullptr;
  WindowKeys* keys_ = nullptr;
  Shortcuts* shortcuts_ = nullptr;
  UndoOrder* undoOrder_ = nullptr;
  CommandPalette* palette_ = nullptr;
  widgets::ParameterSweep* sweep_ = nullptr;
  widgets::ViewExport* export_ = nullptr;
  widgets::ExportBar* exportBar_ = nullptr;
  /// The choices that the user made in the export dialog.
  QJsonObject exportChoices_;
  /// Null until they are shown for the first time.
  ManualWindow* manual_ = nullptr;
  Tour* tour_ = nullptr;
  ViewDocks* docks_ = nullptr;
  LayoutHistory* layouts_ = nullptr;
  /// Entries of the window menu that are enabled by tickDocks().
  QAction* undoLayout_ = nullptr;
  QAction* redoLayout_ = nullptr;
  /// The text that is shown while no view is open.
  widgets::EmptyHint* noViews_ = nullptr;
  /// Toolbars and bars, see their classes.
  SimulationToolBar* toolBar_ = nullptr;
  RecordingToolBar* recordingBar_ = nullptr;
  LogToolBar* logToolBar_ = nullptr;
  MaximizedView* maximizedView_ = nullptr;
  LogOpening* opening_ = nullptr;
  PlatformMenus* platforms_ = nullptr;
  OpeningBar* openingBar_ = nullptr;
  RecordedBar* recordedBar_ = nullptr;
  LeftOpenBar* leftOpen_ = nullptr;
  LogContentsBar* contentsBar_ = nullptr;
  StatusLine* status_ = nullptr;
  HistoryLine* history_ = nullptr;
  RemoteMenus* remote_ = nullptr;
  RemoteLine* remoteLine_ = nullptr;
  QWidget* errorBar_ = nullptr;
  QLabel* errorText_ = nullptr;
  /// The id of the first error that is shown.
  std::string errorId_;
  /// The errors that occurred before anything was opened.
  robotlink::Errors startProblems_;
  QMenu* simulationMenu_ = nullptr;
  QMenu* perspectiveMenu_ = nullptr;
  const robotlink::SteadyClock clock_;
  /// Fires at about 30 Hz.
  QTimer tick_;
  /// Time since the last save.
  QElapsedTimer sinceKept_;
  /// Time since the last call of LayoutHistory::look().
  QElapsedTimer sinceLooked_;
};

}  // namespace app
