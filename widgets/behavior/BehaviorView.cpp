// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/behavior/BehaviorView.h"

#include <QAction>
#include <QBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolButton>

#include "robotcontrol/Motion.pb.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/ShownText.h"
#include "widgets/behavior/HistoryStrip.h"
#include "widgets/behavior/OptionCanvas.h"
#include "widgets/solutions/ParameterEdits.h"

namespace widgets {
namespace {

const ViewRegistration kBehaviorViewRegistration{
    {"behavior", QT_TRANSLATE_NOOP("View", "Behavior"),
     QT_TRANSLATE_NOOP("View",
                       "Shows the options and states of the robot's behavior, what is active and why."),
     "layout", false, create<BehaviorView>}};

constexpr const char* kBehaviorTask = "behavior";
/// How long it takes until a robot is asked again that has not answered: a second.
constexpr int kTicksUntilHoldIsAsked = 30;

}  // namespace

BehaviorView::BehaviorView(ViewContext& context, QWidget* parent)
    : View(context, parent), edits_(new ParameterEdits(session(), this)) {
  setObjectName(QStringLiteral("behaviorView"));
  createActions();
  createViews();
  connectSignals();
  updateActions();
  keep("splitter", splitter_);
}

void BehaviorView::createActions() {
  force_ =
      makeAction(this, "lock",
                 {"behaviorForce", tr("Force"),
                  tr("Keeps the behavior in the selected state until it is released"), tr("Ctrl+Return")});
  release_ = makeAction(this, "play",
                        {"behaviorRelease", tr("Release"),
                         tr("Releases the behavior, so that it decides again"), tr("Ctrl+R")});
  hold_ =
      makeToggle(this, "pause",
                 {"behaviorHold", tr("Hold"), tr("Freezes all states until Step or a second click on Hold")});
  step_ = makeAction(this, "step",
                     {"behaviorStep", tr("Step"), tr("Lets the next change of a state happen"), tr("F10")});
}

void BehaviorView::createViews() {
  graph_ = new OptionCanvas(model_, this);
  hint_ = new EmptyHint(graph_);
  strip_ = new HistoryStrip(history_, this);
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName(QStringLiteral("behaviorHistoryScroll"));
  scroll->setWidgetResizable(true);
  scroll->setWidget(strip_);
  now_ = makeNote(this, "behaviorNow", tr("What is active"));
  splitter_ = makeSplitter(this, "behaviorSplitter", Qt::Vertical, {{graph_, 4}, {scroll, 1}});
  auto* top = makeToolRow(this, 0);
  addButtons(top, {force_, release_, hold_, step_});
  top->addStretch();
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(top->parentWidget());
  layout->addWidget(splitter_, 1);
  layout->addWidget(now_);
}

void BehaviorView::connectSignals() {
  connect(force_, &QAction::triggered, this, &BehaviorView::forceSelected);
  connect(graph_, &OptionCanvas::activated, this, &BehaviorView::forceSelected);
  connect(graph_, &OptionCanvas::selectionChanged, this, &BehaviorView::updateActions);
  connect(release_, &QAction::triggered, this, [this] { setControl("control.forced", ""); });
  connect(hold_, &QAction::toggled, this, [this](bool on) {
    ++holdNumber_;  // what the robot had before is shown no more
    ticksUntilHold_ = 0;
    updateActions();
    if (setControl("control.hold", on ? "on" : "off")) return;
    showHold(!on);
    askHold();
  });
  connect(step_, &QAction::triggered, this, &BehaviorView::step);
}

void BehaviorView::updateActions() {
  const bool canControl = model_.hasGraph();
  force_->setEnabled(canControl && graph_->selected().state >= 0);
  release_->setEnabled(canControl);
  hold_->setEnabled(canControl);
  step_->setEnabled(canControl && hold_->isChecked());
}

bool BehaviorView::setControl(const char* parameter, const std::string& value) {
  const std::string solution = std::string(kBehaviorTask) + '/' + model_.solution().toStdString();
  const auto done = edits_->set(solution, parameter, value);
  if (!done) session().reportRefusal(std::string("parameter ") + parameter, done.error().describe());
  return done.has_value();
}

void BehaviorView::followHold() {
  const std::pair controlled(robot_, model_.hasGraph() ? model_.solution() : QString());
  if (std::exchange(controlled_, controlled) == controlled) return;
  showHold(false);
  askHold();
}

void BehaviorView::showHold(bool isHeld) {
  const QSignalBlocker quiet(hold_);
  hold_->setChecked(isHeld);
  updateActions();
}

void BehaviorView::askHold() {
  ticksUntilHold_ = 0;
  const int number = ++holdNumber_;
  if (!model_.hasGraph()) return;
  const std::string solution = std::string(kBehaviorTask) + '/' + model_.solution().toStdString();
  edits_->requestValue(solution, "control.hold", [this, number](const robotlink::Result<std::string>& value) {
    if (number != holdNumber_) return;
    if (value) return showHold(*value == "on");
    const std::string& id = value.error().id;
    const bool isFinal = id == "robot.parameter-unknown" || id == "robot.parameter-none";
    ticksUntilHold_ = isFinal ? 0 : kTicksUntilHoldIsAsked;
  });
}

void BehaviorView::forceSelected() {
  if (!force_->isEnabled()) return;
  const auto path = model_.pathTo(graph_->selected());
  if (!path.empty()) setControl("control.forced", model_.forcedText(path).toStdString());
}

void BehaviorView::step() {
  // The count continues from the program's own, whoever else steps it.
  const std::string solution = std::string(kBehaviorTask) + '/' + model_.solution().toStdString();
  edits_->requestValue(solution, "control.steps", [this](const robotlink::Result<std::string>& value) {
    const QString text = value ? QString::fromStdString(*value) : QString();
    setControl("control.steps", std::to_string(text.toUInt() + 1));
  });
}

std::optional<QString> BehaviorView::numbers() {
  TabTable table({QStringLiteral("option"), QStringLiteral("state"), QStringLiteral("from s"),
                  QStringLiteral("to s"), QStringLiteral("reason")});
  const auto& timeline = session().timeline();
  const double origin =
      robotlink::seconds(timeline.shown()) - robotlink::seconds(timeline.sinceOrigin(timeline.shown()));
  for (const OptionHistory::Row& row : history_.rows())
    for (const OptionHistory::Segment& segment : row.segments)
      table.add({row.option, segment.state, QString::number(segment.from - origin, 'f', 3),
                 QString::number(segment.to - origin, 'f', 3), segment.reason});
  return table.text();
}

void BehaviorView::tick() {
  if (ticksUntilHold_ > 0 && --ticksUntilHold_ == 0) askHold();
  const std::string& robot = session().selectedRobot();
  subscription_.want(session(), robot, {robotlink::kBehaviorState.name, robotlink::kBehaviorGraph.name});
  const auto& store = session().store();
  const auto shown = session().timeline().shown();
  const std::string statePath = robot + '/' + robotlink::kBehaviorState.name;
  const auto* graph = store.latest(robot + '/' + robotlink::kBehaviorGraph.name, shown);
  const auto* state = store.latest(statePath, shown);
  const robotlink::PackagePtr graphValue = graph != nullptr ? graph->value : nullptr;
  const robotlink::PackagePtr stateValue = state != nullptr ? state->value : nullptr;
  if (robot == robot_ && graphValue == shownGraph_ && stateValue == shownState_) return;
  bool changed = robot != robot_;
  const auto* options = dynamic_cast<const robotcontrol::BehaviorGraph*>(graphValue.get());
  const auto* active = dynamic_cast<const robotcontrol::BehaviorState*>(stateValue.get());
  // The graph of a behavior that was switched off is not that of the one that runs.
  if (options != nullptr && active != nullptr && options->solution() != active->solution()) options = nullptr;
  if (changed || graphValue != shownGraph_ || (options != nullptr) != model_.hasGraph())
    changed = model_.setGraph(options) || changed;
  changed = model_.setState(active) || changed;
  robot_ = robot;
  shownGraph_ = graphValue;
  shownState_ = stateValue;
  history_.read(store.find(statePath), shown);
  followHold();
  if (changed) graph_->layOut();
  graph_->update();
  strip_->refresh();
  now_->setText(model_.description());
  hint_->setHint(robot.empty() ? tr("No robot. Start a simulation or connect to a robot, and choose it in "
                                    "the toolbar.")
                 : active == nullptr ? tr("The robot has not reported its behavior yet. Start its program.")
                                     : QString());
  updateActions();
}

}  // namespace widgets
