// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/RobotBeliefs.h"

#include <algorithm>
#include <charconv>

#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/RobotTeams.h"
#include "robotlink/session/Session.h"
#include "widgets/drawings/DrawingPose.h"
#include "widgets/world/SceneState.h"

namespace widgets {
namespace {

void addEstimates(RobotBelief& belief, const robotlink::StreamStore& store, robotlink::Instant shown) {
  const auto* pose =
      store.latestAs<robotcontrol::RobotPose>(belief.robot + "/" + robotlink::kRobotPose.name, shown);
  if (pose != nullptr) {
    belief.estimate = robotlink::pose2(pose->robot_in_field());
    belief.positionDeviation = pose->position_deviation();
    belief.headingDeviation = pose->heading_deviation();
  }
  const auto* ball =
      store.latestAs<robotcontrol::BallModel>(belief.robot + "/" + robotlink::kBallModel.name, shown);
  const auto from = belief.estimate ? belief.estimate : belief.truth;
  if (ball != nullptr && ball->known() && from) {
    belief.ball = *from * robotlink::vector2(ball->position_in_robot());
    belief.ballDeviation = ball->standard_deviation();
  }
}

QColor colorByNumber(const std::string& robot) {
  // None of these colors can be mistaken for a team's.
  static constexpr QRgb kColors[] = {0xffe39a16, 0xff17a2a4, 0xff2e9e4f, 0xff8e4fc6,
                                     0xffc7448f, 0xff8a6b3d, 0xff97a82a, 0xff5f7186};
  const std::size_t digits = robot.find_last_not_of("0123456789") + 1;
  unsigned number = 0;
  const auto read = std::from_chars(robot.data() + digits, robot.data() + robot.size(), number);
  if (read.ec != std::errc() || number == 0) return {128, 128, 128};
  return QColor(kColors[(number - 1) % std::size(kColors)]);
}

}  // namespace

QColor teamColor(const std::string& robot, const std::optional<std::string>& team,
                 const robotlink::FieldDescription* field) {
  QColor color = colorByNumber(robot);
  std::size_t longest = 0;
  if (field == nullptr) return color;
  for (const auto& entry : field->palette) {
    if (team ? *team != entry.name : !robot.starts_with(entry.name) || entry.name.size() <= longest) continue;
    longest = entry.name.size();
    color = QColor(entry.rgb.r, entry.rgb.g, entry.rgb.b);
  }
  return color;
}

std::vector<RobotBelief> robotBeliefs(robotlink::Session& session, const SceneState& scene,
                                      const robotlink::FieldDescription* field, robotlink::Instant shown) {
  std::vector<RobotBelief> beliefs;
  for (const std::string& robot : session.robots()) {
    RobotBelief belief;
    belief.robot = robot;
    belief.team = teamColor(robot, robotlink::teamOf(session.store(), robot, shown), field);
    belief.selected = robot == session.selectedRobot();
    if (const auto truth = scene.framePose(robot)) belief.truth = robotlink::groundPose(*truth);
    addEstimates(belief, session.store(), shown);
    beliefs.push_back(std::move(belief));
  }
  return beliefs;
}

void placeDrawings(std::vector<RobotBelief>& beliefs, const robotlink::StreamStore& store,
                   const std::string& choice, robotlink::Instant shown) {
  if (choice == kUsualPose) return;
  for (RobotBelief& belief : beliefs) {
    belief.isPlaced = true;
    if (choice == kTruePose) {
      belief.place = belief.truth;
      continue;
    }
    const auto* pose = store.latestAs<robotcontrol::RobotPose>(belief.robot + '/' + choice, shown);
    if (pose != nullptr) belief.place = robotlink::pose2(pose->robot_in_field());
  }
}

}  // namespace widgets
