// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/game/LayoutRow.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "robotlink/commands/CommandTable.h"
#include "widgets/Controls.h"

namespace widgets {
namespace {

constexpr char kLayoutCommand[] = "layout.open";

}  // namespace

LayoutRow::LayoutRow(robotlink::CommandTable& commands, QWidget* parent)
    : QWidget(parent), commands_(commands) {
  layouts_ = new QComboBox(this);
  describe(*layouts_, {"gameLayout", tr("Layout"), tr("The process layout for a robot or a team")});
  forRobot_ = makeAction(this, "robot",
                         {"gameLayoutRobot", tr("For the robot"),
                          tr("Restarts the program of the chosen robot in this layout")});
  forTeam_ = makeAction(this, "robot",
                        {"gameLayoutTeam", tr("For its team"),
                         tr("Restarts the programs of the chosen robot's team in this layout")});
  auto* label = new QLabel(tr("Layout"), this);
  label->setBuddy(layouts_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(label);
  row->addWidget(layouts_);
  row->addWidget(makeLabeledButton(this, forRobot_));
  row->addWidget(makeLabeledButton(this, forTeam_));
  row->addStretch(1);
  connect(forRobot_, &QAction::triggered, this, [this] { use(robot_); });
  connect(forTeam_, &QAction::triggered, this, [this] { use(team_); });
}

void LayoutRow::showFor(const QString& robot, const QString& team, const QString& running) {
  const bool isOther = robot != robot_ || running != running_;
  robot_ = robot;
  team_ = team;
  running_ = running;
  const auto* command = commands_.find(kLayoutCommand);
  const bool isOffered = command != nullptr && command->offer;
  setVisible(isOffered);
  const bool isEmpty = layouts_->count() == 0;
  if (isOffered && isEmpty) {
    for (const std::string& layout : command->offer({})) layouts_->addItem(QString::fromStdString(layout));
  }
  if (isOther || isEmpty) {
    // A layout of another folder is not offered by the command.
    if (!running.isEmpty() && layouts_->findText(running) < 0) layouts_->addItem(running);
    layouts_->setCurrentIndex(std::max(0, layouts_->findText(running)));
  }
  forRobot_->setEnabled(layouts_->count() > 0 && !robot.isEmpty());
  forTeam_->setEnabled(layouts_->count() > 0 && !team.isEmpty());
}

void LayoutRow::use(const QString& name) {
  const auto done =
      commands_.run(kLayoutCommand, {layouts_->currentText().toStdString(), name.toStdString()});
  Q_EMIT asked(done ? QString() : QString::fromStdString(done.error().text));
}

}  // namespace widgets
