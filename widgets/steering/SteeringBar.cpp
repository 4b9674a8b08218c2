// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/steering/SteeringBar.h"

#include <QAction>
#include <QBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "robotlink/commands/CommandTable.h"
#include "widgets/Controls.h"

namespace widgets {

using Who = SteeringState::Who;

SteeringBar::SteeringBar(const robotlink::CommandTable& commands, QWidget* parent)
    : QWidget(parent), commands_(commands) {
  setObjectName(QStringLiteral("steeringBar"));
  text_ = makeNote(this, "steeringText", tr("Who steers"));
  take_ = makeAction(this, "take-over", {"steeringTake", tr("Steer instead"), {}});
  button_ = makeLabeledButton(this, take_);
  button_->setAutoRaise(false);
  button_->setFocusPolicy(Qt::TabFocus);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(text_, 1);
  layout->addWidget(button_);
  connect(take_, &QAction::triggered, this, &SteeringBar::run);
  hide();
}

void SteeringBar::refresh(robotlink::Session& session, const std::string& robot) {
  robot_ = robot;
  state_ = steeringState(session, robot);
  const bool isShown = state_ && state_->who != Who::kNobody;
  setVisible(isShown);
  if (!isShown) return;
  const bool isOther = state_->isOthers();
  text_->setText(isOther ? tr("%1 Your commands are not sent.").arg(state_->text) : state_->text);
  text_->setToolTip(state_->details);
  setMeaning(*text_, isOther ? std::optional(Meaning::kWarning) : std::nullopt);
  take_->setText(isOther ? tr("Steer instead") : tr("Let others steer"));
  take_->setToolTip(isOther ? tr("Takes control; the robot stays still until you send a command")
                            : tr("Releases control to others; the robot stops"));
}

void SteeringBar::run() {
  if (!state_) return;
  // Objections of the robot are shown as an error of the window.
  static_cast<void>(commands_.run("robot.steer", {robot_, state_->who == Who::kOther}));
}

}  // namespace widgets
