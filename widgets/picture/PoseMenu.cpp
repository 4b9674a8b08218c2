// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/picture/PoseMenu.h"

#include <QActionGroup>

#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/drawings/DrawingPose.h"

namespace widgets {

PoseMenu::PoseMenu(const QString& name, QWidget* parent) : QMenu(parent), choice_(QLatin1String(kUsualPose)) {
  setObjectName(name);
  setToolTipsVisible(true);
  estimates_ << QLatin1String(robotlink::kRobotPose.name);
  list();
}

void PoseMenu::refresh(robotlink::Session& session) {
  collect(session);
  if (choice_ == QLatin1String(kUsualPose) || choice_ == QLatin1String(kTruePose)) return;
  const std::string package = choice_.toStdString();
  for (const std::string& robot : session.robots()) subscription_.want(session, robot, {package.c_str()});
}

void PoseMenu::collect(robotlink::Session& session) {
  if (session.store().listVersion() == listVersion_) return;
  listVersion_ = session.store().listVersion();
  QStringList estimates(QLatin1String(robotlink::kRobotPose.name));
  for (const std::string& robot : session.robots()) {
    for (const auto* stream : session.store().streams(robot + '/')) {
      if (stream->type == "robotcontrol.RobotPose")
        estimates << QString::fromStdString(stream->path.substr(robot.size() + 1));
    }
  }
  estimates.removeDuplicates();
  estimates.sort();
  if (estimates == estimates_) return;
  estimates_ = estimates;
  list();
}

void PoseMenu::list() {
  clear();
  delete entries_;
  entries_ = new QActionGroup(this);
  addSection(tr("Robots' drawings are placed at"));
  add(QLatin1String(kUsualPose), tr("The &usual pose"),
      tr("The true pose if known, otherwise the robot's own estimate"));
  add(QLatin1String(kTruePose), tr("The &true pose"), tr("Only simulated robots have one"));
  for (const QString& estimate : choices().mid(1))
    add(estimate, tr("The estimate %1").arg(estimate), tr("The robot's own estimate of its pose"));
  connect(entries_, &QActionGroup::triggered, this,
          [this](const QAction* entry) { choose(entry->data().toString()); });
}

void PoseMenu::add(const QString& choice, const QString& text, const QString& toolTip) {
  QAction* entry = addAction(text);
  entry->setObjectName(QStringLiteral("pose") + choice);
  entry->setToolTip(toolTip);
  entry->setCheckable(true);
  entry->setChecked(choice == choice_);
  entry->setData(choice);
  entries_->addAction(entry);
}

QStringList PoseMenu::choices() const {
  QStringList all = QStringList(QLatin1String(kTruePose)) + estimates_;
  if (choice_ != QLatin1String(kUsualPose) && !all.contains(choice_)) all << choice_;
  return all;
}

void PoseMenu::setChoice(const QString& choice) {
  if (choice == choice_) return;
  choose(choice);
  list();
}

void PoseMenu::choose(const QString& choice) {
  choice_ = choice;
  // Requests of another choice say nothing about this one.
  subscription_ = {};
  Q_EMIT choiceChanged();
}

}  // namespace widgets
