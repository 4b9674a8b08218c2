// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/BaseStateView.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "robotlink/commands/CommandTable.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"
#include "widgets/BaseSilence.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/EmptyHint.h"
#include "widgets/Icon.h"
#include "widgets/Requests.h"
#include "widgets/RobotChoice.h"
#include "widgets/drive/BatteryGauge.h"
#include "widgets/drive/LinkWords.h"
#include "widgets/drive/StateRows.h"

namespace widgets {
namespace {

using robotcontrol::DriveState;
using robotcontrol::LinkStatus;

const ViewRegistration kBaseStateViewRegistration{
    {"base-state", QT_TRANSLATE_NOOP("View", "Robot state"),
     QT_TRANSLATE_NOOP("View", "Battery, motors, bumpers, odometry and line of a robot on wheels."),
     "base-state", true, create<BaseStateView>}};

template <typename T>
const T* newestOf(robotlink::Session& session, const std::string& robot, const char* package) {
  return session.store().latestAs<T>(robot + '/' + package, session.timeline().shown());
}

QString speedText(const robotcontrol::Velocity2& velocity) {
  return BaseStateView::tr("%1 mm/s, %2°/s")
      .arg(velocity.x() * 1000 + 0.0, 0, 'f', 0)
      .arg(robotlink::degrees(velocity.rotation()) + 0.0, 0, 'f', 1);
}

/// "front 2; rear 1, 5": numbers of the pressed bumpers from left to right.
QString bumpersText(const DriveState& state) {
  const auto pressed = [](const auto& bumpers) {
    QStringList numbers;
    for (int i = 0; i < bumpers.size(); ++i) {
      if (bumpers.Get(i)) numbers << QString::number(i + 1);
    }
    return numbers.join(QStringLiteral(", "));
  };
  QStringList ends;
  if (const QString front = pressed(state.front_bumpers()); !front.isEmpty())
    ends << BaseStateView::tr("front %1").arg(front);
  if (const QString rear = pressed(state.rear_bumpers()); !rear.isEmpty())
    ends << BaseStateView::tr("rear %1").arg(rear);
  return ends.join(QStringLiteral("; "));
}

}  // namespace

BaseStateView::BaseStateView(ViewContext& context, QWidget* parent) : View(context, parent) {
  setObjectName(QStringLiteral("baseStateView"));
  createActions();
  createRows();
  createViews();
  connectSignals();
  keep("robot", robots_);
  tick();
}

void BaseStateView::createActions() {
  motors_ = makeToggle(
      this, "motors",
      {"baseMotors", tr("Motors"), tr("Switches the motors on and off, at the base"), tr("Ctrl+M")});
  sonar_ = makeToggle(this, "sonar",
                      {"baseSonar", tr("Sonars"), tr("Switches the sonars on and off"), tr("Ctrl+Shift+N")});
  resetOdometry_ =
      makeAction(this, "reset",
                 {"baseResetOdometry", tr("Reset odometry"), tr("Makes this pose the odometry's origin")});
}

void BaseStateView::createRows() {
  base_ = new StateRows(tr("Base"), "baseRows", this);
  base_->addText("baseAge", tr("Age of this state"));
  battery_ = new BatteryGauge(base_);
  base_->addRow(tr("Battery"), tr("Charge level; at the lowest voltage the robot switches itself off"),
                battery_);
  base_->addText("baseBatteryWarning", tr("What the battery needs"));
  base_->addRow("baseMotorsState", tr("Motors"), tr("Whether the motors hold and turn the wheels"));
  base_->addRow("baseSonarState", tr("Sonars"), tr("Whether the sonars fire"));
  base_->addRow("baseStall", tr("Stall"), tr("Stalled wheels"));
  base_->addRow("baseBumpers", tr("Bumpers"), tr("Pressed bumpers, from left to right"));
  base_->addRow("baseEmergency", tr("Emergency stop"),
                tr("The button on the robot, and STOP of this workbench"));
  base_->addRow("baseTemperature", tr("Temperature"), tr("Temperature of the base's electronics"));
  base_->addRow("baseFaults", tr("Faults"), tr("Flags of its microcontroller"));
  motion_ = new StateRows(tr("Motion"), "motionRows", this);
  motion_->addRow("baseOdometry", tr("Odometry"), tr("Pose from the wheels: x, y, heading"));
  motion_->addRow("baseAsked", tr("Requested"), tr("Velocity that the program requested (drive/request)"));
  motion_->addRow("baseReal", tr("Real"), tr("From the wheels: forward, and counterclockwise"));
  motion_->addRow("baseWheels", tr("Wheels"), tr("Speeds of the left and right wheels' rims"));
  link_ = new StateRows(tr("Line"), "linkRows", this);
  link_->addRow("linkState", tr("State"), tr("Whether packets arrive"));
  link_->addRow("linkAddress", tr("Address"),
                tr("Address of the robot; of a simulated one, where it listens"));
  link_->addRow("linkRobot", tr("Robot"), tr("Name, class and subclass from the handshake"));
  link_->addRow("linkClient", tr("Client"), tr("Who drives a simulated robot through its port"));
  link_->addRow("linkPackets", tr("Packets"), tr("From the robot, over the last seconds"));
  link_->addRow("linkErrors", tr("Errors"),
                tr("Packets whose checksum was wrong, and bytes that belonged to no packet"));
  link_->addRow("linkRoundTrip", tr("Round trip"), tr("Time until the last request was answered"));
  link_->addRow("linkGap", tr("Longest gap"),
                tr("Interval between information packets, over the last seconds; nominally 100 ms"));
  link_->addRow("linkReconnects", tr("Reconnected"),
                tr("Number of times the connection was lost and restored"));
  link_->addText("linkText", tr("Status of the line"));
  connectNow_ = new QPushButton(icon("connect"), tr("Connect now"), link_);
  describe(*connectNow_, {"linkConnectNow", tr("Connect now"),
                          tr("Tries to reach the robot at once, instead of after the pause")});
  connectNow_->setVisible(false);
  link_->addWidget(connectNow_);
}

QWidget* BaseStateView::createToolRow() {
  QHBoxLayout* row = makeToolRow(this);
  robots_ = new RobotChoice("baseRobot", row->parentWidget(), RobotChoice::Offer::kOne);
  row->addWidget(robots_);
  row->addStretch(1);
  for (QAction* action : {motors_, sonar_}) row->addWidget(makeLabeledButton(row->parentWidget(), action));
  addButtons(row, {resetOdometry_});
  return row->parentWidget();
}

void BaseStateView::createViews() {
  body_ = new QWidget(this);
  auto* rows = new QVBoxLayout(body_);
  rows->setContentsMargins(4, 2, 4, 4);
  for (StateRows* group : {base_, motion_, link_}) rows->addWidget(group);
  rows->addStretch(1);
  auto* scroll = makeScrollArea(this, body_);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  hint_ = new EmptyHint(scroll);
  problem_ = makeNote(this, "baseProblem", tr("What was refused"));
  problem_->setMargin(6);
  problem_->hide();
  auto* layout = makeColumn(this);
  layout->addWidget(createToolRow());
  layout->addWidget(problem_);
  layout->addWidget(scroll, 1);
}

void BaseStateView::connectSignals() {
  connect(robots_, &RobotChoice::choiceChanged, this, &BaseStateView::tick);
  connect(motors_, &QAction::triggered, this, [this](bool on) {
    robotcontrol::ControlDrive control;
    control.set_motors(on);
    send(control);
  });
  connect(sonar_, &QAction::triggered, this, [this](bool on) {
    robotcontrol::ControlDrive control;
    control.set_sonar(on);
    send(control);
  });
  connect(connectNow_, &QPushButton::clicked, this, &BaseStateView::connectNow);
  connect(resetOdometry_, &QAction::triggered, this, [this] {
    robotcontrol::ControlDrive control;
    control.set_reset_odometry(true);
    send(control);
  });
}

void BaseStateView::send(const robotcontrol::ControlDrive& control) {
  robotcontrol::Request request;
  *request.mutable_control_drive() = control;
  ask(session(), robot_, std::move(request), this, [this](bool accepted, const QString& reason) {
    showOutcome(*problem_, tr("Refused: %1").arg(reason), true);
    problem_->setVisible(!accepted);
  });
  tick();  // the buttons show what the base reports, not what was clicked
}

void BaseStateView::tick() {
  robots_->refresh(session());
  const std::string robot = robots_->robot(session());
  if (robot != robot_) problem_->hide();
  robot_ = robot;
  subscription_.want(
      session(), robot_,
      {robotlink::kDriveState.name, robotlink::kDriveRequest.name, robotlink::kLinkStatus.name});
  const auto* state = newestOf<DriveState>(session(), robot_, robotlink::kDriveState.name);
  const auto* status =
      session().store().latest(robot_ + '/' + robotlink::kLinkStatus.name, session().timeline().shown());
  const double age = status == nullptr ? 0 : robotlink::seconds(session().timeline().shown() - status->time);
  const auto staleAge = baseSilence(session().store(), robot_, session().timeline().shown());
  showAge(staleAge);
  showBase(state, staleAge);
  showMotion(state);
  showLink(status == nullptr ? nullptr : dynamic_cast<const LinkStatus*>(status->value.get()), age);
  const auto description = context().robots.find(robot_);
  const bool drives =
      state != nullptr || status != nullptr ||
      (description != context().robots.end() && description->second && description->second->drive);
  for (QAction* action : {motors_, sonar_, resetOdometry_}) action->setEnabled(drives);
  body_->setVisible(drives);
  hint_->setHint(
      drives ? QString()
      : robot_.empty()
          ? tr("No robot. Open a map or scene with robots on wheels, or connect to one (menu Robot).")
          : tr("%1 has no wheels. Choose a robot that drives.").arg(QString::fromStdString(robot_)));
}

void BaseStateView::showAge(std::optional<double> age) {
  base_->set(
      "baseAge",
      age ? tr("The base has been silent for %1 s: this is its last state.").arg(*age, 0, 'f', 0) : QString(),
      Meaning::kMuted);
  base_->setStale(age.has_value());
  motion_->setStale(age.has_value());
}

void BaseStateView::connectNow() {
  if (const auto done = context().commands.run("robot.connect-now"); !done) {
    problem_->setText(QString::fromStdString(done.error().text));
    problem_->show();
  }
}

void BaseStateView::showBase(const DriveState* state, std::optional<double> staleAge) {
  motors_->setChecked(state != nullptr && state->motors_on());
  sonar_->setChecked(state != nullptr && state->sonar_on());
  showStop(state);
  if (state == nullptr) {
    battery_->show({});
    base_->set("baseBatteryWarning", {});
    for (const char* row :
         {"baseMotorsState", "baseSonarState", "baseStall", "baseBumpers", "baseTemperature", "baseFaults"})
      base_->set(row, {});
    return;
  }
  const auto known = context().robots.find(robot_);
  const auto* description = known == context().robots.end() ? nullptr : known->second.get();
  BatteryLevel level = BatteryLevel::of(*state, description ? description->battery : std::nullopt);
  level.age = staleAge;
  battery_->show(level);
  base_->set("baseBatteryWarning", level.warning(),
             level.state == BatteryLevel::State::kEmpty ? Meaning::kBad : Meaning::kWarning);
  base_->set("baseMotorsState", state->motors_on() ? tr("on") : tr("off"),
             state->motors_on() ? Meaning::kGood : Meaning::kMuted);
  base_->set("baseSonarState", state->sonar_on() ? tr("on") : tr("off"),
             state->sonar_on() ? Meaning::kGood : Meaning::kMuted);
  const bool left = state->left_stalled(), right = state->right_stalled();
  if (left || right) {
    base_->set("baseStall",
               left && right ? tr("both sides are stalled")
               : left        ? tr("left is stalled")
                             : tr("right is stalled"),
               Meaning::kBad);
  } else {
    base_->set("baseStall", tr("none"));
  }
  const QString pressed = bumpersText(*state);
  const bool fitted = state->front_bumpers_size() + state->rear_bumpers_size() > 0;
  if (pressed.isEmpty()) {
    base_->set("baseBumpers", fitted ? tr("free") : tr("not fitted"));
  } else {
    base_->set("baseBumpers", tr("pressed: %1").arg(pressed), Meaning::kBad);
  }
  base_->set("baseTemperature",
             state->has_temperature() ? tr("%1 °C").arg(state->temperature(), 0, 'f', 0) : QString());
  if (state->fault_flags() == 0) {
    base_->set("baseFaults", tr("none"));
  } else {
    base_->set("baseFaults", QStringLiteral("0x%1").arg(state->fault_flags(), 4, 16, QLatin1Char('0')),
               Meaning::kWarning);
  }
}

void BaseStateView::showStop(const DriveState* state) {
  const auto* status = session().store().latestAs<robotcontrol::SimulationStatus>(
      robotlink::streams::kSimulation, session().timeline().shown());
  const bool here = status != nullptr &&
                    std::ranges::find(status->stopped_robots(), robot_) != status->stopped_robots().end();
  if (here) {
    base_->set("baseEmergency", tr("STOP is engaged in this workbench"), Meaning::kBad);
  } else if (state != nullptr && state->emergency_stop()) {
    base_->set("baseEmergency", tr("pressed on the robot"), Meaning::kBad);
  } else {
    base_->set("baseEmergency", state == nullptr ? QString() : tr("released"));
  }
}

void BaseStateView::showMotion(const DriveState* state) {
  if (state == nullptr) {
    for (const char* row : {"baseOdometry", "baseReal", "baseWheels"}) motion_->set(row, {});
  } else {
    motion_->set("baseOdometry", tr("%1 m, %2 m, %3°")
                                     .arg(state->odometry().x() + 0.0, 0, 'f', 3)
                                     .arg(state->odometry().y() + 0.0, 0, 'f', 3)
                                     .arg(robotlink::degrees(state->odometry().heading()) + 0.0, 0, 'f', 1));
    motion_->set("baseReal", speedText(state->velocity()));
    motion_->set("baseWheels", tr("left %1, right %2 mm/s")
                                   .arg(state->left_speed() * 1000 + 0.0, 0, 'f', 0)
                                   .arg(state->right_speed() * 1000 + 0.0, 0, 'f', 0));
  }
  const auto* request =
      newestOf<robotcontrol::DriveRequest>(session(), robot_, robotlink::kDriveRequest.name);
  motion_->set("baseAsked", request == nullptr ? QString() : speedText(request->velocity()));
}

void BaseStateView::showLink(const LinkStatus* status, double age) {
  connectNow_->setVisible(status != nullptr && status->state() == LinkStatus::LOST &&
                          session().timeline().live());
  if (status == nullptr) {
    for (const char* row : {"linkAddress", "linkRobot", "linkClient", "linkPackets", "linkErrors",
                            "linkRoundTrip", "linkGap", "linkReconnects"})
      link_->set(row, {});
    link_->set("linkState", tr("not reported"));
    return link_->set("linkText", {});
  }
  const LinkWords words = linkWords(*status, age);
  link_->set("linkState", words.state, words.meaning);
  link_->set("linkAddress", QString::fromStdString(status->address()));
  link_->set("linkRobot", words.robot);
  link_->set("linkClient", words.client);
  link_->set("linkPackets", tr("%1/s, %2 kB/s; %3 in all")
                                .arg(status->packets_per_second(), 0, 'f', 1)
                                .arg(status->bytes_per_second() / 1000, 0, 'f', 1)
                                .arg(status->packets()));
  if (status->checksum_errors() == 0 && status->skipped_bytes() == 0) {
    link_->set("linkErrors", tr("none"));
  } else {
    link_->set("linkErrors",
               tr("%1, %2 lost")
                   .arg(counted(status->checksum_errors(), tr("1 checksum"), tr("%1 checksums")),
                        counted(status->skipped_bytes(), tr("1 byte"), tr("%1 bytes"))),
               Meaning::kWarning);
  }
  link_->set("linkRoundTrip",
             status->round_trip() > 0 ? tr("%1 ms").arg(status->round_trip() * 1000, 0, 'f', 1) : QString());
  if (words.longGap) {
    link_->set("linkGap", tr("%1 ms: too long").arg(status->longest_gap() * 1000, 0, 'f', 0),
               Meaning::kWarning);
  } else {
    link_->set("linkGap", status->longest_gap() > 0 ? tr("%1 ms").arg(status->longest_gap() * 1000, 0, 'f', 0)
                                                    : QString());
  }
  link_->set("linkReconnects", timesText(status->reconnects()));
  link_->set("linkText", QString::fromStdString(status->text()),
             words.meaning == Meaning::kGood ? Meaning::kMuted : words.meaning);
}

QString BaseStateView::timesText(std::uint64_t count) {
  if (count == 0) return tr("never");
  return count == 2 ? tr("twice") : counted(count, tr("once"), tr("%1 times"));
}

}  // namespace widgets
