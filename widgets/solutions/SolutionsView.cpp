// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/SolutionsView.h"

#include <QAction>
#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <QTreeView>

#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/RobotTeams.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/TypedStreams.h"
#include "widgets/solutions/ParameterPanel.h"
#include "widgets/solutions/SolutionDelegate.h"

namespace widgets {
namespace {

const ViewRegistration kSolutionsViewRegistration{
    {"solutions", QT_TRANSLATE_NOOP("View", "Solutions"),
     QT_TRANSLATE_NOOP("View", "Chooses how each task of the robot is done, and sets the parameters."),
     "solutions", false, create<SolutionsView>}};

/// The debug key that measures tasks.
constexpr char kTimingKey[] = "timing/tasks";
/// Costs are updated twice a second.
constexpr int kTicksOfCosts = 15;

}  // namespace

SolutionsView::SolutionsView(ViewContext& context, QWidget* parent) : View(context, parent) {
  setObjectName(QStringLiteral("solutionsView"));
  createActions();
  createViews();
  connectSignals();
  keep("parameters", showParameters_);
  keep("splitter", splitter_);
}

void SolutionsView::createActions() {
  defaults_ =
      makeAction(this, "reset",
                 {"solutionsDefaults", tr("Defaults"),
                  tr("Switches every task to the solution that its layout names"), tr("Ctrl+Shift+L")});
  inTeam_ = makeAction(
      this, "robot",
      {"solutionsInTeam", tr("In its team"), tr("Switches the task to this solution in the robot's team")});
  inAllRobots_ = makeAction(
      this, "robot",
      {"solutionsInAllRobots", tr("In all robots"), tr("Switches the task to this solution in all robots")});
  showParameters_ = makeToggle(this, "settings",
                               {"solutionsParameters", tr("Parameters"),
                                tr("Shows the parameters of the current solution"), tr("Ctrl+Shift+I")});
}

void SolutionsView::createViews() {
  tree_ = makeTree(this, {"solutionsTree", tr("Tasks and their solutions"), {}}, &model_);
  tree_->setItemDelegate(new SolutionDelegate(tree_));
  tree_->setAlternatingRowColors(false);
  tree_->setIndentation(14);
  tree_->setContextMenuPolicy(Qt::ActionsContextMenu);
  tree_->addActions({inTeam_, inAllRobots_});
  new ColumnFit(*tree_, {ColumnKind::kName, ColumnKind::kTitledNumber, ColumnKind::kNumber, ColumnKind::kName,
                         ColumnKind::kText});
  hint_ = new EmptyHint(tree_);
  hint_->setHint(tr("No robot. Start a simulation or connect to a robot, and choose it in the toolbar."));
  parameters_ = new ParameterPanel(session(), this);
  splitter_ = makeSplitter(this, "solutionsSplitter", Qt::Vertical, {{tree_, 2}, {parameters_, 1}});
  splitter_->setChildrenCollapsible(false);
  parameters_->hide();
  state_ = makeNote(this, "solutionsState", tr("Last answer"));
  auto* top = makeToolRow(this, 0);
  top->addStretch(1);
  top->addWidget(makeLabeledButton(this, inTeam_));
  top->addWidget(makeLabeledButton(this, inAllRobots_));
  top->addWidget(makeButton(this, defaults_));
  top->addWidget(makeLabeledButton(this, showParameters_));
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(top->parentWidget());
  layout->addWidget(splitter_, 1);
  layout->addWidget(state_);
}

void SolutionsView::connectSignals() {
  tree_->installEventFilter(this);
  connect(tree_, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() != SolutionModel::kShadow) choose(index);
  });
  connect(&model_, &SolutionModel::shadowRequested, this, &SolutionsView::requestShadow);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &SolutionsView::showCurrent);
  connect(defaults_, &QAction::triggered, this, &SolutionsView::selectDefaults);
  connect(inTeam_, &QAction::triggered, this,
          [this] { selectIn(robotlink::robotsOfTeam(session(), team())); });
  connect(inAllRobots_, &QAction::triggered, this, [this] { selectIn(session().robots()); });
  connect(&model_, &QAbstractItemModel::modelReset, tree_, &QTreeView::expandAll);
  connect(showParameters_, &QAction::toggled, this, [this](bool on) {
    parameters_->setVisible(on);
    if (on) splitter_->setSizes({splitter_->height() * 3 / 5, splitter_->height() * 2 / 5});
    showCurrent(tree_->currentIndex());
  });
}

