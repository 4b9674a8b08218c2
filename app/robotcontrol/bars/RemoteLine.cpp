// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/RemoteLine.h"

#include <QStatusBar>
#include <QToolButton>
#include <algorithm>

#include "app/core/Workbench.h"
#include "app/robotcontrol/actions/CommandActions.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/steering/SteeringState.h"

namespace app {
namespace {

using widgets::Meaning;
using Who = widgets::SteeringState::Who;
using Phase = robotlink::websocket::ConnectionState::Phase;

/// Longer texts are for the tooltip. All connections together have at least this room, and more where the
/// bar has it.
constexpr int kStateCharacters = 56, kMaxStateCharacters = 112;
/// The number of characters that a button keeps of its text when the window gets narrower.
constexpr int kMinCharacters = 6;
/// Further connections are shown as their number.
constexpr std::size_t kMaxConnections = 3;

/// The robots of a connection, or where it leads.
QString whoOf(const RemoteRobots::Connection& connection) {
  QStringList robots;
  for (const std::string& robot : connection.robots) robots << QString::fromStdString(robot);
  return robots.isEmpty() ? QString::fromStdString(connection.url) : robots.join(QStringLiteral(", "));
}

Meaning meaningOf(Phase phase) {
  switch (phase) {
    case Phase::kConnected:
      return Meaning::kGood;
    case Phase::kConnecting:
      return Meaning::kNote;
    case Phase::kSilent:
      return Meaning::kWarning;
    case Phase::kRefused:
      return Meaning::kBad;
  }
  return Meaning::kMuted;
}

/// The state of one of several connections; its color says whether it is connected.
QString shortText(const QString& text) {
  const QString connected = QStringLiteral("connected, ");
  return text.startsWith(connected) ? text.mid(connected.size()) : text;
}

int widthOf(const QWidget& widget, int characters) {
  return widget.fontMetrics().averageCharWidth() * characters;
}

/// Elides the text to a width, in pixels.
void show(QToolButton& button, const QString& text, Meaning meaning, int width) {
  button.setText(button.fontMetrics().elidedText(text, Qt::ElideRight, width));
  QPalette colors = button.parentWidget()->palette();
  colors.setColor(QPalette::ButtonText, widgets::colorOf(meaning, colors));
  if (button.palette() != colors) button.setPalette(colors);
  button.show();
}

}  // namespace

RemoteLine::RemoteLine(Workbench& workbench, CommandActions& actions, QStatusBar& bar)
    : QObject(&bar),
      workbench_(workbench),
      actions_(actions),
      bar_(bar),
      offer_(addButton(QStringLiteral("statusOffer"))),
      steering_(addButton(QStringLiteral("statusSteering"))) {
  connect(offer_, &QToolButton::clicked, this, &RemoteLine::offerClicked);
  connect(steering_, &QToolButton::clicked, this, &RemoteLine::takeSteering);
}

QToolButton* RemoteLine::addButton(const QString& name) {
  auto* button = new QToolButton(&bar_);
  button->setObjectName(name);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  bar_.insertPermanentWidget(0, button);
  // A long text does not keep the window wide.
  button->setMinimumWidth(widthOf(*button, kMinCharacters));
  button->hide();
  return button;
}

int RemoteLine::room(std::size_t shown) const {
  // Gaps between widgets, and the frames of these buttons.
  const int beside = widthOf(bar_, 2);
  int others = static_cast<int>(shown) * beside;
  for (const auto* widget : bar_.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    const bool isConnection = std::ranges::find(connections_, widget) != connections_.end();
    if (isConnection || widget->isHidden()) continue;
    others += std::max(widget->sizeHint().width(), widget->minimumWidth()) + beside;
  }
  return std::clamp(bar_.width() - others, widthOf(bar_, kStateCharacters),
                    widthOf(bar_, kMaxStateCharacters));
}

void RemoteLine::refresh() {
  showConnections();
  showOffer();
  showSteering();
}

QString RemoteLine::tipOf(const RemoteRobots::Connection& connection) {
  const QString tip =
      tr("%1: %2\nClick to see all connections and limit their data rates")
          .arg(QString::fromStdString(connection.url), QString::fromStdString(connection.text));
  if (!connection.state.isConnected() || !connection.state.roundTrip) return tip;
  return tip + QLatin1Char('\n') +
         tr("The milliseconds include waiting behind other "
            "data: on a slow link that is most of them.");
}

void RemoteLine::showConnections() {
  const auto connections = workbench_.remote().connections();
  const std::size_t shown = connections.size() > kMaxConnections ? 1 : connections.size();
  while (connections_.size() < shown) {
    connections_.push_back(addButton(QStringLiteral("statusRemote%1").arg(connections_.size() + 1)));
    connect(connections_.back(), &QToolButton::clicked, this, &RemoteLine::connectionsClicked);
  }
  for (std::size_t i = shown; i < connections_.size(); ++i) connections_[i]->hide();
  if (connections.size() > kMaxConnections) return showAll(connections);
  const int width = shown == 0 ? 0 : room(shown) / static_cast<int>(shown);
  for (std::size_t i = 0; i < shown; ++i) {
    const QString who = whoOf(connections[i]);
    const QString text = QString::fromStdString(connections[i].text);
    show(*connections_[i], QStringLiteral("%1: %2").arg(who, shown > 1 ? shortText(text) : text),
         meaningOf(connections[i].state.phase), width);
    connections_[i]->setToolTip(tipOf(connections[i]));
    connections_[i]->setAccessibleName(tr("Connection to %1").arg(who));
  }
}

void RemoteLine::showAll(const std::vector<RemoteRobots::Connection>& connections) {
  QStringList lines;
  int connected = 0;
  for (const auto& connection : connections) {
    connected += connection.state.isConnected() ? 1 : 0;
    lines << QStringLiteral("%1: %2").arg(whoOf(connection), QString::fromStdString(connection.text));
  }
  const int all = static_cast<int>(connections.size());
  show(*connections_[0], tr("%1 of %2 connections are up").arg(connected).arg(all),
       connected == all ? Meaning::kGood : Meaning::kWarning, room(1));
  connections_[0]->setToolTip(lines.join(QLatin1Char('\n')));
  connections_[0]->setAccessibleName(tr("Connections"));
}

void RemoteLine::showOffer() {
  const SessionOffer& offer = workbench_.offer();
  if (!offer.isOffered()) return offer_->hide();
  const QString url = QString::fromStdString(offer.url());
  const QString who = offer.clients().empty()
                          ? tr("no client is connected")
                          : widgets::counted(offer.clients().size(), tr("1 client"), tr("%1 clients"));
  show(*offer_, tr("Offered: %1").arg(who), Meaning::kNote, widthOf(*offer_, kStateCharacters));
  offer_->setToolTip(tr("This session is offered at %1: %2").arg(url, who));
  offer_->setAccessibleName(tr("State of the offered session"));
}

void RemoteLine::showSteering() {
  const std::string& robot = workbench_.session().selectedRobot();
  const auto state = widgets::steeringState(workbench_.session(), robot);
  if (!state || state->who == Who::kNobody) return steering_->hide();
  const bool isOther = state->who == Who::kOther;
  // The address is left out, since there is no room for it.
  const QString other = state->name.section(QStringLiteral(" at "), 0, 0);
  show(*steering_,
       isOther ? tr("%1 steers %2. Steer instead").arg(other, QString::fromStdString(robot)) : state->text,
       isOther ? Meaning::kWarning : Meaning::kGood, widthOf(*steering_, kStateCharacters));
  steering_->setToolTip(isOther ? tr("%1 Click to take control; anyone can press STOP.").arg(state->text)
                                : tr("%1 Click to release control to others.").arg(state->text));
  steering_->setAccessibleName(tr("Who steers"));
}

void RemoteLine::takeSteering() {
  const std::string robot = workbench_.session().selectedRobot();
  const auto state = widgets::steeringState(workbench_.session(), robot);
  if (state) actions_.run(QStringLiteral("robot.steer"), {robot, state->who == Who::kOther});
}

}  // namespace app
