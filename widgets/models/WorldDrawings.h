// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/process/Link.h"
#include "widgets/models/RobotBeliefs.h"

namespace foxglove {
class SceneEntity;
}
namespace robotlink {
class Session;
}

namespace widgets {

class SceneState;

/// A drawing in the world and the frame that its coordinates are in.
struct WorldDrawing {
  const foxglove::SceneEntity* entity = nullptr;
  robotlink::Pose3 frameInField = robotlink::Pose3::Identity();
  robotlink::PackagePtr keep;
  bool old = false;  ///< as CurrentDrawing says
};

/// The inverse of robotlink::groundPose() for what stands upright on the ground.
robotlink::Pose3 poseOnGround(const robotlink::Pose2& pose);

/// The current drawings of `robots` among `ids` ("field/...", "robot/..."), lowest first. Those that are
/// relative to a robot lie at its true pose or, where that is not known, at its estimated one; without either
/// they are left out.
std::vector<WorldDrawing> worldDrawings(robotlink::Session& session, const SceneState& scene,
                                        const std::vector<RobotBelief>& beliefs,
                                        const std::vector<std::string>& robots, const QStringList& ids,
                                        robotlink::Instant shown);

}  // namespace widgets
