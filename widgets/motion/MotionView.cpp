// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/MotionView.h"

#include <QAction>
#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"
#include "widgets/Controls.h"
#include "widgets/Icon.h"
#include "widgets/Requests.h"
#include "widgets/motion/GamepadDialog.h"
#include "widgets/motion/GamepadSettings.h"
#include "widgets/motion/HeadPanel.h"
#include "widgets/motion/MotionButtons.h"
#include "widgets/motion/SpeedPanel.h"
#include "widgets/motion/WalkPad.h"
#include "widgets/steering/SteeringBar.h"
#include "widgets/steering/SteeringState.h"
#include "widgets/steering/StopStyle.h"

namespace widgets {
namespace {

const ViewRegistration kMotionViewRegistration{
    {"motion", QT_TRANSLATE_NOOP("View", "Motion tester"),
     QT_TRANSLATE_NOOP("View", "Takes over the robot and steers it with mouse, keys or gamepad."), "motion",
     false, create<MotionView>}};

constexpr int kTurnSteps = 100;

}  // namespace

MotionView::MotionView(ViewContext& context, QWidget* parent)
    : View(context, parent), manual_(manualSteering(context)) {
  setObjectName(QStringLiteral("motionView"));
  auto device = std::make_shared<Gamepad>();
  if (!context.gamepad) context.gamepad = std::make_shared<GamepadSettings>();
  gamepad_ = [device, settings = context.gamepad] { return device->poll(settings->bindings()); };
  createActions();
  createViews();
  connectSignals();
  useRobot(nullptr);
  showPad(nullptr);
}

void MotionView::createActions() {
  take_ = makeButton(this,
                     makeToggle(this, "take-over",
                                {"motionTakeOver", tr("Take over"),
                                 tr("Switches the behavior to obeying you, and back"), tr("Ctrl+Shift+T")}));
  motors_ = makeButton(this, makeToggle(this, "motors",
                                        {"motionMotors", tr("Motors"),
                                         tr("Switches the motors on and off, at the base"), tr("Ctrl+M")}));
  for (QToolButton* button : {take_, motors_}) {
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(false);
    button->setFocusPolicy(Qt::TabFocus);
  }
  stop_ = new QPushButton(tr("STOP"), this);
  describe(*stop_, {"motionStop", tr("Emergency stop"),
                    tr("Stops the robot at its platform, regardless of its program, until released")});
  stop_->setCheckable(true);
  stop_->setMinimumSize(96, 44);
  stop_->setStyleSheet(stopStyle(QStringLiteral("QPushButton")));
}

QWidget* MotionView::createTop() {
  auto* top = new QWidget(this);
  robotName_ = new QLabel(top);
  describe(*robotName_, {"motionRobot", tr("Robot that is steered"), tr("It is chosen in the toolbar")});
  QFont bold = robotName_->font();
  bold.setBold(true);
  robotName_->setFont(bold);
  state_ = makeNote(top, "motionState", tr("Who steers"));
  auto* row = new QHBoxLayout;
  row->addWidget(robotName_);
  row->addWidget(take_);
  row->addStretch(1);
  row->addWidget(stop_);
  // Below them it has the whole width, also while STOP says that it is engaged.
  auto* layout = makeColumn(top, {}, 4);
  layout->addLayout(row);
  layout->addWidget(state_);
  return top;
}

QLayout* MotionView::createPadColumn(QWidget* body) {
  walkPad_ = new WalkPad(body);
  turn_ = new QSlider(Qt::Horizontal, body);
  describe(*turn_, {"walkTurn", tr("Turn"), tr("Turns while it is held: left is counterclockwise")});
  turn_->setRange(-kTurnSteps, kTurnSteps);
  turn_->setInvertedAppearance(true);
  turn_->setTickPosition(QSlider::TicksBelow);
  turn_->setTickInterval(kTurnSteps);
  gamepadState_ = new QLabel(body);
  describe(*gamepadState_,
           {"gamepadState", tr("Gamepad"), tr("Left stick walks, right stick turns, A kicks, B is STOP")});
  gamepadState_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  QAction* bind = makeAction(
      this, "gamepad",
      {"motionGamepad", tr("Gamepad…"), tr("Chooses what the axes and buttons of the gamepad do")});
  connect(bind, &QAction::triggered, this, &MotionView::bindGamepad);
  auto* pad = new QHBoxLayout;
  pad->addWidget(makeButton(body, bind));
  pad->addWidget(gamepadState_, 1);
  auto* column = new QVBoxLayout;
  column->addWidget(walkPad_, 1);
  column->addWidget(turn_);
  column->addLayout(pad);
  return column;
}

QLayout* MotionView::createPanelColumn(QWidget* body) {
  speed_ = new SpeedPanel(body);
  head_ = new HeadPanel(body);
  motions_ = new MotionButtons(body);
  auto* column = new QVBoxLayout;
  column->addWidget(speed_);
  column->addWidget(motors_);
  column->addWidget(head_);
  column->addWidget(motions_);
  column->addStretch();
  return column;
}

QWidget* MotionView::createBody() {
  auto* body = new QWidget(this);
  columns_ = new QBoxLayout(QBoxLayout::LeftToRight, body);
  columns_->setContentsMargins(0, 0, 0, 0);
  columns_->addLayout(createPadColumn(body), 3);
  columns_->addLayout(createPanelColumn(body), 2);
  return body;
}

void MotionView::arrange() {
  // The bar is always counted, since it may come and go with the order of the columns.
  const int room = area_->width() - area_->verticalScrollBar()->sizeHint().width();
  int needed = columns_->spacing();
  for (int i = 0; i < columns_->count(); ++i) needed += columns_->itemAt(i)->minimumSize().width();
  const auto wanted = needed > room ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
  if (columns_->direction() != wanted) columns_->setDirection(wanted);
}

void MotionView::createViews() {
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(createTop());
  steering_ = new SteeringBar(context().commands, this);
  layout->addWidget(steering_);
  area_ = makeScrollArea(this, createBody());
  layout->addWidget(area_, 1);
}

void MotionView::connectSignals() {
  connect(take_->defaultAction(), &QAction::triggered, this, &MotionView::takeOver);
  connect(motors_->defaultAction(), &QAction::triggered, this, &MotionView::switchMotors);
  connect(stop_, &QPushButton::clicked, this, &MotionView::stop);
  connect(turn_, &QSlider::sliderReleased, this, [this] { turn_->setValue(0); });
  connect(motions_, &MotionButtons::chosen, this, &MotionView::play);
  connect(speed_, &SpeedPanel::limitsChanged, this, [this] {
    manual_.commander().setLimits(speed_->limits());
    keepLimits();
  });
}

void MotionView::followRobot() {
  manual_.follow();
  if (manual_.robot() != robot_) {
    stand();
    robot_ = manual_.robot();
    description_ = manual_.description();
    isPadNext_ = false;
    useRobot(description_.get());
    nameRobot();
  } else if (manual_.description() != description_) {
    description_ = manual_.description();
    useRobot(description_.get());
  }
  if (manual_.isTaken() && std::exchange(isPadNext_, false)) walkPad_->setFocus();
}

void MotionView::nameRobot() {
  const QString name = QString::fromStdString(robot_);
  robotName_->setText(name);
  robotName_->setVisible(!name.isEmpty());
  stop_->setToolTip(
      name.isEmpty() ? tr("Stops the robot at its platform, regardless of its program, until released")
                     : tr("Stops %1 at its platform, regardless of its program, until released").arg(name));
}

void MotionView::keepLimits() {
  if (drive_) {
    driveLimits_ = speed_->limits();
  } else {
    walkLimits_ = speed_->limits();
  }
}

void MotionView::useRobot(const robotlink::RobotDescription* description) {
  constexpr MotionCommander::Limits kGreatestWalk{1, 10};
  drive_ = description == nullptr ? std::nullopt : description->drive;
  const bool wheels = drive_.has_value();
  head_->setRobot(description);
  head_->setVisible(!wheels);
  motions_->setVisible(!wheels);
  turn_->setVisible(!wheels);
  motors_->setVisible(wheels);
  walkPad_->setWheels(wheels);
  gamepadState_->setToolTip(wheels ? tr("Either stick drives and turns, B is STOP")
                                   : tr("Left stick walks, right stick turns, A kicks, B is STOP"));
  // setRobot() and setLimits() emit limitsChanged(), which overwrites the user's limits; so they are saved
  // before.
  const MotionCommander::Limits walk = walkLimits_;
  const std::optional<MotionCommander::Limits> chosen = driveLimits_;
  if (!wheels) {
    speed_->setRobot(false, kGreatestWalk);
    speed_->setLimits(walk);
    driveLimits_ = chosen;
    return;
  }
  const MotionCommander::Limits greatest{drive_->maximumSpeed, drive_->maximumRotation};
  speed_->setRobot(true, greatest);
  speed_->setLimits(chosen.value_or(MotionCommander::Limits{greatest.speed / 2, greatest.rotation / 2}));
  walkLimits_ = walk;
}

const robotcontrol::DriveState* MotionView::driveState() const {
  return session().store().latestAs<robotcontrol::DriveState>(robot_ + '/' + robotlink::kDriveState.name,
                                                              session().timeline().newest());
}

void MotionView::switchMotors(bool on) {
  robotcontrol::Request request;
  request.mutable_control_drive()->set_motors(on);
  ask(session(), robot_, std::move(request));
  const auto* state = driveState();
  // The button shows what the base reports, not what was clicked.
  motors_->defaultAction()->setChecked(state != nullptr && state->motors_on());
}

void MotionView::tick() {
  followRobot();
  arrange();
  if (drive_) subscription_.want(session(), robot_, {robotlink::kDriveState.name});
  useGamepad(gamepad_());
  WalkAxes axes = pad_.axes.zero() ? walkPad_->axes() : pad_.axes;
  if (turn_->isSliderDown()) axes.turn = turn_->value() / double(kTurnSteps);
  manual_.setAxes(axes);
  steerHead();
  steering_->refresh(session(), robot_);
  showStop();
  showPad(manual_.status());
}

void MotionView::steerHead() {
  const HeadTarget panel = head_->target();
  if (panel != panelHead_) {
    manual_.setHead(panel);
  } else if (manual_.commander().head() != commandedHead_) {
    head_->setTarget(manual_.commander().head());
  }
  panelHead_ = head_->target();
  commandedHead_ = manual_.commander().head();
}

void MotionView::stand() {
  walkPad_->release();
  turn_->setSliderDown(false);
  turn_->setValue(0);
  // A button that is held must not run its command again.
  auto held = std::move(pad_.commands);
  pad_ = {};
  pad_.commands = std::move(held);
  manual_.releaseAxes();
}

void MotionView::takeOver(bool take) {
  if (!take) stand();
  isPadNext_ = take;
  // An obstacle to that is shown next to the button.
  static_cast<void>(manual_.takeOver(take));
  showPad(nullptr);
}

void MotionView::stop(bool engage) {
  robotcontrol::Request request;
  request.mutable_stop()->set_engaged(engage);
  ask(session(), robot_, std::move(request));
}

void MotionView::play(const QString& motion) {
  // Without manual control, or on wheels, the buttons are disabled, and the gamepad's does nothing.
  static_cast<void>(manual_.play(motion.toStdString()));
}

void MotionView::useGamepad(const Gamepad::State& pad) {
  if (pad.kick && !pad_.kick) {
    const QStringList motions = MotionButtons::shippedMotions();
    const auto kick = std::find_if(motions.begin(), motions.end(), [](const QString& name) {
      return name.startsWith(QLatin1String("kick"));
    });
    if (kick != motions.end()) play(*kick);
  }
  if (pad.stop && !pad_.stop) stop(true);
  for (const auto& [button, command] : pad.commands) {
    if (pad_.commands.contains(button)) continue;
    // Afterwards, since a command may close this view.
    QMetaObject::invokeMethod(
        this, [this, line = command] { runCommand(line); }, Qt::QueuedConnection);
  }
  pad_ = pad;
  if (drive_) pad_.axes = {pad.axes.forward, 0, std::clamp(pad.axes.turn + pad.axes.left, -1.0, 1.0)};
  if (!pad.connected) padFailure_.clear();
  gamepadState_->setText(!pad.connected          ? tr("No gamepad; plug one in to use it")
                         : padFailure_.isEmpty() ? tr("Gamepad: %1").arg(pad.name)
                                                 : padFailure_);
  gamepadState_->setEnabled(pad.connected);
}

void MotionView::runCommand(const std::string& command) {
  const QPointer<MotionView> guard(this);
  const auto done = context().commands.runLine(command);
  if (!guard) return;
  padFailure_ = done ? QString()
                     : tr("%1: %2").arg(QString::fromStdString(command),
                                        QString::fromStdString(done.error().describe()));
}

void MotionView::bindGamepad() {
  auto* dialog = new GamepadDialog(*context().gamepad, context().commands, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void MotionView::showStop() {
  const auto* status = session().store().latestAs<robotcontrol::SimulationStatus>(
      robotlink::streams::kSimulation, session().timeline().newest());
  if (status != nullptr && !stop_->isDown()) {
    const auto& stopped = status->stopped_robots();
    stop_->setChecked(std::find(stopped.begin(), stopped.end(), robot_) != stopped.end());
  }
  stop_->setEnabled(!robot_.empty());
  stop_->setText(stopText(stop_->isChecked()));
}

void MotionView::showPad(const robotcontrol::MotionStatus* status) {
  const ManualControl::State who = manual_.control().state();
  const bool taken = who == ManualControl::State::kTaken;
  QAction& take = *take_->defaultAction();
  take.setChecked(taken);
  take.setEnabled(who == ManualControl::State::kFree || taken);
  take.setText(taken ? tr("Give back") : tr("Take over"));
  state_->setText(stateText());
  const auto* base = drive_ ? driveState() : nullptr;
  motors_->setEnabled(drive_.has_value());
  motors_->defaultAction()->setChecked(base != nullptr && base->motors_on());
  motors_->setText(base == nullptr ? tr("Motors") : base->motors_on() ? tr("Motors on") : tr("Motors off"));
  motions_->setEnabled(taken);
  head_->setEnabled(taken);
  turn_->setEnabled(taken);
  motions_->showPlaying(status != nullptr &&
                                status->executed().kind() == robotcontrol::MotionRequest::KEY_FRAMES
                            ? QString::fromStdString(status->executed().motion())
                            : QString());
  showSpeeds(status);
}

QString MotionView::stateText() const {
  if (robot_.empty()) return tr("No robot. Start a simulation or connect to a robot.");
  if (isLost(session(), robot_))
    return tr(
        "The connection to the robot is lost. The robot has stopped; you can steer it again when it is "
        "reconnected.");
  const auto* base = drive_ ? driveState() : nullptr;
  if (base == nullptr || manual_.control().state() != ManualControl::State::kTaken)
    return manual_.control().text();
  if (base->emergency_stop()) return tr("The emergency stop is pressed: release it on the robot.");
  return base->motors_on() ? manual_.control().text()
                           : tr("You steer the robot, but its motors are off: switch them on.");
}

void MotionView::showSpeeds(const robotcontrol::MotionStatus* status) {
  const bool taken = manual_.control().state() == ManualControl::State::kTaken;
  const auto measured = measuredSpeed(session().store(), robot_, session().timeline().shown());
  std::optional<Speed> believed;
  if (const auto* base = drive_ ? driveState() : nullptr; base != nullptr) {
    believed = Speed{base->velocity().x(), 0, base->velocity().rotation()};
  } else if (status != nullptr) {
    believed = Speed{status->velocity().x(), status->velocity().y(), status->velocity().rotation()};
  }
  const auto walk = manual_.commander().command().motion().walk();
  speed_->showSpeeds({walk.x(), walk.y(), walk.rotation()}, measured, believed);
  WalkPad::Picture picture{manual_.commander().axes(),
                           {},
                           taken,
                           drive_.has_value(),
                           taken ? QString() : tr("Take over to steer")};
  // The true speed of a real robot is unknown; the pad shows the robot's own measurement instead.
  if (const auto real = measured ? measured : drive_ ? believed : std::nullopt) {
    const auto limits = manual_.commander().limits();
    picture.measured =
        WalkAxes{real->x / limits.speed, real->y / limits.speed, real->rotation / limits.rotation};
  }
  walkPad_->show(std::move(picture));
}

void MotionView::resizeEvent(QResizeEvent* event) {
  View::resizeEvent(event);
  arrange();
}

void MotionView::hideEvent(QHideEvent* event) {
  stand();
  View::hideEvent(event);
}

void MotionView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ActivationChange && !isActiveWindow()) stand();
  View::changeEvent(event);
}

QJsonObject MotionView::saveState() const {
  QJsonObject state{{QStringLiteral("speed"), walkLimits_.speed},
                    {QStringLiteral("rotation"), walkLimits_.rotation},
                    {QStringLiteral("headMode"), static_cast<int>(head_->target().kind)}};
  if (!driveLimits_) return state;
  state[QStringLiteral("driveSpeed")] = driveLimits_->speed;
  state[QStringLiteral("driveRotation")] = driveLimits_->rotation;
  return state;
}

void MotionView::restoreState(const QJsonObject& state) {
  const MotionCommander::Limits standard;
  walkLimits_ = {state.value(QStringLiteral("speed")).toDouble(standard.speed),
                 state.value(QStringLiteral("rotation")).toDouble(standard.rotation)};
  driveLimits_.reset();
  if (state.contains(QStringLiteral("driveSpeed"))) {
    driveLimits_ = MotionCommander::Limits{state.value(QStringLiteral("driveSpeed")).toDouble(),
                                           state.value(QStringLiteral("driveRotation")).toDouble()};
  }
  const auto description = context().robots.find(robot_);
  useRobot(description == context().robots.end() ? nullptr : description->second.get());
  HeadTarget target = head_->target();
  target.kind =
      static_cast<HeadTarget::Kind>(std::clamp(state.value(QStringLiteral("headMode")).toInt(), 0, 4));
  head_->setTarget(target);
}

}  // namespace widgets
