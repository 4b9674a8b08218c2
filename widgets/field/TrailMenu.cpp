// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/TrailMenu.h"

#include <QActionGroup>
#include <QJsonObject>

namespace widgets {
namespace {

/// Seconds; 0: as long as it fits the ground.
constexpr int kTrailLengths[] = {0, 2, 5, 10, 20, 30, 60};
constexpr int kTrailOnField = 10, kTrailOnMap = 60;

}  // namespace

TrailMenu::TrailMenu(QWidget* parent) : QMenu(parent) {
  setObjectName(QStringLiteral("fieldTrailMenu"));
  setToolTipsVisible(true);
  addSection(tr("Trails of"));
  robots_ = addChoice("trailRobots", tr("&Robots"),
                      tr("True paths of robots; for real robots, their estimated paths"), true);
  estimates_ = addChoice("trailEstimates", tr("&Estimated poses"),
                         tr("Estimated paths of the chosen robots, next to the true ones"), false);
  ball_ = addChoice("trailBall", tr("&Ball"), tr("True or estimated path of the ball"), true);
  addSection(tr("Length"));
  addLengths();
}

QAction* TrailMenu::addChoice(const char* name, const QString& text, const QString& toolTip, bool on) {
  QAction* action = addAction(text);
  action->setObjectName(QLatin1String(name));
  action->setToolTip(toolTip);
  action->setCheckable(true);
  action->setChecked(on);
  connect(action, &QAction::toggled, this, &TrailMenu::changed);
  return action;
}

void TrailMenu::addLengths() {
  lengths_ = new QActionGroup(this);
  for (const int seconds : kTrailLengths) {
    const QString text = seconds == 0
                             ? tr("&Automatic (%1 s, on maps %2 s)").arg(kTrailOnField).arg(kTrailOnMap)
                             : tr("%1 s").arg(seconds);
    QAction* action = addAction(text);
    action->setObjectName(QStringLiteral("trailSeconds%1").arg(seconds));
    action->setCheckable(true);
    action->setChecked(seconds == 0);
    action->setData(seconds);
    lengths_->addAction(action);
  }
  connect(lengths_, &QActionGroup::triggered, this, &TrailMenu::changed);
}

robotlink::Duration TrailMenu::reach(bool onMap) const {
  const int seconds = lengths_->checkedAction()->data().toInt();
  return std::chrono::seconds(seconds > 0 ? seconds : onMap ? kTrailOnMap : kTrailOnField);
}

bool TrailMenu::showsRobots() const {
  return robots_->isChecked();
}
bool TrailMenu::showsEstimates() const {
  return estimates_->isChecked();
}
bool TrailMenu::showsBall() const {
  return ball_->isChecked();
}

QJsonValue TrailMenu::save() const {
  return QJsonObject{{QStringLiteral("seconds"), lengths_->checkedAction()->data().toInt()},
                     {QStringLiteral("robots"), showsRobots()},
                     {QStringLiteral("estimates"), showsEstimates()},
                     {QStringLiteral("ball"), showsBall()}};
}

void TrailMenu::restore(const QJsonValue& state) {
  const QJsonObject all = state.toObject();
  const int seconds = all[QStringLiteral("seconds")].toInt();
  for (QAction* action : lengths_->actions()) {
    if (action->data().toInt() == seconds) action->setChecked(true);
  }
  robots_->setChecked(all[QStringLiteral("robots")].toBool(true));
  estimates_->setChecked(all[QStringLiteral("estimates")].toBool(false));
  ball_->setChecked(all[QStringLiteral("ball")].toBool(true));
  Q_EMIT changed();
}

}  // namespace widgets
