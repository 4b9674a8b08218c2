// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/WorldDrawings.h"

#include <algorithm>

#include "foxglove/Scene.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/TypedStreams.h"
#include "widgets/drawings/CurrentDrawings.h"
#include "widgets/drawings/DrawingsModel.h"
#include "widgets/world/SceneState.h"
#include "widgets/world/StreamFigures.h"

namespace widgets {
namespace {

using robotlink::Pose3;

/// `robot` is the one whose frame it is, empty if it is named by a stream without a robot.
std::optional<Pose3> poseOfFrame(const std::string& robot, const std::string& frame, const SceneState& scene,
                                 const std::vector<RobotBelief>& beliefs) {
  const auto belief = std::ranges::find(beliefs, frame.substr(0, frame.find('/')), &RobotBelief::robot);
  const auto pose = scene.framePose(frame, robot);
  const bool isPlaced = belief != beliefs.end() && belief->isPlaced;
  if (pose && !isPlaced) return pose;
  if (belief == beliefs.end() || !belief->drawingPose()) return std::nullopt;
  const Pose3 place = poseOnGround(*belief->drawingPose());
  // Height, tilt and the places of parts stay as they are at the true pose.
  const auto truth = scene.framePose(belief->robot);
  if (pose && truth) return Pose3(place * poseOnGround(robotlink::groundPose(*truth)).inverse() * *pose);
  return belief->robot == frame ? std::optional(place) : std::nullopt;
}

}  // namespace

Pose3 poseOnGround(const robotlink::Pose2& pose) {
  Pose3 result = Pose3::Identity();
  result.translate(robotlink::Vector3(pose.x, pose.y, 0));
  result.rotate(Eigen::AngleAxisd(pose.heading, robotlink::Vector3::UnitZ()));
  return result;
}

std::vector<WorldDrawing> worldDrawings(robotlink::Session& session, const SceneState& scene,
                                        StreamFigures& figures, const std::vector<RobotBelief>& beliefs,
                                        const std::vector<std::string>& robots, const QStringList& ids,
                                        robotlink::Instant shown) {
  std::vector<WorldDrawing> drawings;
  for (const std::string& robot : robots) {
    for (const CurrentDrawing& current : currentDrawings(session, robot, ids, shown)) {
      const auto* update = dynamic_cast<const foxglove::SceneUpdate*>(current.message.get());
      if (update == nullptr) continue;
      for (const auto& entity : update->entities()) {
        const auto pose = poseOfFrame(robot.substr(0, robot.find('/')), entity.frame_id(), scene, beliefs);
        if (pose) drawings.push_back({&entity, *pose, current.message, current.old, current.id, robot});
      }
    }
  }
  const QLatin1String folder(DrawingsModel::kStreams);
  for (const QString& id : ids) {
    if (!id.startsWith(folder)) continue;
    const std::string path = id.mid(folder.size()).toStdString();
    for (const auto& figure : figures.of(session.store(), path, shown)) {
      if (const auto pose =
              poseOfFrame(robotlink::streams::robotOf(path), figure.entity->frame_id(), scene, beliefs))
        drawings.push_back({figure.entity, *pose, figure.keep, false, id, {}});
    }
  }
  return drawings;
}

}  // namespace widgets