void SolutionsView::tick() {
  const std::string& robot = session().selectedRobot();
  // Switching acts on the robot now, whatever instant the data views show.
  const auto tables =
      latestTable(session().store(), robot, robotlink::streams::kSolutions, session().timeline().newest());
  auto values = valuesOf(tables);
  if (robot != robot_ || values != shown_) {
    const int before = robot == robot_ ? model_.rowCount() : 0;
    if (robot != robot_) model_.forget();
    robot_ = robot;
    shown_ = std::move(values);
    model_.setTasks(robot.empty() ? std::vector<TaskEntry>() : tasksOf(tables));
    if (model_.rowCount() != before) {  // Processes publish their tasks one after the other.
      tree_->expandAll();
      tree_->resizeColumnToContents(SolutionModel::kName);
      tree_->resizeColumnToContents(SolutionModel::kProcess);
      showCurrent(tree_->currentIndex());
    }
  }
  const auto keys =
      latestTable(session().store(), robot, robotlink::streams::kKeys, session().timeline().newest());
  if (auto keyValues = valuesOf(keys); keyValues != shownKeys_ || model_.rowCount() == 0) {
    shownKeys_ = std::move(keyValues);
    model_.setShadows(shadowsOf(keys));
  }
  if (++ticks_ % kTicksOfCosts == 0)
    model_.setCosts(costsOf(session().store(), robot, model_.tasks(), session().timeline().newest()));
  showHint();
  defaults_->setEnabled(model_.rowCount() > 0);
  const bool isChosen = tree_->currentIndex().data(SolutionModel::kSolutionRole).isValid();
  inTeam_->setEnabled(isChosen && !team().empty());
  inAllRobots_->setEnabled(isChosen && session().robots().size() > 1);
  parameters_->tick();
}

void SolutionsView::showHint() {
  const auto& remote = session().remoteRobots();
  const auto found = remote.find(robot_);
  hint_->setHint(model_.rowCount() > 0 ? QString()
                 : robot_.empty()
                     ? tr("No robot. Start a simulation or connect to a robot, and choose it in the toolbar.")
                 : found != remote.end() && found->second.isForeign
                     ? tr("%1 has no solutions: its server is not a RobotControl program.")
                           .arg(QString::fromStdString(robot_))
                     : tr("The robot has not reported its tasks yet. Start its program."));
}

void SolutionsView::choose(const QModelIndex& index) {
  const QVariant solution = index.data(SolutionModel::kSolutionRole);
  if (!solution.isValid()) return;
  const auto choice = static_cast<SolutionModel::Choice>(index.data(SolutionModel::kChoiceRole).toInt());
  if (choice == SolutionModel::Choice::kUnavailable) {
    showOutcome(*state_,
                tr("%1 cannot be chosen: %2")
                    .arg(solution.toString(), index.siblingAtColumn(SolutionModel::kState).data().toString()),
                true);
  } else if (choice == SolutionModel::Choice::kFree) {
    select(index.data(SolutionModel::kTaskRole).toString().toStdString(), solution.toString().toStdString());
  }
}

void SolutionsView::select(const std::string& task, const std::string& solution) {
  model_.setPending(task, solution);
  robotcontrol::Request request;
  request.mutable_select_solution()->set_task(task);
  request.mutable_select_solution()->set_solution(solution);
  ask(session(), robot_, std::move(request), this,
      [this, robot = robot_, task, solution](bool accepted, const QString& reason) {
        const QString name = QString::fromStdString(task + " / " + solution);
        if (accepted) return showOutcome(*state_, tr("%1 was accepted").arg(name), false);
        if (robot == robot_) model_.refuse(task, solution, reason);
        showOutcome(*state_, tr("%1 was refused: %2").arg(name, reason), true);
      });
}

