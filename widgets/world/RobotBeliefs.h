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
class StreamStore;
struct FieldDescription;
}  // namespace robotlink

namespace widgets {

class SceneState;

/// A robot's true pose, its pose estimate, and its estimate of the ball, all in the field's frame; meters and
/// radians. A plain value.
struct RobotBelief {
  std::string robot;
  /// See teamColor().
  QColor team;
  /// Whether it is the session's selected robot.
  bool selected = false;
  /// Length and width in m of a robot on wheels, set by the view from the robot's description; zero: a
  /// four-legged robot.
  robotlink::Vector2 body = robotlink::Vector2::Zero();
  /// Its base has sent nothing for a while: it may be elsewhere by now, and is shown in gray.
  bool silent = false;
  std::optional<robotlink::Pose2> truth;  ///< known of simulated robots only
  std::optional<robotlink::Pose2> estimate;
  /// Standard deviation of the estimate, m.
  double positionDeviation = 0;
  /// Standard deviation of the estimate, rad.
  double headingDeviation = 0;
  /// Its estimate of the ball's position; unset if the robot does not know.
  std::optional<robotlink::Vector2> ball;
  /// Standard deviation of the ball's position, m.
  double ballDeviation = 0;

  /// Whether the user chose the pose at which its drawings are placed, and that pose; unset: unknown. See
  /// placeDrawings().
  bool isPlaced = false;
  std::optional<robotlink::Pose2> place;

  bool operator==(const RobotBelief&) const = default;
  /// The robot's pose: the true one if known, else the estimate.
  std::optional<robotlink::Pose2> pose() const { return truth ? truth : estimate; }
  /// The pose at which its own drawings are placed; unset: none.
  std::optional<robotlink::Pose2> drawingPose() const { return isPlaced ? place : pose(); }
};

/// All robots of the session at an instant. `field` may be null.
std::vector<RobotBelief> robotBeliefs(robotlink::Session& session, const SceneState& scene,
                                      const robotlink::FieldDescription* field, robotlink::Instant shown);
/// Sets where the robots' own drawings are placed, by one of the choices in DrawingPose.h.
void placeDrawings(std::vector<RobotBelief>& beliefs, const robotlink::StreamStore& store,
                   const std::string& choice, robotlink::Instant shown);
/// The color of a robot's team from the field's palette. If the team is not known, it is the one with whose
/// name that of the robot begins ("red1"). Robots without a team ("p3at2") have colors by their number, or
/// gray without one. `field` may be null.
QColor teamColor(const std::string& robot, const std::optional<std::string>& team,
                 const robotlink::FieldDescription* field);

}  // namespace widgets
