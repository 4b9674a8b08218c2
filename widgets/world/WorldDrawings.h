// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/process/Link.h"
#include "widgets/world/RobotBeliefs.h"

namespace foxglove {
class SceneEntity;
}
namespace robotlink {
class Session;
}

namespace widgets {

class SceneState;
class StreamFigures;

/// A drawing in the world, and the frame of its coordinates.
struct WorldDrawing {
  const foxglove::SceneEntity* entity = nullptr;
  /// Pose of the drawing's frame; meters.
  robotlink::Pose3 frameInField = robotlink::Pose3::Identity();
  /// The message that owns `entity`.
  robotlink::PackagePtr keep;
  /// See CurrentDrawing::old.
  bool old = false;
  /// Its name and whose it is, as CurrentDrawing has them; figures of streams have no robot.
  QString id = {};
  std::string robot = {};
};

/// The inverse of robotlink::groundPose() for poses that are upright on the ground.
robotlink::Pose3 poseOnGround(const robotlink::Pose2& pose);

/// The current drawings of `robots` among `ids` ("field/...", "robot/..."), lowest first; then the figures of
/// the streams among `ids` ("stream/PATH"). Drawings relative
/// to a robot are placed at RobotBelief::drawingPose(); without one they are left out.
std::vector<WorldDrawing> worldDrawings(robotlink::Session& session, const SceneState& scene,
                                        StreamFigures& figures, const std::vector<RobotBelief>& beliefs,
                                        const std::vector<std::string>& robots, const QStringList& ids,
                                        robotlink::Instant shown);

}  // namespace widgets
