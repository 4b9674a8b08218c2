// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/overview/RobotCard.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <filesystem>
#include <optional>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/RobotTeams.h"
#include "robotlink/session/Session.h"
#include "widgets/BaseSilence.h"
#include "widgets/View.h"
#include "widgets/drive/LinkWords.h"
#include "widgets/world/RobotBeliefs.h"

namespace widgets {
namespace {

namespace streams = robotlink::streams;
using robotcontrol::HostingStatus;
using robotlink::Instant;

/// A program without a frame for this long is shown as stopped.
constexpr double kSilentFrames = 1.5;  // s
/// The tasks that decide what a robot does; the first that it has is named.
constexpr const char* kDecidingTasks[] = {"behavior", "driving"};
constexpr char kBatteryReading[] = "batteryLevel";

struct CardTexts {
  Q_DECLARE_TR_FUNCTIONS(RobotCard)
};

/// The data about a robot.
struct Known {
  const ViewContext& context;
  const std::string& robot;
  Instant shown;

  template <typename T>
  const T* latest(const std::string& path) const {
    return context.session.store().latestAs<T>(path, shown);
  }
  template <typename T>
  const T* ofRobot(const char* path) const {
    return latest<T>(robot + '/' + path);
  }
  template <typename Names>
  bool isIn(const Names& names) const {
    return std::find(names.begin(), names.end(), robot) != names.end();
  }
  const robotcontrol::ReplayStatus::Log* log() const {
    const auto* replay = latest<robotcontrol::ReplayStatus>(streams::kReplay);
    if (replay == nullptr) return nullptr;
    for (const auto& each : replay->logs())
      if (isIn(each.robots())) return &each;
    return nullptr;
  }
  const robotlink::RemoteRobot* remote() const {
    const auto& robots = context.session.remoteRobots();
    const auto found = robots.find(robot);
    return found == robots.end() ? nullptr : &found->second;
  }
};

/// Returns why the robot's program does not do what it should; empty if it does.
CardText programTrouble(const Known& known) {
  const auto* hosting = known.ofRobot<HostingStatus>(streams::kHosting);
  if (hosting == nullptr || hosting->state() == HostingStatus::RUNNING) return {};
  const QString why = QString::fromStdString(hosting->text());
  const QString what = hosting->state() == HostingStatus::ENDED ? CardTexts::tr("program ended")
                       : hosting->state() == HostingStatus::NOT_ANSWERING
                           ? CardTexts::tr("program does not answer")
                           : CardTexts::tr("stands");
  const QString first = why.section(QLatin1Char('.'), 0, 0);
  return {first.isEmpty() ? what : CardTexts::tr("%1: %2").arg(what, first), Meaning::kBad,
          CardTexts::tr("%1: %2").arg(what, why)};
}

CardText stopped(const Known& known) {
  const auto* status = known.latest<robotcontrol::SimulationStatus>(streams::kSimulation);
  if (status != nullptr && known.isIn(status->stopped_robots()))
    return {CardTexts::tr("stopped: STOP is engaged"), Meaning::kBad};
  const auto* drive = known.ofRobot<robotcontrol::DriveState>(robotlink::kDriveState.name);
  if (drive != nullptr && drive->emergency_stop())
    return {CardTexts::tr("stopped: emergency stop on the robot"), Meaning::kBad};
  return {};
}

/// For how many seconds no process of the robot has had a frame; unset if none ever had one.
std::optional<double> frameSilence(const Known& known) {
  std::optional<Instant> newest;
  for (const auto* stream : known.context.session.store().streams(known.robot + '/' + streams::kFrames)) {
    const auto* message = known.context.session.store().latest(stream->path, known.shown);
    if (message != nullptr) newest = std::max(newest.value_or(message->time), message->time);
  }
  if (!newest) return std::nullopt;
  return robotlink::seconds(known.shown - *newest);
}

CardText running(const Known& known) {
  const auto silence = frameSilence(known);
  const auto base = baseSilence(known.context.session.store(), known.robot, known.shown);
  if (base) return {CardTexts::tr("silent for %1 s").arg(*base, 0, 'f', 0), Meaning::kWarning};
  if (!silence) return {CardTexts::tr("waits for its program"), Meaning::kNote};
  if (*silence > kSilentFrames)
    return {CardTexts::tr("no frame for %1 s").arg(*silence, 0, 'f', 0), Meaning::kWarning};
  return {CardTexts::tr("running"), Meaning::kGood};
}

CardText cardState(const Known& known) {
  if (CardText trouble = programTrouble(known); !trouble.text.isEmpty()) return trouble;
  if (CardText stop = stopped(known); !stop.text.isEmpty()) return stop;
  if (const auto* remote = known.remote())
    return remote->isConnected ? running(known) : CardText{CardTexts::tr("not connected"), Meaning::kMuted};
  if (known.log() != nullptr) {
    const bool playing = known.latest<robotcontrol::ReplayStatus>(streams::kReplay)->playing();
    return playing ? CardText{CardTexts::tr("log, playing"), Meaning::kGood}
                   : CardText{CardTexts::tr("log, paused"), Meaning::kNote};
  }
  const auto* status = known.latest<robotcontrol::SimulationStatus>(streams::kSimulation);
  const bool pauses = status != nullptr && !status->is_real() && known.isIn(status->robots());
  if (pauses && !status->running()) return {CardTexts::tr("paused"), Meaning::kNote};
  return running(known);
}

CardText cardBehavior(const Known& known) {
  const auto* table = known.ofRobot<robotcontrol::SolutionTable>(streams::kSolutions);
  if (table == nullptr) return {};
  for (const char* wanted : kDecidingTasks) {
    for (const auto& task : table->tasks()) {
      if (task.name() != wanted || task.active().empty()) continue;
      return {CardTexts::tr("%1: %2").arg(QString::fromStdString(task.name()),
                                          QString::fromStdString(task.active()))};
    }
  }
  return {};
}

CardText cardLink(const Known& known) {
  if (const auto* remote = known.remote()) {
    const QString state = QString::fromStdString(remote->state);
    return {state.section(QLatin1Char(':'), 0, 0),
            remote->isConnected                           ? Meaning::kGood
            : state.startsWith(QStringLiteral("refused")) ? Meaning::kBad
                                                          : Meaning::kWarning,
            QStringLiteral("%1: %2").arg(QString::fromStdString(remote->url), state)};
  }
  if (const auto* log = known.log()) {
    const std::filesystem::path path(log->path());
    return {QString::fromStdString(path.filename().string()), Meaning::kMuted,
            QString::fromStdString(path.string())};
  }
  const auto* message =
      known.context.session.store().latest(known.robot + '/' + robotlink::kLinkStatus.name, known.shown);
  const auto* status =
      message == nullptr ? nullptr : dynamic_cast<const robotcontrol::LinkStatus*>(message->value.get());
  if (status != nullptr) {
    const LinkWords words = linkWords(*status, robotlink::seconds(known.shown - message->time));
    return {words.state, words.meaning, QString::fromStdString(status->text())};
  }
  const auto* simulation = known.latest<robotcontrol::SimulationStatus>(streams::kSimulation);
  if (simulation == nullptr || !known.isIn(simulation->robots())) return {};
  return simulation->is_real() ? CardText{} : CardText{CardTexts::tr("simulated here")};
}

BatteryLevel batteryOfRobot(const Known& known) {
  const auto described = known.context.robots.find(known.robot);
  const auto* description = described == known.context.robots.end() ? nullptr : described->second.get();
  if (const auto* drive = known.ofRobot<robotcontrol::DriveState>(robotlink::kDriveState.name)) {
    return BatteryLevel::of(*drive, description != nullptr ? description->battery : std::nullopt);
  }
  const auto* body = known.ofRobot<robotcontrol::BodyReadings>(robotlink::kBodyReadings.name);
  if (body == nullptr) return {};
  for (const auto& reading : body->readings()) {
    if (reading.name() == kBatteryReading) return BatteryLevel::ofShare(reading.value());
  }
  return {};
}

}  // namespace

QString RobotCard::text() const {
  QStringList lines{kind.isEmpty() ? QString::fromStdString(robot)
                                   : QStringLiteral("%1, %2").arg(QString::fromStdString(robot), kind)};
  for (const CardText* each : {&state, &behavior}) {
    if (!each->text.isEmpty()) lines << (each->details.isEmpty() ? each->text : each->details);
  }
  if (battery.state != BatteryLevel::State::kUnknown) {
    lines << CardTexts::tr("battery: %1").arg(battery.text());
    if (const QString warning = battery.warning(); !warning.isEmpty()) lines << warning;
  }
  if (!link.text.isEmpty()) lines << (link.details.isEmpty() ? link.text : link.details);
  return lines.join(QLatin1Char('\n'));
}

RobotCard robotCard(const ViewContext& context, const std::string& robot, Instant shown) {
  const Known known{context, robot, shown};
  RobotCard card;
  card.robot = robot;
  const auto described = context.robots.find(robot);
  if (described != context.robots.end() && described->second)
    card.kind = QString::fromStdString(described->second->title);
  card.color =
      teamColor(robot, robotlink::teamOf(context.session.store(), robot, shown), context.field.get());
  card.isSelected = context.session.selectedRobot() == robot;
  card.state = cardState(known);
  card.behavior = cardBehavior(known);
  card.link = cardLink(known);
  card.battery = batteryOfRobot(known);
  return card;
}

}  // namespace widgets
