// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/SimulationToolBar.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QResizeEvent>
#include <cmath>
#include <set>

#include "app/core/Workbench.h"
#include "app/core/program/ShippedFiles.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/bars/ColorTableButton.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "widgets/Controls.h"
#include "widgets/Icon.h"
#include "widgets/RobotChoice.h"
#include "widgets/steering/StopStyle.h"

namespace app {
namespace {

QComboBox* makeBox(QToolBar* bar, const char* name, const QString& accessible, const QString& tip) {
  auto* box = new QComboBox(bar);
  widgets::describe(*box, {name, accessible, tip});
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  return box;
}

void addFiles(QComboBox* box, const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) {
    box->addItem(QString::fromStdString(file.stem().string()), QString::fromStdString(file.string()));
  }
}

/// In narrower windows the boxes have no captions, but tooltips: what is recorded needs the room. Pixels.
constexpr int kRoomyWindow = 1700;

/// The entry of a file, however its path is written; -1: it has none.
int entryOf(const QComboBox& box, const std::filesystem::path& file) {
  std::error_code isMissing;
  for (int i = 0; i < box.count(); ++i) {
    const std::filesystem::path listed = box.itemData(i).toString().toStdString();
    if (listed == file || std::filesystem::equivalent(listed, file, isMissing)) return i;
  }
  return -1;
}

/// Selects a file, which is added if it is not among the shipped ones; without a file the placeholder is
/// shown.
void selectFile(QComboBox* box, const std::filesystem::path& file) {
  if (!file.empty() && entryOf(*box, file) < 0)
    box->addItem(QString::fromStdString(file.filename().string()), QString::fromStdString(file.string()));
  box->setCurrentIndex(file.empty() ? -1 : entryOf(*box, file));
}

}  // namespace

SimulationToolBar::SimulationToolBar(Workbench& workbench, CommandActions& actions, QWidget* parent)
    : QToolBar(tr("Simulation"), parent), workbench_(workbench), actions_(actions) {
  setObjectName(QStringLiteral("simulationToolBar"));
  createActions();
  createBoxes();
  connectSignals();
  parent->installEventFilter(this);
}

bool SimulationToolBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parent() && event->type() == QEvent::Resize) {
    const bool roomy = static_cast<QResizeEvent*>(event)->size().width() >= kRoomyWindow;
    for (QAction* caption : captions_) caption->setVisible(roomy);
  }
  return QToolBar::eventFilter(watched, event);
}

void SimulationToolBar::createActions() {
  start_ = actions_.make(tr("Start"), "play", QStringLiteral("simulation.start"), {}, {Qt::Key_F5});
  pause_ = actions_.make(tr("Pause"), "pause", QStringLiteral("simulation.pause"), {}, {Qt::Key_F6});
  step_ = actions_.make(tr("Step"), "step", QStringLiteral("simulation.step"), {}, {Qt::Key_F10});
  reset_ = actions_.make(tr("Reset"), "reset", QStringLiteral("simulation.reset"), {},
                         {QKeySequence(QStringLiteral("Ctrl+R"))});
  rewind_ = actions_.make(tr("Rewind 1 s"), "step-back", QStringLiteral("simulation.rewind"), {1.0},
                          {QKeySequence(QStringLiteral("Ctrl+F10"))});
  simulationActions_ = {start_, pause_, rewind_, step_, reset_};
  start_->setCheckable(true);
  pause_->setCheckable(true);

  stop_ = new QAction(widgets::icon("stop"), widgets::stopText(false), this);
  stop_->setObjectName(QStringLiteral("robot.stop"));
  stop_->setCheckable(true);
  stop_->setShortcuts({QKeySequence(QStringLiteral("Shift+Esc")), QKeySequence(Qt::Key_Pause)});
  stop_->setShortcutContext(Qt::ApplicationShortcut);
  stop_->setToolTip(
      tr("Stops all robots at their platforms, regardless of their programs, until released; pauses a log "
         "(Shift+Esc, Pause)"));
}

void SimulationToolBar::createBoxes() {
  scene_ = makeBox(this, "sceneBox", tr("Scene"), tr("The simulated scene"));
  layout_ =
      makeBox(this, "layoutBox", tr("Process layout"),
              tr("Process layout of the selected robot's program: which process runs which tasks. Choosing "
                 "another restarts the programs of all robots"));
  robot_ = makeBox(this, "robotBox", tr("Robot"), tr("The robot shown in views and toolbars"));
  speed_ = makeBox(this, "speedBox", tr("Speed"), tr("Speed of the simulation, relative to real time"));
  scene_->setPlaceholderText(tr("none"));
  layout_->setPlaceholderText(tr("none"));
  layout_->setMinimumContentsLength(10);  // "of the log"
  addFiles(scene_, shippedScenes());
  for (const double speed : speeds()) speed_->addItem(speedText(speed), speed);
  // Its longest entry is a sentence, which only the opened list has to have room for.
  speed_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  speed_->setMinimumContentsLength(4);
  speed_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  speed_->view()->setMinimumWidth(speed_->view()->sizeHintForColumn(0) + 2 * fontMetrics().height());
  const auto addLabeled = [this](const QString& text, QWidget* widget) {
    auto* label = new QLabel(text, this);
    label->setMargin(4);
    captions_ << addWidget(label);
    addWidget(widget);
  };
  addLabeled(tr("Scene:"), scene_);
  addLabeled(tr("Layout:"), layout_);
  addLabeled(tr("Robot:"), robot_);
  colorTable_ = new ColorTableButton(this);
  ofColors_ = addWidget(colorTable_);
  ofColors_->setVisible(false);
  addSeparator();
  addActions(simulationActions_);
  ofSimulation_ = simulationActions_ + QList<QAction*>{addWidget(speed_)};
}

