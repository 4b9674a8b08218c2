// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/errors/ErrorFormula.h"

#include "robotlink/packages/GamePackages.h"
#include "robotlink/packages/Packages.h"

namespace widgets {
namespace {

/// The distance in mm of two places whose coordinates are these.
std::string distanceOf(const std::string& x, const std::string& trueX, const std::string& y,
                       const std::string& trueY) {
  return "1000 * sqrt((" + x + " - " + trueX + ")^2 + (" + y + " - " + trueY + ")^2)";
}

}  // namespace

std::string errorFormula(const std::string& robot, const std::string& path, const std::string& package,
                         const std::string& quantity) {
  const std::string stream = robot + '/' + path;
  const std::string truth = robot + '/' + robotlink::kOracleWorld.name;
  const std::string pose = stream + ".robot_in_field", truePose = truth + ".robot_in_field";
  const std::string trueBall = truth + ".ball_in_field";
  if (package == robotlink::kRobotPose.name && quantity == "position")
    return distanceOf(pose + ".x", truePose + ".x", pose + ".y", truePose + ".y");
  if (package == robotlink::kRobotPose.name && quantity == "heading")
    return "180 / pi * acos(cos(" + pose + ".heading - " + truePose + ".heading))";
  if (quantity != "position") return {};
  if (package == robotlink::kTeamBall.name) {
    const std::string ball = stream + ".position_in_field";
    return distanceOf(ball + ".x", trueBall + ".x", ball + ".y", trueBall + ".y");
  }
  if (package != robotlink::kBallModel.name && package != robotlink::kBallPercept.name) return {};
  // The true pose brings the ball into the field.
  const std::string forward = stream + ".position_in_robot.x", left = stream + ".position_in_robot.y";
  const std::string sine = "sin(" + truePose + ".heading)", cosine = "cos(" + truePose + ".heading)";
  return distanceOf(
      truePose + ".x + " + cosine + " * " + forward + " - " + sine + " * " + left, trueBall + ".x",
      truePose + ".y + " + sine + " * " + forward + " + " + cosine + " * " + left, trueBall + ".y");
}

}  // namespace widgets
