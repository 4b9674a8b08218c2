// SPDX-License-Identifier: GPL-3.0-or-later
// MainWindow: construction, tick, errors, and saving of its state.
#include "app/robotcontrol/MainWindow.h"
#include "app/robotcontrol/docks/MaximizedView.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <QMenu>
#include <QScreen>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "app/core/Workbench.h"
#include "app/core/plugins/Plugins.h"
#include "app/robotcontrol/SceneSpecification.h"
#include "app/robotcontrol/actions/AppearanceMenu.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/actions/LogOpening.h"
#include "app/robotcontrol/actions/PlatformMenus.h"
#include "app/robotcontrol/actions/Shortcuts.h"
#include "app/robotcontrol/actions/WindowKeys.h"
#include "app/robotcontrol/bars/HistoryLine.h"
#include "app/robotcontrol/bars/LeftOpenBar.h"
#include "app/robotcontrol/bars/LogToolBar.h"
#include "app/robotcontrol/bars/RecordingToolBar.h"
#include "app/robotcontrol/bars/RemoteLine.h"
#include "app/robotcontrol/bars/SimulationToolBar.h"
#include "app/robotcontrol/bars/StallWatch.h"
#include "app/robotcontrol/bars/StatusLine.h"
#include "app/robotcontrol/bars/StopToolBar.h"
#include "app/robotcontrol/bars/ToolBarState.h"
#include "app/robotcontrol/commands/CommandPalette.h"
#include "app/robotcontrol/docks/DockSpace.h"
#include "app/robotcontrol/docks/LayoutHistory.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "app/robotcontrol/language/LanguageMenu.h"
#include "app/robotcontrol/remote/RemoteMenus.h"
#include "robotlink/config/FieldDescription.h"
#include "widgets/Counted.h"
#include "widgets/Icon.h"
#include "widgets/ToolBarRegistration.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorFiles.h"
#include "widgets/console/CommandLog.h"
#include "widgets/export/ViewExport.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/motion/GamepadSettings.h"
#include "widgets/motion/ManualSteering.h"
#include "widgets/motions/MotionLink.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/solutions/ParameterSweep.h"

