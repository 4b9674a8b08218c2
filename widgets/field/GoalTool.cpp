// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/GoalTool.h"

#include <QAction>
#include <algorithm>
#include <cmath>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/field/FieldCanvas.h"

namespace widgets {
namespace {

constexpr double kTurnPixels = 14;  // shorter drags choose no heading

GoalSender::Aim aimAt(const FieldCanvas& canvas, double x, double y, int place) {
  if (place < 0 || canvas.map() == nullptr) return {{x, y, 0}, true, {}};
  const auto& pressed = canvas.map()->places(place);
  return {robotlink::pose2(pressed.pose()), !pressed.has_heading(), pressed.name()};
}

}  // namespace

GoalTool::GoalTool(QWidget& owner, FieldCanvas& canvas, robotlink::Session& session)
    : QObject(&owner), canvas_(canvas), session_(session) {
  send_ = makeToggle(
      &owner, "goal",
      {"fieldSend", tr("Send the robot"),
       tr("A click sends the robot there, dragging sets its final heading; otherwise only with Control"),
       Qt::Key_G});
  cancel_ =
      makeAction(&owner, "cancel-goal",
                 {"fieldCancelGoal", tr("Cancel the goal"), tr("Cancels the robot's goal"), Qt::Key_Escape});
  connect(send_, &QAction::toggled, this, &GoalTool::show);
  connect(cancel_, &QAction::triggered, this, &GoalTool::cancelGoal);
  connectCanvas();
}

void GoalTool::connectCanvas() {
  connect(&canvas_, &FieldCanvas::aimStarted, this, [this](double x, double y, int place) {
    sender_.begin(aimAt(canvas_, x, y, place));
    show();
  });
  connect(&canvas_, &FieldCanvas::aimMoved, this, [this](double x, double y) {
    const QTransform transform = canvas_.transform();
    sender_.moveTo({x, y}, kTurnPixels / std::hypot(transform.m11(), transform.m12()));
    show();
  });
  connect(&canvas_, &FieldCanvas::aimEnded, this, [this] {
    if (!robot_.empty()) sender_.end(session_, robot_);
    show();
  });
}

bool GoalTool::going() const {
  return std::any_of(aims_.begin(), aims_.end(), [this](const DriveAim& aim) { return aim.robot == robot_; });
}

void GoalTool::cancelGoal() {
  if (sender_.aim()) {
    sender_.abandon();
    canvas_.abandonAim();
  } else if (!robot_.empty()) {
    sender_.cancelGoal(session_, robot_);
  }
  show();
}

void GoalTool::tick(const std::string& robot, std::vector<DriveAim> aims) {
  if (robot != robot_) sender_.abandon();
  robot_ = robot;
  aims_ = std::move(aims);
  sender_.tick();
  if (sender_.sent()) {
    const auto& sent = sender_.sent()->pose;
    const bool answered = std::any_of(aims_.begin(), aims_.end(), [&](const DriveAim& aim) {
      return aim.robot == robot_ && (aim.goal.translation() - sent.translation()).norm() < 0.05;
    });
    if (answered) sender_.settled();
  }
  show();
}

QString GoalTool::refusal() const {
  return sender_.refusal();
}

void GoalTool::show() {
  const bool possible = !robot_.empty();
  send_->setVisible(possible);
  cancel_->setVisible(possible);
  cancel_->setEnabled(sender_.aim().has_value() || sender_.sent().has_value() || going());
  canvas_.setAiming(possible, send_->isChecked());
  canvas_.setGoals({aims_, sender_.aim() ? sender_.aim() : sender_.sent()});
}

}  // namespace widgets
