// SPDX-License-Identifier: GPL-3.0-or-later
// Classifies positions of the ball and robots on a field for the referee (out, in a penalty area, ...).
// Meters, in the field's frame.
#pragma once

#include "robotlink/base/Geometry.h"

namespace robotlink {
struct FieldDescription;
}

namespace app {

/// The side of the goal that the whole ball is in: 1 at +x, -1 at -x; 0: in none.
int goalWithBall(const robotlink::FieldDescription& field, const robotlink::Vector3& ball);
/// Whether the ball is on the field; on walls it still is.
bool isBallOnField(const robotlink::FieldDescription& field, const robotlink::Vector3& ball);
/// Whether a robot is on the field, in one of its goals, or less than `margin` outside.
bool isRobotOnField(const robotlink::FieldDescription& field, const robotlink::Vector2& robot, double margin);
/// Whether a point is in the penalty area at that side, -1 or 1.
bool isInPenaltyArea(const robotlink::FieldDescription& field, const robotlink::Vector2& point, int side);
/// The nearest point that is at least `inset` inside of the lines.
robotlink::Vector2 nearestInside(const robotlink::FieldDescription& field, const robotlink::Vector2& point,
                                 double inset);

}  // namespace app