void SimulationToolBar::connectSignals() {
  const auto chosen = QOverload<int>::of(&QComboBox::activated);
  connect(scene_, chosen, this, [this](int index) {
    actions_.run(QStringLiteral("simulation.open"), {scene_->itemData(index).toString().toStdString()});
  });
  connect(layout_, chosen, this, [this](int index) {
    actions_.run(QStringLiteral("layout.open"), {layout_->itemData(index).toString().toStdString()});
  });
  connect(robot_, chosen, this, [this](int index) {
    const QVariant name = robot_->itemData(index);  // the text may also say how the robot is connected
    const QString robot = name.isValid() ? name.toString() : robot_->itemText(index);
    actions_.run(QStringLiteral("robot.select"), {robot.toStdString()});
  });
  connect(speed_, chosen, this, [this](int index) {
    actions_.run(QStringLiteral("simulation.speed"), {speed_->itemData(index).toDouble()});
  });
  connect(stop_, &QAction::triggered, this,
          [this](bool engaged) { actions_.run(QStringLiteral("robot.stop"), {engaged}); });
}

/// The layouts in which at least one of the robots can run.
void SimulationToolBar::showLayouts(const LoadedPlatform& loaded) {
  layout_->clear();
  std::set<std::string> kinds;
  std::set<std::filesystem::path> files;
  for (const auto& [name, description] : loaded.robots) {
    if (!kinds.insert(description->name).second) continue;
    for (const auto& file : layoutsFor(*description)) files.insert(file);
  }
  addFiles(layout_, {files.begin(), files.end()});
}

void SimulationToolBar::showLoaded() {
  const auto* loaded = workbench_.loaded();
  if (loaded == nullptr) return;
  // A log has a toolbar of its own to play it, and a real robot's time cannot be stopped.
  for (QAction* action : ofSimulation_) action->setVisible(!loaded->isLogged() && !loaded->isReal());
  selectFile(scene_, std::filesystem::path(loaded->isSimulated() ? loaded->sources.front() : std::string()));
  layout_->setPlaceholderText(loaded->isLogged() ? tr("of the log") : tr("none"));
  showLayouts(*loaded);
  showRobots();
  showLayoutOf(workbench_.session().selectedRobot());
}

void SimulationToolBar::showLayoutOf(const std::string& robot) {
  layoutShownOf_ = robot;
  const auto* loaded = workbench_.loaded();
  const bool isHere = loaded != nullptr && loaded->robots.contains(robot);
  selectFile(layout_, isHere ? loaded->layoutOf(robot) : std::filesystem::path());
}

void SimulationToolBar::showRobots() {
  robot_->clear();
  for (const std::string& robot : workbench_.session().robots())
    robot_->addItem(QString::fromStdString(robot), QString::fromStdString(robot));
  robot_->setEnabled(robot_->count() > 0);
}

void SimulationToolBar::refreshSpeed(double requested) {
  if (speed_->view()->isVisible()) return;
  for (int i = 0; i < speed_->count(); ++i) {
    if (std::abs(speed_->itemData(i).toDouble() - requested) < 1e-9) {
      speed_->setCurrentIndex(i);
      return;
    }
  }
  speed_->addItem(speedText(requested), requested);
  speed_->setCurrentIndex(speed_->count() - 1);
}

void SimulationToolBar::refresh() {
  auto& session = workbench_.session();
  widgets::showConnections(*robot_, session);
  const int robot = robot_->findData(QString::fromStdString(session.selectedRobot()));
  if (robot >= 0 && robot != robot_->currentIndex()) robot_->setCurrentIndex(robot);
  if (session.selectedRobot() != layoutShownOf_) showLayoutOf(session.selectedRobot());
  ofColors_->setVisible(colorTable_->refresh(session));
  const auto* status =
      session.store().latestAs<robotcontrol::SimulationStatus>("simulation", session.timeline().newest());
  const bool there = status != nullptr;
  const bool canBeControlled = there && !status->is_real();
  for (QAction* action : simulationActions_) action->setEnabled(canBeControlled);
  stop_->setEnabled(!session.robots().empty());
  speed_->setEnabled(canBeControlled);
  // A log is paused by STOP, from which nothing has to be released.
  if (!there && session.remoteRobots().empty()) showStop(false);
  if (!there) return;
  start_->setChecked(status->running());
  pause_->setChecked(!status->running());
  rewind_->setEnabled(canBeControlled && !status->running() && status->rewindable() >= 1);
  showStop(status->stopped_robots_size() > 0);
  refreshSpeed(status->requested_speed());
}

void SimulationToolBar::showStop(bool isEngaged) {
  stop_->setChecked(isEngaged);
  stop_->setText(widgets::stopText(isEngaged));
}

QString SimulationToolBar::speedText(double speed) {
  return speed <= 0 ? tr("as fast as possible") : QStringLiteral("%1×").arg(speed);
}

}  // namespace app
