// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {
class Session;
struct FieldDescription;
}  // namespace robotlink

namespace widgets {

class SceneState;

/// Where a robot is and where it believes that it and the ball are, in the field's frame; metres and radians.
struct RobotBelief {
  std::string robot;
  QColor team;
  bool selected = false;
  /// Length and width in metres of a robot on wheels; zero: it is a four-legged one.
  robotlink::Vector2 body = robotlink::Vector2::Zero();
  /// Its base has not been heard for a while: it may be elsewhere by now, and is shown in gray.
  bool silent = false;
  std::optional<robotlink::Pose2> truth;  ///< known of simulated robots only
  std::optional<robotlink::Pose2> estimate;
  double positionDeviation = 0;
  double headingDeviation = 0;
  std::optional<robotlink::Vector2> ball;  ///< its estimate; unset if it does not know
  double ballDeviation = 0;

  bool operator==(const RobotBelief&) const = default;
  /// Where its own drawings belong: at the true pose, else at the estimated one.
  std::optional<robotlink::Pose2> pose() const { return truth ? truth : estimate; }
};

/// All robots of the session at an instant.
std::vector<RobotBelief> robotBeliefs(robotlink::Session& session, const SceneState& scene,
                                      const robotlink::FieldDescription* field, robotlink::Instant shown);
/// The colour of a robot's team, which its name begins with ("red1"): that of the field's palette. Robots of
/// no team ("p3at2") differ by their numbers; without one they are grey.
QColor teamColor(const std::string& robot, const robotlink::FieldDescription* field);

}  // namespace widgets
