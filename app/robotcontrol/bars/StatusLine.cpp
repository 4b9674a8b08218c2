// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/StatusLine.h"

#include <algorithm>

#include <QLabel>
#include <QStatusBar>

#include "app/core/Workbench.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"
#include "widgets/BaseSilence.h"
#include "widgets/world/SceneState.h"

namespace app {
namespace {

QLabel* addLabel(QStatusBar& bar, const char* name, const QString& tip, int characters) {
  auto* label = new QLabel(&bar);
  label->setObjectName(QLatin1String(name));
  label->setToolTip(tip);
  label->setMinimumWidth(label->fontMetrics().averageCharWidth() * characters);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  bar.addPermanentWidget(label);
  return label;
}

/// Null: nothing is known of the robot.
std::shared_ptr<const robotlink::RobotDescription> descriptionOf(const Workbench& workbench,
                                                                 const std::string& robot) {
  if (workbench.loaded() != nullptr) {
    const auto found = workbench.loaded()->robots.find(robot);
    if (found != workbench.loaded()->robots.end()) return found->second;
  }
  return workbench.remote().known(robot).description;
}

}  // namespace

StatusLine::StatusLine(Workbench& workbench, QStatusBar& bar)
    : QObject(&bar),
      workbench_(workbench),
      state_(addLabel(bar, "statusState", tr("State of the simulation or the log"), 10)),
      time_(addLabel(bar, "statusTime", tr("Simulated time; in a log the shown time and frame"), 12)),
      speed_(
          addLabel(bar, "statusSpeed", tr("Speed of the simulation or the log, relative to real time"), 10)),
      contacts_(addLabel(bar, "statusContacts", tr("How often a robot has touched the ball"), 16)),
      dropped_(addLabel(bar, "statusDropped", tr("Messages dropped because too many arrived"), 12)) {}

void StatusLine::refresh() {
  auto& session = workbench_.session();
  const auto newest = session.timeline().newest();
  dropped_->setText(tr("%1 dropped").arg(session.dropped()));
  if (const auto* log =
          session.store().latestAs<robotcontrol::ReplayStatus>(robotlink::streams::kReplay, newest)) {
    showLog(*log);
  } else if (const auto* simulation = session.store().latestAs<robotcontrol::SimulationStatus>(
                 robotlink::streams::kSimulation, newest)) {
    showSimulation(*simulation);
  } else {
    showNothing();
  }
}

QString StatusLine::robotState(const robotcontrol::SimulationStatus& status) {
  auto& session = workbench_.session();
  const std::string robot = status.robots().empty() ? std::string() : status.robots(0);
  const auto newest = session.timeline().newest();
  subscription_.want(session, robot, {robotlink::kDriveState.name, robotlink::kLinkStatus.name});
  const auto* heard = session.store().latest(robot + '/' + robotlink::kDriveState.name, newest);
  const double silence = heard == nullptr ? 0 : robotlink::seconds(newest - heard->time);
  const auto* link =
      session.store().latestAs<robotcontrol::LinkStatus>(robot + '/' + robotlink::kLinkStatus.name, newest);
  const auto described = descriptionOf(workbench_, robot);
  const bool hasBase = described && described->drive;
  // A camera on a tripod has no line whose state it could say.
  const bool hasLine = link != nullptr || !described || hasBase || !described->joints.empty();
  const bool connected = link != nullptr ? link->state() == robotcontrol::LinkStatus::CONNECTED : !hasLine;
  const bool connecting = link != nullptr && link->state() == robotcontrol::LinkStatus::CONNECTING;
  if (heard == nullptr && hasBase && connected) return tr("connected");
  if (connected && silence < widgets::kSilentAfter) return tr("running");
  if (heard == nullptr) return connecting ? tr("connecting") : tr("not connected");
  const QString what = connected ? tr("silent") : connecting ? tr("connecting") : tr("lost");
  return tr("%1, last heard %2 s ago").arg(what).arg(silence, 0, 'f', 0);
}

bool StatusLine::isLost() const {
  const auto& remote = workbench_.session().remoteRobots();
  return workbench_.loaded() == nullptr && !remote.empty() &&
         std::ranges::none_of(remote, [](const auto& one) { return one.second.isConnected; });
}

void StatusLine::showSimulation(const robotcontrol::SimulationStatus& status) {
  state_->setText(workbench_.loading()               ? tr("loading…")
                  : isLost()                         ? tr("not connected")
                  : status.stopped_robots_size() > 0 ? tr("STOP engaged")
                  : status.is_real()                 ? robotState(status)
                  : status.running()                 ? tr("running")
                                                     : tr("paused"));
  time_->setText(tr("%1 s").arg(status.time(), 0, 'f', 3));
  speed_->setText(isLost()           ? QString()
                  : status.is_real() ? tr("real time")
                                     : tr("sim %1×").arg(status.speed(), 0, 'f', 1));
  const auto contacts = status.ball_contacts();
  const auto& models = status.models();
  if (std::find(models.begin(), models.end(), widgets::kBallModel) == models.end()) return contacts_->clear();
  contacts_->setText(contacts == 1 ? tr("1 ball contact") : tr("%1 ball contacts").arg(contacts));
}

void StatusLine::showLog(const robotcontrol::ReplayStatus& status) {
  state_->setText(workbench_.loading() ? tr("loading…") : status.playing() ? tr("playing") : tr("paused"));
  const robotlink::Instant shown{robotlink::Duration(status.time())};
  const double time = robotlink::seconds(workbench_.session().timeline().sinceOrigin(shown));
  time_->setText(tr("%1 s  frame %2").arg(time, 0, 'f', 3).arg(status.frame()));
  speed_->setText(tr("log %1×").arg(status.speed()));
  contacts_->clear();
}

void StatusLine::showNothing() {
  const auto& remote = workbench_.session().remoteRobots();
  const bool isConnected =
      std::ranges::any_of(remote, [](const auto& one) { return one.second.isConnected; });
  state_->setText(workbench_.loading()           ? tr("loading…")
                  : isConnected                  ? tr("connected")
                  : !workbench_.remote().empty() ? tr("not connected")
                                                 : tr("nothing is open"));
  for (QLabel* label : {time_, speed_, contacts_}) label->clear();
}

}  // namespace app
