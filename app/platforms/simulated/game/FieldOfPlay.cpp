// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/FieldOfPlay.h"

#include <algorithm>
#include <cmath>

#include "robotlink/config/FieldDescription.h"

namespace app {

using robotlink::FieldDescription;
using robotlink::Vector2;
using robotlink::Vector3;

int goalWithBall(const FieldDescription& field, const Vector3& ball) {
  for (const auto& goal : field.goals) {
    const int side = goal.x < 0 ? -1 : 1;
    // The whole ball must have crossed the line.
    const double beyond = side * (ball.x() - goal.x) - field.ballRadius;
    const bool inside = beyond > 0 && beyond < field.goalDepth &&
                        std::abs(ball.y()) < 0.5 * field.goalWidth && ball.z() < field.goalHeight;
    if (inside) return side;
  }
  return 0;
}

bool isBallOnField(const FieldDescription& field, const Vector3& ball) {
  const double margin = field.hasBoundary() ? field.ballRadius : field.wallThickness;
  return std::abs(ball.x()) < field.goalLineX() + margin && std::abs(ball.y()) < field.touchLineY() + margin;
}

bool isRobotOnField(const FieldDescription& field, const Vector2& robot, double margin) {
  if (std::abs(robot.y()) > field.touchLineY() + margin) return false;
  const bool isInGoal = std::abs(robot.y()) < 0.5 * field.goalWidth &&
                        std::abs(robot.x()) < field.goalLineX() + field.goalDepth;
  return isInGoal || std::abs(robot.x()) < field.goalLineX() + margin;
}

bool isInPenaltyArea(const FieldDescription& field, const Vector2& point, int side) {
  const double fromLine = field.goalLineX() - side * point.x();
  return fromLine < field.penaltyAreaLength && std::abs(point.y()) < 0.5 * field.penaltyAreaWidth;
}

Vector2 nearestInside(const FieldDescription& field, const Vector2& point, double inset) {
  const double x = std::max(0.0, field.goalLineX() - inset), y = std::max(0.0, field.touchLineY() - inset);
  return {std::clamp(point.x(), -x, x), std::clamp(point.y(), -y, y)};
}

}  // namespace app
