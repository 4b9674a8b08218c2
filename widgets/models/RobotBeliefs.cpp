// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/RobotBeliefs.h"

#include "robotcontrol/Modeling.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/models/SceneState.h"

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

}  // namespace

QColor teamColor(const std::string& robot, const robotlink::FieldDescription* field) {
  QColor color(128, 128, 128);
  std::size_t longest = 0;
  if (field == nullptr) return color;
  for (const auto& entry : field->palette) {
    if (!robot.starts_with(entry.name) || entry.name.size() <= longest) continue;
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
    belief.team = teamColor(robot, field);
    belief.selected = robot == session.selectedRobot();
    if (const auto truth = scene.framePose(robot)) belief.truth = robotlink::groundPose(*truth);
    addEstimates(belief, session.store(), shown);
    beliefs.push_back(std::move(belief));
  }
  return beliefs;
}

}  // namespace widgets
