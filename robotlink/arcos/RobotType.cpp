// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/RobotType.h"

namespace robotlink::arcos {
namespace {

/// Sixteen sonars in two arrays: 0 to 7 point forwards, from left to right, 8 to 15 backwards, from right to
/// left.
std::vector<Pose2> sonarsOfP3at() {
  return {{0.147, 0.136, radians(90)},     {0.193, 0.119, radians(50)},     {0.227, 0.079, radians(30)},
          {0.245, 0.027, radians(10)},     {0.245, -0.027, radians(-10)},   {0.227, -0.079, radians(-30)},
          {0.193, -0.119, radians(-50)},   {0.147, -0.136, radians(-90)},   {-0.144, -0.136, radians(-90)},
          {-0.189, -0.119, radians(-130)}, {-0.223, -0.079, radians(-150)}, {-0.241, -0.027, radians(-170)},
          {-0.241, 0.027, radians(170)},   {-0.223, 0.079, radians(150)},   {-0.189, 0.119, radians(130)},
          {-0.144, 0.136, radians(90)}};
}

}  // namespace

RobotType robotType(const std::string& subclass) {
  RobotType type;
  type.subclass = subclass;
  type.sonarsInRobot = sonarsOfP3at();
  // Robots with an older controller.
  if (subclass == "p3at") type.distance = 0.000465;
  return type;
}

}  // namespace robotlink::arcos
