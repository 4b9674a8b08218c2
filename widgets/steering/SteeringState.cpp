// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/steering/SteeringState.h"

#include <QCoreApplication>

#include "robotcontrol/Linking.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"

namespace widgets {

using Who = SteeringState::Who;

namespace {

Who whoSteers(const robotcontrol::SteeringStatus& status, bool isElsewhere) {
  if (status.who().empty()) return Who::kNobody;
  // A number of 0 is that of people at the robot's own machine.
  const bool isHere = isElsewhere ? status.own() : status.client() == 0;
  return isHere ? Who::kThisPerson : Who::kOther;
}

struct SteeringText {
  Q_DECLARE_TR_FUNCTIONS(Steering)
};

QString sentenceFor(const SteeringState& state, const QString& robot) {
  if (state.who == Who::kNobody) return SteeringText::tr("Nobody steers %1.").arg(robot);
  if (state.who == Who::kThisPerson) return SteeringText::tr("You steer %1.").arg(robot);
  const QString sentence = state.isSilent
                               ? SteeringText::tr("%1 was steering %2, and has stopped responding.")
                               : SteeringText::tr("%1 steers %2.");
  return sentence.arg(state.name, robot);
}

}  // namespace

bool isLost(const robotlink::Session& session, const std::string& robot) {
  const auto remote = session.remoteRobots().find(robot);
  return remote != session.remoteRobots().end() && !remote->second.isConnected;
}

std::optional<SteeringState> steeringState(robotlink::Session& session, const std::string& robot) {
  const auto* status = session.store().latestAs<robotcontrol::SteeringStatus>(
      robot + "/" + robotlink::streams::kSteering, robotlink::Instant::max());
  if (status == nullptr || isLost(session, robot)) return std::nullopt;
  SteeringState state;
  state.who = whoSteers(*status, session.remoteRobots().contains(robot));
  state.name = QString::fromStdString(status->who());
  if (state.who == Who::kOther && status->client() == 0)
    state.name = SteeringText::tr("A user at the robot's own computer");
  state.isSilent = status->silent();
  state.text = sentenceFor(state, QString::fromStdString(robot));
  state.details = QString::fromStdString(status->text());
  return state;
}

}  // namespace widgets
