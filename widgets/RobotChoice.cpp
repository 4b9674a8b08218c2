// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/RobotChoice.h"

#include "robotlink/session/Session.h"
#include "widgets/Controls.h"

namespace widgets {

void showConnections(QComboBox& robots, const robotlink::Session& session) {
  for (int i = 0; i < robots.count(); ++i) {
    const QString name = robots.itemData(i).toString();
    const auto remote = session.remoteRobots().find(name.toStdString());
    if (remote == session.remoteRobots().end()) continue;
    const QString state = QString::fromStdString(remote->second.state);
    // The text behind a colon gives the reasons.
    const QString text = remote->second.isConnected
                             ? name
                             : QStringLiteral("%1 (%2)").arg(name, state.section(QLatin1Char(':'), 0, 0));
    if (robots.itemText(i) != text) robots.setItemText(i, text);
    robots.setItemData(i, QStringLiteral("%1: %2").arg(QString::fromStdString(remote->second.url), state),
                       Qt::ToolTipRole);
  }
}

RobotChoice::RobotChoice(const char* name, QWidget* parent, Offer offer) : QComboBox(parent), offer_(offer) {
  describe(*this, {name, tr("Robot"),
                   offer == Offer::kAll ? tr("Whose drawings are shown") : tr("Which robot is shown")});
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(9);
  list({});
  connect(this, QOverload<int>::of(&QComboBox::activated), this, [this] {
    choice_ = currentData().toString();
    Q_EMIT choiceChanged();
  });
}

void RobotChoice::refresh(const robotlink::Session& session) {
  if (session.robots() != listed_) list(session.robots());
  showConnections(*this, session);
}

void RobotChoice::list(const std::vector<std::string>& robots) {
  listed_ = robots;
  clear();
  addItem(tr("Selected robot"), QString());
  if (offer_ == Offer::kAll) addItem(tr("All robots"), QStringLiteral("*"));
  for (const std::string& robot : robots)
    addItem(QString::fromStdString(robot), QString::fromStdString(robot));
  if (findData(choice_) < 0) addItem(tr("%1 (not here)").arg(choice_), choice_);
  setCurrentIndex(findData(choice_));
}

std::vector<std::string> RobotChoice::robots(const robotlink::Session& session) const {
  if (choice_ == QLatin1String("*")) return session.robots();
  const std::string one = robot(session);
  return one.empty() ? std::vector<std::string>() : std::vector<std::string>{one};
}

std::string RobotChoice::robot(const robotlink::Session& session) const {
  const bool certain = !choice_.isEmpty() && choice_ != QLatin1String("*");
  return certain ? choice_.toStdString() : session.selectedRobot();
}

void RobotChoice::setChoice(const QString& choice) {
  choice_ = choice;
  list(std::vector<std::string>(listed_));
  Q_EMIT choiceChanged();
}

}  // namespace widgets
