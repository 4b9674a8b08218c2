// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/RobotType.h"

#include <gtest/gtest.h>

namespace robotlink::arcos {
namespace {

TEST(RobotType, eachTypeHasItsSonars) {
  struct Case {
    const char* subclass;
    std::size_t sonars;
    double firstX;
  };
  for (const Case& one : {Case{"p3at-sh", 16, 0.147}, Case{"p3at", 16, 0.147}, Case{"p3dx-sh", 16, 0.069},
                          Case{"p3dx", 16, 0.069}, Case{"peoplebot-sh", 24, 0.069},
                          Case{"somethingelse", 16, 0.147}, Case{"", 16, 0.147}}) {
    const RobotType type = robotType(one.subclass);
    EXPECT_EQ(type.subclass, one.subclass);
    ASSERT_EQ(type.sonarsInRobot.size(), one.sonars) << one.subclass;
    EXPECT_DOUBLE_EQ(type.sonarsInRobot[0].x, one.firstX) << one.subclass;
  }
}

TEST(RobotType, sonarsAreMirroredAtTheLongAxis) {
  for (const char* subclass : {"p3at-sh", "p3dx-sh", "peoplebot-sh"}) {
    const auto sonars = robotType(subclass).sonarsInRobot;
    for (std::size_t first = 0; first < sonars.size(); first += 8)
      for (std::size_t i = 0; i < 4; ++i) {
        const Pose2 &left = sonars[first + i], &right = sonars[first + 7 - i];
        EXPECT_DOUBLE_EQ(left.x, right.x) << subclass << ' ' << first + i;
        EXPECT_DOUBLE_EQ(left.y, -right.y) << subclass << ' ' << first + i;
        EXPECT_DOUBLE_EQ(left.heading, -right.heading) << subclass << ' ' << first + i;
      }
  }
}

TEST(RobotType, frontSonarsLookForwardsAndThoseBehindBackwards) {
  const auto sonars = robotType("p3at-sh").sonarsInRobot;
  for (std::size_t i = 0; i < sonars.size(); ++i) {
    const bool isFront = i < 8;
    EXPECT_EQ(sonars[i].x > 0, isFront) << i;
    EXPECT_EQ(std::abs(sonars[i].heading) <= radians(90) + 1e-9,
              isFront || std::abs(sonars[i].heading) == radians(90))
        << i;
  }
}

TEST(RobotType, olderControllersCountOtherUnits) {
  EXPECT_DOUBLE_EQ(robotType("p3at").distance, 0.000465);
  EXPECT_DOUBLE_EQ(robotType("p3at-sh").distance, 0.001);
}

}  // namespace
}  // namespace robotlink::arcos