namespace app {
namespace {

constexpr qint64 kKeepEveryMs = 5000;
constexpr int kRefusalShownMs = 10'000;
constexpr int kMaxErrorsShown = 8;
constexpr int kToolBars = 1;  // another number than that of states with other toolbars
constexpr QSize kFirstSize(1600, 1000);
constexpr QSize kFrame(16, 48);  // space for the decorations of the window manager

/// The screen of the offscreen plugin is smaller than any real one, and it is used to take pictures.
QSize firstSize(const QScreen* screen) {
  if (screen == nullptr || QGuiApplication::platformName() == QLatin1String("offscreen")) return kFirstSize;
  return kFirstSize.boundedTo(screen->availableSize() - kFrame);
}

QString toText(const QByteArray& bytes) {
  return QString::fromLatin1(bytes.toBase64());
}
QByteArray fromText(const QJsonValue& value) {
  return QByteArray::fromBase64(value.toString().toLatin1());
}

}  // namespace

MainWindow::MainWindow(Workbench& workbench, const std::filesystem::path& userFolder, Owner owner)
    : workbench_(workbench),
      context_{workbench.session(), workbench.commands(), nullptr, {}},
      perspectives_(userFolder / "window.json"),
      isOfScript_(owner == Owner::kScript) {
  context_.gamepad = std::make_shared<widgets::GamepadSettings>(userFolder / "gamepad.json");
  if (context_.gamepad->problem()) startProblems_.push_back(*context_.gamepad->problem());
  offerSceneFiles();
  context_.layoutOf = [this](const std::string& robot) {
    const LoadedPlatform* loaded = workbench_.loaded();
    return loaded == nullptr ? std::string() : loaded->layoutOf(robot).stem().string();
  };
  context_.bodyOf = [this](const std::string& kind, const QColor& team) { return bodies_.of(kind, team); };
  context_.sceneLanguage =
      std::make_shared<SceneSpecification>([&workbench] { return workbench.modelFolders(); });
  setObjectName(QStringLiteral("mainWindow"));
  setWindowTitle(QStringLiteral("RobotControl"));
  setWindowIcon(widgets::icon("app"));
  createDocks();
  createActions();
  createLogs();
  createErrorBar();
  createMenus();
  createMaximizing();
  createExport();
  connectSignals();
  createPalette();
  restoreWindow();
  const auto& damaged = perspectives_.problems();
  startProblems_.insert(startProblems_.end(), damaged.begin(), damaged.end());
  createColors(userFolder);
  createMotions(userFolder);
  createScenes(userFolder);
  createKeys();
  attachCommands();
  shortcuts_ = new Shortcuts(*keys_, userFolder / "shortcuts.json", *this);
  if (shortcuts_->problem()) startProblems_.push_back(*shortcuts_->problem());
  for (const std::string& problem : pluginProblems())
    startProblems_.push_back({"plugin.failed", "plug-in " + problem, {}, {}});
  showErrors(startProblems_);
}

MainWindow::~MainWindow() {
  tick_.stop();
  workbench_.session().setRefusalHandler({});
  delete export_;        // it has a view, too
  docks_->destroyAll();  // views use the context, which is destroyed before child widgets
  // The focus changes again when the window is hidden by the destructor of QWidget.
  disconnect(qApp, nullptr, this, nullptr);
}

void MainWindow::createActions() {
  actions_ = new CommandActions(workbench_.commands(), this);
  platforms_ = new PlatformMenus(*actions_, workbench_.session(), workbench_.commands(), this);
  toolBar_ = new SimulationToolBar(workbench_, *actions_, this);
  addToolBar(toolBar_);
  recordingBar_ = new RecordingToolBar(workbench_, *actions_, this);
  addToolBar(recordingBar_);
  addToolBar(new StopToolBar(*toolBar_->stopAction(), this));
  addAction(toolBar_->stopAction());
  addRegisteredToolBars();
  for (QAction* action : toolBar_->simulationActions()) addAction(action);
  status_ = new StatusLine(workbench_, *statusBar());
  if (StallWatch::isWanted()) new StallWatch(this, statusBar());
  history_ = new HistoryLine(workbench_, *actions_, *statusBar());
  remote_ = new RemoteMenus(workbench_, *actions_, this);
  remoteLine_ = new RemoteLine(workbench_, *actions_, *statusBar());
  connect(remoteLine_, &RemoteLine::connectionsClicked, remote_, &RemoteMenus::showConnect);
  connect(remoteLine_, &RemoteLine::offerClicked, remote_, &RemoteMenus::showOffer);
}

void MainWindow::addRegisteredToolBars() {
  for (const widgets::ToolBarType& type : widgets::registeredToolBars()) {
    try {
      QToolBar* bar = type.create(context_, this);
      bar->setObjectName(QStringLiteral("toolBar.") + QLatin1String(type.id));
      bar->setWindowTitle(QCoreApplication::translate("View", type.title));
      addToolBar(bar);
    } catch (const std::exception& thrown) {
      startProblems_.push_back(
          {"plugin.tool-bar",
           std::string("the toolbar \"") + type.title + "\" has failed: " + thrown.what(),
           {},
           {}});
    }
  }
}

void MainWindow::createErrorBar() {
  errorBar_ = new QWidget(centralWidget());
  errorBar_->setObjectName(QStringLiteral("errorBar"));
  errorBar_->setStyleSheet(
      QStringLiteral("#errorBar { background: #b3261e; } #errorBar QLabel { color: white; }"));
  errorText_ = new QLabel(errorBar_);
  errorText_->setObjectName(QStringLiteral("errorText"));
  errorText_->setAccessibleName(tr("Errors"));
  errorText_->setWordWrap(true);
  errorText_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* dismiss = new QToolButton(errorBar_);
  dismiss->setObjectName(QStringLiteral("dismissErrors"));
  dismiss->setText(tr("Dismiss"));
  connect(dismiss, &QToolButton::clicked, errorBar_, &QWidget::hide);
  auto* layout = new QHBoxLayout(errorBar_);
  layout->addWidget(errorText_, 1);
  layout->addWidget(dismiss, 0, Qt::AlignTop);
  errorBar_->hide();
  auto* bars = static_cast<QVBoxLayout*>(centralWidget()->layout());
  bars->insertWidget(0, errorBar_);
  leftOpen_ = new LeftOpenBar(workbench_, *actions_, centralWidget());
  bars->insertWidget(1, leftOpen_);
}

void MainWindow::connectSignals() {
  connect(actions_, &CommandActions::refused, this, [this](const QString& reason) {
    showErrors({{"command.refused", reason.toStdString(), {}, {}}});
  });
  connect(actions_, &CommandActions::settled, this, [this] { forgetErrors("command.refused"); });
  workbench_.onLoaded([this](const LoadedPlatform&) { onLoaded(); });
  workbench_.onRemoteRobots([this] { showRobots(); });
  workbench_.onErrors([this](const robotlink::Errors& errors) {
    showErrors(errors);
    platforms_->fail(QString::fromStdString(robotlink::describe(errors)));
    remote_->fail(QString::fromStdString(robotlink::describe(errors)));
    toolBar_->showLoaded();
  });
  workbench_.session().setRefusalHandler([this](const std::string& what, const std::string& reason) {
    const QString text =
        tr("Refused (%1): %2").arg(QString::fromStdString(what), QString::fromStdString(reason));
    statusBar()->showMessage(text, kRefusalShownMs);
    widgets::commandLog(context_).add(widgets::CommandLog::Kind::kError, text);
  });
  connect(&tick_, &QTimer::timeout, this, &MainWindow::tick);
  tick_.start(kWindowTickMs);
  sinceKept_.start();
  sinceLooked_.start();
}

void MainWindow::onLoaded() {
  const auto* loaded = workbench_.loaded();
  errorBar_->hide();
  // Opening something at the start does not resolve these problems.
  showErrors(std::exchange(startProblems_, {}));
  toolBar_->showLoaded();
  simulationMenu_->menuAction()->setVisible(!loaded->isLogged());
  showRobots();
  leftOpen_->noticeOpened();
  if (!loaded->ended.empty()) showEnded(loaded->ended);
  showWhatBelongsTo(*loaded);
}

void MainWindow::showRobots() {
  const LoadedPlatform none;
  const LoadedPlatform& loaded = workbench_.loaded() != nullptr ? *workbench_.loaded() : none;
  const RemoteRobots& remote = workbench_.remote();
  context_.robots = loaded.robots;
  auto field = loaded.field;
  QStringList names;
  for (const std::string& robot : remote.robots()) {
    const KnownRobot known = remote.known(robot);
    if (known.description) context_.robots[robot] = known.description;
    if (!field && !loaded.time) field = known.field;
    names << QString::fromStdString(robot);
  }
  if (field != context_.field) {
    context_.field = std::move(field);
    widgets::colorBench(context_).setField(context_.field.get());
  }
  toolBar_->showRobots();
  const QString opened = QString::fromStdString(loaded.name());
  const QString name = opened.isEmpty() ? names.join(QStringLiteral(", ")) : opened;
  setWindowTitle(name.isEmpty() ? QStringLiteral("RobotControl") : tr("%1 – RobotControl").arg(name));
}

void MainWindow::showEnded(const std::vector<std::string>& reported) {
  constexpr std::size_t kMaxShown = 2;
  QString text;
  for (std::size_t i = 0; i < std::min(reported.size(), kMaxShown); ++i)
    text += QString::fromStdString(reported[i]) + QLatin1Char(' ');
  if (reported.size() > kMaxShown)
    text += widgets::counted(reported.size() - kMaxShown, tr("… and 1 more"), tr("… and %1 more"));
  statusBar()->showMessage(text.trimmed(), kRefusalShownMs);
}

/// Changes the perspective if the current one is the default for what was loaded before; a perspective that
/// the user has chosen stays. Has no effect at the start, when the window is restored as it was.
void MainWindow::showWhatBelongsTo(const LoadedPlatform& loaded) {
  if (showViewsOfScene(loaded) || goesOnEditing(loaded)) return;
  const QString chosen = loaded.sources.empty() ? QString() : perspectives_.chosenFor(loaded.sources.front());
  if (!std::exchange(isPerspectiveWanted_, false) && !chosen.isEmpty()) {
    beginning_ = Perspectives::beginningWith(loaded);
    if (chosen != perspectives_.current()) showPerspective(chosen);
    return;
  }
  const QString beginning = Perspectives::beginningWith(loaded);
  if (beginning.isEmpty()) return;
  const QString before = std::exchange(beginning_, beginning);
  if (!before.isEmpty() && before != beginning && perspectives_.current() == before)
    showPerspective(beginning);
}

void MainWindow::showErrors(const robotlink::Errors& errors) {
  if (errors.empty()) return;
  robotlink::Errors shown(errors.begin(),
                          errors.begin() + std::min<std::ptrdiff_t>(kMaxErrorsShown, std::ssize(errors)));
  QString text = QString::fromStdString(robotlink::describe(shown));
  if (shown.size() < errors.size())
    text += widgets::counted(errors.size() - shown.size(), tr("\n… and 1 more"), tr("\n… and %1 more"));
  errorId_ = errors.front().id;
  widgets::commandLog(context_).add(widgets::CommandLog::Kind::kError, text);
  errorText_->setText(text);
  errorBar_->show();
}

void MainWindow::forgetErrors(const std::string& id) {
  if (errorId_ == id) errorBar_->hide();
}

void MainWindow::tick() {
  workbench_.tick();
  followRenames();
  if (!workbench_.history().isLosing()) forgetErrors("history.slow");
  toolBar_->refresh();
  recordingBar_->refresh();
  tickLogs();
  widgets::colorFiles(context_).tick();
  status_->refresh();
  history_->refresh();
  remoteLine_->refresh();
  tickDocks();
  tickExport();
  widgets::manualSteering(context_).tick();
  widgets::tickMotions(context_);
  widgets::sceneBench(context_).tick();
  sweep_->tick(clock_.now());
  platforms_->tick();
  remote_->tick();
  if (sinceKept_.elapsed() < kKeepEveryMs || maximizedView_->active()) return;
  sinceKept_.restart();
  if (!isOfScript_) keepWindow();
}

void MainWindow::restoreWindow() {
  const QJsonObject window = perspectives_.window();
  isFirstStart_ = window.isEmpty();
  resize(firstSize(screen()));
  create();  // so that floating docks can have it as their parent
  appearance_->load(window);
  language_->load(window);
  platforms_->memory().load(window);
  remote_->load(window);
  opening_->setRecent(window.value(QStringLiteral("recent_logs")).toVariant().toStringList());
  palette_->setRecent(window.value(QStringLiteral("palette")).toVariant().toStringList());
  widgets::commandLog(context_).setHistory(
      window.value(QStringLiteral("command_history")).toVariant().toStringList());
  logToolBar_->timeStampsAction()->setChecked(window.value(QStringLiteral("time_stamps")).toBool());
  perspectives_.show(perspectives_.current(), *docks_);
  layouts_->forget();
  exportChoices_ = window.value(QStringLiteral("export")).toObject();
  leftOpen_->offer(window.value(QStringLiteral("open")).toObject());
  restoreGeometry(fromText(window.value(QStringLiteral("geometry"))));
  const QByteArray toolBars = fromText(window.value(QStringLiteral("toolbars")));
  if (isToolBarState(toolBars)) restoreState(toolBars, kToolBars);
  logToolBar_->hide();  // until a log is open again
  fillPerspectiveMenu();
}

void MainWindow::keepWindow() {
  if (!isOfScript_) noteWindow();
  if (const auto saved = perspectives_.save(); !saved) showErrors({saved.error()});
}

void MainWindow::noteWindow() {
  perspectives_.keep(perspectives_.current(), *docks_);
  if (!shownScene_.empty()) perspectives_.keepFor(shownScene_, *docks_);
  QJsonObject window{{QStringLiteral("geometry"), toText(saveGeometry())},
                     {QStringLiteral("toolbars"), toText(saveState(kToolBars))},
                     {QStringLiteral("recent_logs"), QJsonArray::fromStringList(opening_->recent())},
                     {QStringLiteral("palette"), QJsonArray::fromStringList(palette_->recent())},
                     {QStringLiteral("command_history"),
                      QJsonArray::fromStringList(widgets::commandLog(context_).history())},
                     {QStringLiteral("time_stamps"), logToolBar_->timeStampsAction()->isChecked()},
                     {QStringLiteral("export"), exportChoices_}};
  appearance_->save(window);
  language_->save(window);
  platforms_->memory().save(window);
  remote_->save(window);
  // After a proper end, the next start does not offer to reopen anything.
  if (!isEnding_) window.insert(QStringLiteral("open"), LeftOpenBar::stateOf(workbench_));
  perspectives_.setWindow(window);
}

void MainWindow::keep() {
  isEnding_ = true;
  widgets::openLogs(context_).saveBookmarks();
  if (!isOfScript_) keepWindow();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayLoseColors() || !mayLoseMotion() || !mayLoseScenes()) return event->ignore();
  keep();
  tick_.stop();  // it would save a layout without the floating docks
  dockSpace_->hideFloats();
  QMainWindow::closeEvent(event);
  Q_EMIT closed();
}

bool MainWindow::event(QEvent* event) {
  if (event->type() == QEvent::ApplicationPaletteChange) update();
  return QMainWindow::event(event);
}

}  // namespace app