void SolutionsView::measure() {
  const auto keys =
      latestTable(session().store(), robot_, robotlink::streams::kKeys, session().timeline().newest());
  for (const auto* message : keys) {
    const auto* table =
        message == nullptr ? nullptr : dynamic_cast<const robotcontrol::KeyTable*>(message->value.get());
    for (int i = 0; table != nullptr && i < table->keys_size(); ++i) {
      const auto& key = table->keys(i);
      if (key.name() != kTimingKey || key.mode().kind() != robotcontrol::KeyMode::OFF) continue;
      robotcontrol::Request request;
      request.mutable_set_key()->set_name(kTimingKey);
      request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
      return ask(session(), robot_, std::move(request), this, [](bool, const QString&) {});
    }
  }
}

void SolutionsView::requestShadow(const std::string& task, const std::string& solution, bool on) {
  robotcontrol::Request request;
  request.mutable_set_key()->set_name(robotlink::shadowKey(task, solution));
  request.mutable_set_key()->mutable_mode()->set_kind(on ? robotcontrol::KeyMode::ALWAYS
                                                         : robotcontrol::KeyMode::OFF);
  ask(session(), robot_, std::move(request), this,
      [this, robot = robot_, task, solution, on](bool accepted, const QString& reason) {
        const QString name = QString::fromStdString(task + " / " + solution);
        if (!accepted) {
          if (robot == robot_) model_.refuseShadow({task, solution});
          return showOutcome(*state_, tr("%1 was refused: %2").arg(name, reason), true);
        }
        if (on && robot == robot_) measure();
        showOutcome(*state_, on ? tr("%1 runs in the shadow").arg(name) : tr("%1 no longer runs").arg(name),
                    false);
      });
}

std::string SolutionsView::team() const {
  return robotlink::teamOf(session().store(), robot_, session().timeline().newest()).value_or("");
}

void SolutionsView::selectIn(const std::vector<std::string>& robots) {
  const QModelIndex current = tree_->currentIndex();
  const std::string task = current.data(SolutionModel::kTaskRole).toString().toStdString();
  const std::string solution = current.data(SolutionModel::kSolutionRole).toString().toStdString();
  if (solution.empty()) return;
  choose(current);
  robotcontrol::Request request;
  request.mutable_select_solution()->set_task(task);
  request.mutable_select_solution()->set_solution(solution);
  for (const std::string& robot : robots) {
    if (robot == robot_) continue;
    ask(session(), robot, request, this,
        [this, name = QString::fromStdString(robot + ": " + task + " / " + solution)](bool accepted,
                                                                                      const QString& reason) {
          if (!accepted) showOutcome(*state_, tr("%1 was refused: %2").arg(name, reason), true);
        });
  }
}

void SolutionsView::selectDefaults() {
  const std::vector<TaskEntry> tasks = model_.tasks();
  for (const TaskEntry& task : tasks) {
    const std::string standard = model_.standardOf(task);
    if (!standard.empty() && standard != task.active) select(task.name, standard);
  }
}

void SolutionsView::showCurrent(const QModelIndex& index) {
  if (!showParameters_->isChecked()) return;  // the panel is hidden, so its values are not requested
  const QVariant solution = index.data(SolutionModel::kSolutionRole);
  parameters_->show(robot_, index.data(SolutionModel::kTaskRole).toString().toStdString(),
                    solution.toString().toStdString(), index.data(SolutionModel::kParametersRole).toBool());
}

bool SolutionsView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == tree_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const QModelIndex current = tree_->currentIndex();
    if ((key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter) &&
        current.data(SolutionModel::kSolutionRole).isValid()) {
      choose(current);
      return true;
    }
  }
  return View::eventFilter(watched, event);
}

}  // namespace widgets
