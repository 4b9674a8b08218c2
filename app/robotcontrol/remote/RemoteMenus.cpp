// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/remote/RemoteMenus.h"

#include <QJsonArray>
#include <QMenu>

#include "app/core/Workbench.h"
#include "app/platforms/body/BodyFeed.h"
#include "app/robotcontrol/remote/FoundRobots.h"
#include "app/robotcontrol/remote/OfferDialog.h"
#include "app/robotcontrol/remote/RecordingsDialog.h"
#include "app/robotcontrol/remote/RemoteDialog.h"
#include "app/robotcontrol/remote/RemoteQuestions.h"
#include "app/robotcontrol/remote/RobotsDialog.h"
#include "widgets/Icon.h"

namespace app {

RemoteMenus::RemoteMenus(Workbench& workbench, CommandActions& actions, QWidget* window)
    : QObject(window),
      workbench_(workbench),
      connect_(new RemoteDialog(workbench.commands(), workbench.remote(), window)),
      offer_(new OfferDialog(workbench.commands(), workbench.offer(), window)),
      recordings_(new RecordingsDialog(workbench, actions, window)),
      questions_(new RemoteQuestions(workbench, actions, window)),
      robots_(new RobotsDialog(workbench, actions, window)) {}

void RemoteMenus::addConnect(QMenu& menu) {
  QAction* join = menu.addAction(widgets::icon("connect"), tr("C&onnect…"), this, &RemoteMenus::showConnect,
                                 QKeySequence(QStringLiteral("Ctrl+J")));
  join->setObjectName(QStringLiteral("remote.connect"));
  join->setToolTip(tr("Watches and controls remote robots, in addition to those that are open here"));
  again_ = menu.addMenu(tr("Connect &again"));
  again_->setObjectName(QStringLiteral("remoteAgain"));
  again_->setToolTipsVisible(true);
  connect(again_, &QMenu::aboutToShow, this, &RemoteMenus::fillAgain);
}

void RemoteMenus::addOffer(QMenu& menu) {
  QAction* offer = menu.addAction(tr("O&ffer this session…"), this, &RemoteMenus::showOffer);
  offer->setObjectName(QStringLiteral("session.offer"));
  offer->setToolTip(tr("Lets others watch and steer what is open here"));
}

void RemoteMenus::addRobots(QMenu& menu) {
  QAction* robots = menu.addAction(widgets::icon("robot"), tr("Ro&bots…"), this, [this] { show(*robots_); });
  robots->setObjectName(QStringLiteral("remote.robots"));
  robots->setToolTip(
      tr("Connects sets of robots, and sends them layouts, parameters, motions and color tables"));
}

void RemoteMenus::addRecordings(QMenu& menu) {
  QAction* recordings = menu.addAction(tr("&Recordings at the robot…"), this, [this] { show(*recordings_); });
  recordings->setObjectName(QStringLiteral("remote.recordings"));
  recordings->setToolTip(
      tr("Starts, downloads, opens and deletes recordings in the storage of remote robots"));
}

void RemoteMenus::fillAgain() {
  again_->clear();
  for (const RemoteDialog::Recent& server : connect_->recent()) {
    const QString text = server.robots.isEmpty() ? server.url : tr("%1 at %2").arg(server.robots, server.url);
    const QString entry = server.isHosted ? tr("%1, program here").arg(text) : text;
    again_->addAction(entry, this, [this, url = server.url.toStdString(), here = server.isHosted] {
      if (here) return host(url);
      // If no token is remembered, the user is asked for it.
      if (!workbench_.commands().run("remote.connect", {url, std::string()})) showConnect();
    });
  }
  if (again_->isEmpty()) again_->addAction(tr("Nothing was connected yet"))->setEnabled(false);
}

void RemoteMenus::show(QWidget& dialog) {
  dialog.show();
  dialog.raise();
  dialog.activateWindow();
}

void RemoteMenus::showConnect() {
  show(*connect_);
}

void RemoteMenus::showOffer() {
  show(*offer_);
}

void RemoteMenus::host(const std::string& url) {
  const auto done = workbench_.commands().run(
      "remote.host", {url, std::string(), std::string(), std::string(), std::string()});
  if (!done) showConnect();
}

void RemoteMenus::fail(const QString& reason) {
  connect_->failHosted(reason);
}

void RemoteMenus::tick() {
  connect_->tick();
  followHosted();
  followSearch();
  offer_->tick();
  recordings_->tick();
  questions_->tick();
  robots_->tick();
}

void RemoteMenus::followHosted() {
  const LoadedPlatform* loaded = workbench_.loaded();
  const bool isBody = loaded != nullptr && loaded->adapter == BodyFeed::kAdapter && !workbench_.loading();
  const std::string robot = isBody && !loaded->robots.empty() ? loaded->robots.begin()->first : std::string();
  connect_->showHosted(isBody ? QString::fromStdString(loaded->sources.front()) : QString(),
                       QString::fromStdString(robot));
  if (workbench_.asksForBody()) connect_->showAsked();
}

void RemoteMenus::followSearch() {
  RobotSearch& search = workbench_.search();
  const bool isShown = connect_->isVisible() || robots_->isVisible();
  search.setWanted(isShown);
  if (!isShown) return;
  const RobotSearch::State state = search.state();
  const auto isOwn = [this](const FoundRobots::Announced& robots) {
    return workbench_.offer().isOfferedAt(robots.address, robots.port);
  };
  connect_->found().show(state, isOwn);
  robots_->found().show(state, isOwn);
}

void RemoteMenus::load(const QJsonObject& window) {
  QList<RemoteDialog::Recent> servers;
  for (const QJsonValue& value : window.value(QStringLiteral("recent_servers")).toArray()) {
    const QString url = value.toObject().value(QStringLiteral("url")).toString();
    if (url.isEmpty()) continue;
    servers.append({url, value.toObject().value(QStringLiteral("robots")).toString(),
                    value.toObject().value(QStringLiteral("program_here")).toBool()});
  }
  connect_->setRecent(servers);
  offer_->setAddress(window.value(QStringLiteral("offer_address")).toString());
  const QString set = window.value(QStringLiteral("robot_set")).toString();
  if (!set.isEmpty()) robots_->openSet(set);
}

void RemoteMenus::save(QJsonObject& window) const {
  QJsonArray servers;
  for (const RemoteDialog::Recent& server : connect_->recent())
    servers.append(QJsonObject{{QStringLiteral("url"), server.url},
                               {QStringLiteral("robots"), server.robots},
                               {QStringLiteral("program_here"), server.isHosted}});
  window.insert(QStringLiteral("recent_servers"), servers);
  window.insert(QStringLiteral("offer_address"), offer_->address());
  window.insert(QStringLiteral("robot_set"), robots_->file());
}

}  // namespace app
